//! Linear elastic and conducting materials: isotropic, orthotropic with a direction, or moduli in general.

use crate::error::Error;
use crate::kinematics::Kinematics;
use crate::moduli::{Moduli, inverted, times, transposed};

/// Ratios beyond this one are refused where volume changes count, see [`Material::isotropic`].
pub const MAX_POISSON: f64 = 0.49999;

/// A linear material: elastic, conducting, or both.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Material {
    elastic: Elastic,
    /// Conductivity in the plane of the mesh, `q_i = -k_ij T_,j`.
    conductivity: Option<[[f64; 2]; 2]>,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Elastic {
    /// No stiffness: a material of scalar problems alone.
    None,
    Isotropic {
        young: f64,
        poisson: f64,
    },
    /// Stiffness of `[xx, zz, yy, xz]`, and the shear moduli of `[xy, yz]`.
    General {
        stiffness: [[f64; 4]; 4],
        shear: [[f64; 2]; 2],
    },
}

/// Engineering constants of an orthotropic material in its own axes 1, 2 and 3, the third out of the plane (the hoop direction in a
/// body of revolution). Poisson's ratio `poisson_ij` is the contraction along j under a pull along i: `nu_ij / E_i = nu_ji / E_j`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Orthotropic {
    /// Young's moduli `[E_1, E_2, E_3]`, MPa.
    pub young: [f64; 3],
    /// Poisson's ratios `[nu_12, nu_13, nu_23]`, no unit.
    pub poisson: [f64; 3],
    /// Shear moduli `[G_12, G_13, G_23]`, MPa; the last two count in torsion alone.
    pub shear: [f64; 3],
}

impl Material {
    /// An isotropic material with Young's modulus `young > 0` (MPa) and Poisson's ratio `-1 < poisson < 0.5`.
    ///
    /// In plane strain and in bodies of revolution a body with a ratio above [`MAX_POISSON`] is refused: the stiffness against a change
    /// of volume is `1/(1 - 2 nu)` times that against shear, and the mean stress loses as many digits. Plane stress takes any. Anisotropic materials are refused
    /// in the same way, by the change of volume under a mean stress.
    ///
    /// # Errors
    /// [`Error::Material`].
    pub fn isotropic(young: f64, poisson: f64) -> Result<Material, Error> {
        let sound = young > 0.0 && young.is_finite() && poisson > -1.0 && poisson < 0.5;
        if !sound {
            return Err(Error::Material { young, poisson });
        }
        Ok(Material { elastic: Elastic::Isotropic { young, poisson }, conductivity: None })
    }

    /// An orthotropic material whose axis 1 lies at `angle` (radians, anti-clockwise) to the first coordinate. Constants that are
    /// those of an isotropic material make one, to the bit.
    ///
    /// The compliance in the own axes is `1/E_i` on the diagonal and `-nu_ij / E_i` beside it (Lekhnitskii 1981).
    ///
    /// # Errors
    /// [`Error::Anisotropic`] unless all moduli are positive and the compliance is positive definite.
    pub fn orthotropic(constants: Orthotropic, angle: f64) -> Result<Material, Error> {
        let Orthotropic { young: e, poisson: nu, shear: g } = constants;
        let refused = |reason: &str| Err(Error::Anisotropic { reason: reason.to_string() });
        if e.iter().chain(&g).any(|m| !(m.is_finite() && *m > 0.0)) {
            return refused("all Young's and shear moduli must be positive and finite");
        }
        if !angle.is_finite() || nu.iter().any(|v| !v.is_finite()) {
            return refused("Poisson's ratios and the direction must be finite");
        }
        let alike = |values: [f64; 3]| values.iter().all(|v| *v == values[0]);
        if alike(e) && alike(nu) && alike(g) && g[0] == 0.5 * e[0] / (1.0 + nu[0]) {
            return Material::isotropic(e[0], nu[0]);
        }
        let mut compliance = [[0.0; 4]; 4];
        for (place, modulus) in [0, 1, 2].into_iter().zip(e) {
            compliance[place][place] = 1.0 / modulus;
        }
        for ((i, j), ratio) in [(0, 1), (0, 2), (1, 2)].into_iter().zip(nu) {
            compliance[i][j] = -ratio / e[i];
            compliance[j][i] = compliance[i][j];
        }
        compliance[3][3] = 1.0 / g[0];
        let Some(stiffness) = inverted(&compliance) else {
            return refused("the compliance is not positive definite: Poisson's ratios are too large");
        };
        Material::anisotropic(stiffness, [[g[1], 0.0], [0.0, g[2]]]).and_then(|material| material.turned(angle))
    }

