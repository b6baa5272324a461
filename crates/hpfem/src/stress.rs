//! The stress at a point: the whole symmetric tensor, its principal values, the equivalent stress.

use nalgebra::DMatrix;

/// Symmetric stress tensor, every component in MPa. y points out of the section; in axisymmetric bodies (x, y, z) is (r, phi, z).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Stress {
    /// Normal stress along x (or r).
    pub xx: f64,
    /// Normal stress out of the section: zero in plane stress, the hoop stress of a revolved body.
    pub yy: f64,
    /// Normal stress along z.
    pub zz: f64,
    /// Shear x y (or r phi); of torsion alone.
    pub xy: f64,
    /// Shear y z (or phi z); of torsion alone.
    pub yz: f64,
    /// Shear x z (or r z).
    pub xz: f64,
}

impl Stress {
    /// Stress of a section from [`PointState::stress`](crate::PointState::stress) `[xx, zz, xz, yy]` of its plane or axisymmetric
    /// problem and `[r phi, phi z]` of its torsion, zero without.
    pub fn new(section: [f64; 4], torsion: [f64; 2]) -> Stress {
        let [xx, zz, xz, yy] = section;
        Stress { xx, yy, zz, xy: torsion[0], yz: torsion[1], xz }
    }

    /// Equivalent stress of von Mises, MPa, `sqrt(1/2 ((xx-yy)^2 + (yy-zz)^2 + (zz-xx)^2) + 3 (xy^2 + yz^2 + xz^2))`.
    pub fn von_mises(&self) -> f64 {
        let normal = (self.xx - self.yy).powi(2) + (self.yy - self.zz).powi(2) + (self.zz - self.xx).powi(2);
        let shear = self.xy.powi(2) + self.yz.powi(2) + self.xz.powi(2);
        (0.5 * normal + 3.0 * shear).sqrt()
    }

    /// Principal stresses, MPa, the largest first. Without torsion yy is one of them and the others are
    /// `(xx + zz)/2 +- sqrt(((xx - zz)/2)^2 + xz^2)`; otherwise the eigenvalues of the tensor.
    pub fn principal(&self) -> [f64; 3] {
        let mut values = if self.xy == 0.0 && self.yz == 0.0 {
            let (middle, radius) = (0.5 * (self.xx + self.zz), (0.5 * (self.xx - self.zz)).hypot(self.xz));
            [middle + radius, middle - radius, self.yy]
        } else {
            let rows = [[self.xx, self.xy, self.xz], [self.xy, self.yy, self.yz], [self.xz, self.yz, self.zz]];
            let values = DMatrix::from_fn(3, 3, |i, j| rows[i][j]).symmetric_eigenvalues();
            [values[0], values[1], values[2]]
        };
        values.sort_unstable_by(f64::total_cmp);
        values.reverse();
        values
    }
}

#[cfg(test)]
mod tests {
    use super::Stress;
    use approx::assert_relative_eq;

    #[test]
    fn uniaxial_tension_and_pure_shear_have_their_textbook_equivalent_stress() {
        assert_eq!(Stress { zz: -7.0, ..Stress::default() }.von_mises(), 7.0);
        for shear in [Stress { xy: 2.0, ..Stress::default() }, Stress { yz: -2.0, ..Stress::default() }] {
            assert_relative_eq!(shear.von_mises(), 2.0 * 3f64.sqrt(), max_relative = 1e-15);
            let [a, b, c] = shear.principal();
            assert_relative_eq!(a, 2.0, max_relative = 1e-14);
            assert!(b.abs() < 1e-14);
            assert_relative_eq!(c, -2.0, max_relative = 1e-14);
        }
    }

    #[test]
    fn principal_stresses_keep_the_invariants_and_give_the_equivalent_stress_back() {
        let section = [31.0, -12.0, 7.5, 4.0];
        for torsion in [[0.0, 0.0], [5.0, -9.0], [1e-9, 0.0]] {
            let s = Stress::new(section, torsion);
            let [a, b, c] = s.principal();
            assert!(a >= b && b >= c);
            assert_relative_eq!(a + b + c, s.xx + s.yy + s.zz, max_relative = 1e-13);
            let second = s.xx * s.yy + s.yy * s.zz + s.zz * s.xx - s.xy * s.xy - s.yz * s.yz - s.xz * s.xz;
            assert_relative_eq!(a * b + b * c + c * a, second, max_relative = 1e-13);
            let third =
                s.xx * (s.yy * s.zz - s.yz * s.yz) - s.xy * (s.xy * s.zz - s.yz * s.xz) + s.xz * (s.xy * s.yz - s.yy * s.xz);
            assert_relative_eq!(a * b * c, third, max_relative = 1e-12);
            let from_principal = Stress { xx: a, yy: b, zz: c, ..Stress::default() };
            assert_relative_eq!(from_principal.von_mises(), s.von_mises(), max_relative = 1e-13);
        }
    }
}
