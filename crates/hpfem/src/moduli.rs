//! The stress-strain law of one kinematics.

use crate::kinematics::Kinematics;

/// Moduli of one kinematics.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Moduli {
    /// `sigma_11 = c11 e1 + c12 (e2 + e3)` and so on, `tau = shear * gamma`.
    Isotropic {
        /// Diagonal modulus, MPa.
        c11: f64,
        /// Coupling modulus, MPa.
        c12: f64,
        /// Shear modulus `E / (2 (1 + nu))`, MPa.
        shear: f64,
    },
    /// From the strains `[xx, zz, yy, gamma_xz]` to the stresses `[xx, zz, yy, xz]`, MPa; in plane stress the row and the column of yy are zero.
    General {
        /// The symmetric matrix.
        stiffness: [[f64; 4]; 4],
    },
    /// From the two strains of torsion to their stresses, or from a potential's gradient to minus its flux.
    Scalar {
        /// The symmetric matrix.
        matrix: [[f64; 2]; 2],
    },
}

impl Moduli {
    /// The moduli with the strain out of the plane eliminated, where there is no stress.
    pub(crate) fn in_plane(self, kinematics: Kinematics) -> Moduli {
        let (Moduli::General { stiffness: c }, Kinematics::PlaneStress { .. }) = (self, kinematics) else {
            return self;
        };
        let reduced = |i: usize, j: usize| if i == 2 || j == 2 { 0.0 } else { c[i][j] - c[i][2] * c[2][j] / c[2][2] };
        Moduli::General { stiffness: std::array::from_fn(|i| std::array::from_fn(|j| reduced(i, j))) }
    }

    /// Stresses `[xx, zz, xz, yy]` of the strains `[xx, zz, gamma_xz, yy]`, the order of [`PointState::stress`](crate::PointState::stress);
    /// of a scalar law, those of its two strains first.
    pub fn stress(&self, e: [f64; 4], kinematics: Kinematics) -> [f64; 4] {
        match self {
            Moduli::Isotropic { shear, .. } if kinematics == Kinematics::Torsion => [shear * e[0], shear * e[1], 0.0, 0.0],
            Moduli::Isotropic { c11, c12, shear } => {
                let in_plane = matches!(kinematics, Kinematics::PlaneStress { .. });
                let [xx, zz, xz, yy] = if in_plane { [e[0], e[1], e[2], 0.0] } else { e };
                let out = if in_plane { 0.0 } else { c11 * yy + c12 * (xx + zz) };
                [c11 * xx + c12 * (zz + yy), c11 * zz + c12 * (xx + yy), shear * xz, out]
            }
            Moduli::General { stiffness: c } => {
                let e = [e[0], e[1], e[3], e[2]];
                let [xx, zz, yy, xz] = c.map(|row| row.iter().zip(e).map(|(c, e)| c * e).sum::<f64>());
                [xx, zz, xz, yy]
            }
            Moduli::Scalar { matrix: [[a, b], [c, d]] } => [a * e[0] + b * e[1], c * e[0] + d * e[1], 0.0, 0.0],
        }
    }
}

/// The inverse of a symmetric matrix, symmetric to the bit; none unless it is positive definite.
pub(crate) fn inverted(m: &[[f64; 4]; 4]) -> Option<[[f64; 4]; 4]> {
    let matrix = nalgebra::Matrix4::from_fn(|i, j| m[i][j]);
    let inverse = matrix.cholesky()?.inverse();
    let finite = inverse.iter().all(|v| v.is_finite());
    finite.then(|| std::array::from_fn(|i| std::array::from_fn(|j| inverse[(i.min(j), i.max(j))])))
}

/// The product of two matrices.
pub(crate) fn times(a: &[[f64; 4]; 4], b: &[[f64; 4]; 4]) -> [[f64; 4]; 4] {
    std::array::from_fn(|i| std::array::from_fn(|j| (0..4).map(|k| a[i][k] * b[k][j]).sum()))
}

/// The transposed matrix.
pub(crate) fn transposed(a: &[[f64; 4]; 4]) -> [[f64; 4]; 4] {
    std::array::from_fn(|i| std::array::from_fn(|j| a[j][i]))
}