    /// A material by its moduli, MPa: `stiffness` takes the strains `[xx, zz, yy, gamma_xz]` to the stresses `[xx, zz, yy, xz]` (yy is
    /// out of the plane, the hoop direction in a body of revolution) and `shear` takes `[gamma_xy, gamma_yz]` to `[xy, yz]` (torsion).
    ///
    /// # Errors
    /// [`Error::Anisotropic`] unless both are symmetric and positive definite.
    pub fn anisotropic(stiffness: [[f64; 4]; 4], shear: [[f64; 2]; 2]) -> Result<Material, Error> {
        let refused = |what: &str| Error::Anisotropic { reason: format!("the {what} must be symmetric and positive definite") };
        let size = stiffness.iter().flatten().fold(0.0_f64, |m, v| m.max(v.abs()));
        let skew = (0..4).any(|i| (0..i).any(|j| (stiffness[i][j] - stiffness[j][i]).abs() > 1e-12 * size));
        if skew || inverted(&stiffness).is_none() {
            return Err(refused("stiffness"));
        }
        if !is_positive(&shear) {
            return Err(refused("shear moduli"));
        }
        Ok(Material { elastic: Elastic::General { stiffness, shear }, conductivity: None })
    }

    /// A material of scalar problems alone ([`Kinematics::Potential`]), with an isotropic conductivity `k > 0`, W/(mm K) for heat.
    ///
    /// # Errors
    /// [`Error::OutOfRange`].
    pub fn conductor(conductivity: f64) -> Result<Material, Error> {
        let none = Material { elastic: Elastic::None, conductivity: None };
        none.conducting([[conductivity, 0.0], [0.0, conductivity]])
    }

    /// The material with a conductivity matrix in the plane, symmetric and positive definite, W/(mm K) for heat: `q = -k grad T`.
    ///
    /// # Errors
    /// [`Error::OutOfRange`].
    pub fn conducting(self, conductivity: [[f64; 2]; 2]) -> Result<Material, Error> {
        if !is_positive(&conductivity) {
            let range = "a symmetric and positive definite matrix";
            return Err(Error::OutOfRange { quantity: "the conductivity".into(), value: conductivity[0][0], range });
        }
        Ok(Material { conductivity: Some(conductivity), ..self })
    }

    /// The material turned anti-clockwise by an angle, radians.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] for an angle that is not finite.
    pub fn turned(self, angle: f64) -> Result<Material, Error> {
        if !angle.is_finite() {
            return Err(Error::OutOfRange {
                quantity: "the angle that a material is turned by".into(),
                value: angle,
                range: "finite",
            });
        }
        let (s, c) = angle.sin_cos();
        Ok(self.seen_by([[c, -s], [s, c]]))
    }

    /// The material after an orthogonal map of the plane.
    pub(crate) fn seen_by(self, turn: [[f64; 2]; 2]) -> Material {
        let elastic = match self.elastic {
            Elastic::None => Elastic::None,
            isotropic @ Elastic::Isotropic { .. } => isotropic,
            Elastic::General { stiffness, shear } => {
                let t = stress_turn(turn);
                let turned = times(&times(&t, &stiffness), &transposed(&t));
                // Symmetric to the bit.
                let stiffness = std::array::from_fn(|i| std::array::from_fn(|j| turned[i.min(j)][i.max(j)]));
                Elastic::General { stiffness, shear: conjugated(&turn, &shear) }
            }
        };
        Material { elastic, conductivity: self.conductivity.map(|k| conjugated(&turn, &k)) }
    }

    /// Whether all directions of the plane are alike, for the stiffness or the conductivity that the kinematics asks for.
    pub(crate) fn is_isotropic(&self, kinematics: Kinematics) -> bool {
        match kinematics.is_conduction() {
            true => self.conductivity.is_some_and(|[[a, b], [c, d]]| a == d && b == 0.0 && c == 0.0),
            false => matches!(self.elastic, Elastic::Isotropic { .. }),
        }
    }

    /// Whether an orthogonal map of the plane leaves the moduli as they are, to round-off.
    pub(crate) fn is_alike_after(&self, turn: [[f64; 2]; 2]) -> bool {
        let numbers = |material: &Material| {
            let moduli = match &material.elastic {
                Elastic::None | Elastic::Isotropic { .. } => Vec::new(),
                Elastic::General { stiffness, shear } => [stiffness.concat(), shear.concat()].concat(),
            };
            [moduli, material.conductivity.unwrap_or_default().concat()]
        };
        let alike = |(own, other): (&Vec<f64>, &Vec<f64>)| {
            let size = own.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
            own.iter().zip(other).all(|(a, b)| (a - b).abs() <= 1e-14 * size)
        };
        numbers(self).iter().zip(&numbers(&self.seen_by(turn))).all(alike)
    }

    /// The material with its moduli multiplied by a positive factor.
    pub(crate) fn scaled(self, factor: f64) -> Material {
        let elastic = match self.elastic {
            Elastic::None => Elastic::None,
            Elastic::Isotropic { young, poisson } => Elastic::Isotropic { young: young * factor, poisson },
            Elastic::General { stiffness, shear } => Elastic::General {
                stiffness: stiffness.map(|row| row.map(|v| v * factor)),
                shear: shear.map(|row| row.map(|v| v * factor)),
            },
        };
        Material { elastic, conductivity: self.conductivity.map(|k| k.map(|row| row.map(|v| v * factor))) }
    }

    /// The size of the moduli that a kinematics asks for: Young's modulus, the largest diagonal modulus, or the conductivity.
    pub(crate) fn size(&self, kinematics: Kinematics) -> f64 {
        if kinematics.is_conduction() {
            return self.conductivity.map_or(0.0, |k| k[0][0].max(k[1][1]));
        }
        match self.elastic {
            Elastic::None => 0.0,
            Elastic::Isotropic { young, .. } => young,
            Elastic::General { stiffness, .. } => (0..4).fold(0.0, |m, i| stiffness[i][i].max(m)),
        }
    }

    /// Refuses a material that lacks what a kinematics asks for, or whose mean stress would be lost.
    pub(crate) fn check(&self, number: usize, kinematics: Kinematics) -> Result<(), Error> {
        let elastic = !kinematics.is_conduction();
        if elastic && self.elastic == Elastic::None || !elastic && self.conductivity.is_none() {
            let property = if elastic { "stiffness" } else { "conductivity" };
            return Err(Error::MaterialLacks { number, property });
        }
        let volume = match kinematics {
            Kinematics::PlaneStrain { .. } | Kinematics::Axisymmetric => true,
            Kinematics::PlaneStress { .. } | Kinematics::Torsion => false,
            Kinematics::Potential { .. } | Kinematics::AxisymmetricPotential => false,
        };
        if let Elastic::General { stiffness, .. } = &self.elastic
            && volume
            && let Some(value) = volume_compliance(stiffness).filter(|value| *value < 3.0 * (1.0 - 2.0 * MAX_POISSON))
        {
            let quantity = format!("the compliance against a change of volume, over the largest, of material {number}");
            return Err(Error::OutOfRange { quantity, value, range: "at least 6e-5, as by Poisson's ratio 0.49999" });
        }
        match self.poisson() {
            Some(value) if volume && value > MAX_POISSON => {
                let quantity = format!("Poisson's ratio of material {number}");
                Err(Error::OutOfRange { quantity, value, range: "at most 0.49999 where volume changes count" })
            }
            _ => Ok(()),
        }
    }

    /// Young's modulus, MPa; none unless isotropic.
    pub fn young(&self) -> Option<f64> {
        match self.elastic {
            Elastic::Isotropic { young, .. } => Some(young),
            Elastic::None | Elastic::General { .. } => None,
        }
    }

    /// Poisson's ratio, no unit; none unless isotropic.
    pub fn poisson(&self) -> Option<f64> {
        match self.elastic {
            Elastic::Isotropic { poisson, .. } => Some(poisson),
            Elastic::None | Elastic::General { .. } => None,
        }
    }

    /// Conductivity in the plane, if the material has one.
    pub fn conductivity(&self) -> Option<[[f64; 2]; 2]> {
        self.conductivity
    }

    /// Moduli of the stress-strain law of a kinematics, MPa. Isotropic in plane stress: `c11 = E/(1-nu^2)`, `c12 = nu c11`; otherwise
    /// `c11 = E (1-nu) / ((1+nu)(1-2nu))`, `c12 = E nu / ((1+nu)(1-2nu))`. Zero for what the material lacks.
    pub fn moduli(&self, kinematics: Kinematics) -> Moduli {
        if kinematics.is_conduction() {
            return Moduli::Scalar { matrix: self.conductivity.unwrap_or_default() };
        }
        let torsion = kinematics == Kinematics::Torsion;
        match self.elastic {
            Elastic::None => Moduli::Isotropic { c11: 0.0, c12: 0.0, shear: 0.0 },
            Elastic::General { shear, .. } if torsion => Moduli::Scalar { matrix: shear },
            Elastic::General { stiffness, .. } => Moduli::General { stiffness }.in_plane(kinematics),
            Elastic::Isotropic { young: e, poisson: nu } => {
                let shear = 0.5 * e / (1.0 + nu);
                let (c11, c12) = if matches!(kinematics, Kinematics::PlaneStress { .. }) {
                    (e / (1.0 - nu * nu), e * nu / (1.0 - nu * nu))
                } else {
                    let c = e / ((1.0 + nu) * (1.0 - 2.0 * nu));
                    (c * (1.0 - nu), c * nu)
                };
                Moduli::Isotropic { c11, c12, shear }
            }
        }
    }
}

/// Whether a matrix is symmetric and positive definite.
fn is_positive([[a, b], [c, d]]: &[[f64; 2]; 2]) -> bool {
    let finite = [a, b, c, d].iter().all(|v| v.is_finite());
    finite && (b - c).abs() <= 1e-12 * (a.abs() + d.abs()) && *a > 0.0 && *d > 0.0 && (b / a) * (c / d) < 1.0
}

/// `T M T^T`.
fn conjugated(turn: &[[f64; 2]; 2], m: &[[f64; 2]; 2]) -> [[f64; 2]; 2] {
    let sum = |i: usize, j: usize| (0..2).map(|k| (0..2).map(|l| turn[i][k] * m[k][l] * turn[j][l]).sum::<f64>()).sum();
    std::array::from_fn(|i| std::array::from_fn(|j| sum(i, j)))
}

/// What an orthogonal map of the plane makes of the stresses `[xx, zz, yy, xz]`.
fn stress_turn([[a, b], [c, d]]: [[f64; 2]; 2]) -> [[f64; 4]; 4] {
    [[a * a, b * b, 0.0, 2.0 * a * b], [c * c, d * d, 0.0, 2.0 * c * d], [0.0, 0.0, 1.0, 0.0], [a * c, b * d, 0.0, a * d + b * c]]
}
/// Change of volume under a unit of mean stress, over the largest strain that a stress in one direction makes: `3 (1 - 2 nu)` of an isotropic material.
fn volume_compliance(stiffness: &[[f64; 4]; 4]) -> Option<f64> {
    let compliance = inverted(stiffness)?;
    let volume: f64 = compliance[..3].iter().flat_map(|row| &row[..3]).sum();
    Some(volume / (0..3).fold(0.0, |most: f64, i| most.max(compliance[i][i])))
}
