//! Linear isotropic elasticity in the supported kinematics.

use crate::error::Error;
use std::f64::consts::TAU;

/// What the two coordinates mean and which strains there are.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Kinematics {
    /// Plane stress: `sigma_yy = 0`; coordinates (x, z), displacement (u_x, u_z).
    PlaneStress {
        /// Thickness, mm.
        thickness: f64,
    },
    /// Plane strain: `eps_yy = 0`; coordinates (x, z), displacement (u_x, u_z).
    PlaneStrain {
        /// Thickness, mm.
        thickness: f64,
    },
    /// Axisymmetric: coordinates (r, z), displacement (u_r, u_z), hoop strain `u_r / r`; integrals go over the full turn.
    Axisymmetric,
    /// Torsion of a body of revolution: coordinates (r, z), one displacement `u_phi`, strains `u_phi,r - u_phi / r` and
    /// `u_phi,z`; integrals go over the full turn. Decoupled from [`Kinematics::Axisymmetric`] in an isotropic body.
    Torsion,
}

impl Kinematics {
    /// Number of displacement components.
    pub fn components(self) -> usize {
        match self {
            Kinematics::Torsion => 1,
            _ => 2,
        }
    }

    /// Measure of a unit area of the (x, z) plane at first coordinate `r`, mm^3 per mm^2: the thickness, or `2 pi r`.
    pub fn measure(self, r: f64) -> f64 {
        match self {
            Kinematics::PlaneStress { thickness } | Kinematics::PlaneStrain { thickness } => thickness,
            Kinematics::Axisymmetric | Kinematics::Torsion => TAU * r,
        }
    }

    /// Whether the first coordinate is a radius.
    pub fn is_revolved(self) -> bool {
        matches!(self, Kinematics::Axisymmetric | Kinematics::Torsion)
    }
}

/// Linear isotropic material.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Material {
    young: f64,
    poisson: f64,
}

/// Moduli of one kinematics: `sigma_11 = c11 e1 + c12 (e2 + e3)` and so on, `tau = shear * gamma`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Moduli {
    /// Diagonal modulus, MPa.
    pub c11: f64,
    /// Coupling modulus, MPa.
    pub c12: f64,
    /// Shear modulus `E / (2 (1 + nu))`, MPa.
    pub shear: f64,
}

impl Material {
    /// A material with Young's modulus `young > 0` (MPa) and Poisson's ratio `-1 < poisson < 0.5`.
    ///
    /// # Errors
    /// [`Error::Material`].
    pub fn new(young: f64, poisson: f64) -> Result<Material, Error> {
        let sound = young > 0.0 && young.is_finite() && poisson > -1.0 && poisson < 0.5;
        if sound { Ok(Material { young, poisson }) } else { Err(Error::Material { young, poisson }) }
    }

    /// The material with its modulus multiplied by a positive factor.
    pub(crate) fn scaled(self, factor: f64) -> Material {
        Material { young: self.young * factor, ..self }
    }

    /// Young's modulus, MPa.
    pub fn young(&self) -> f64 {
        self.young
    }

    /// Poisson's ratio, no unit.
    pub fn poisson(&self) -> f64 {
        self.poisson
    }

    /// Moduli of the stress-strain law, MPa. Plane stress: `c11 = E/(1-nu^2)`, `c12 = nu c11`; otherwise
    /// `c11 = E (1-nu) / ((1+nu)(1-2nu))`, `c12 = E nu / ((1+nu)(1-2nu))`.
    pub fn moduli(&self, kinematics: Kinematics) -> Moduli {
        let (e, nu) = (self.young, self.poisson);
        let shear = 0.5 * e / (1.0 + nu);
        let (c11, c12) = match kinematics {
            Kinematics::PlaneStress { .. } => (e / (1.0 - nu * nu), e * nu / (1.0 - nu * nu)),
            _ => {
                let c = e / ((1.0 + nu) * (1.0 - 2.0 * nu));
                (c * (1.0 - nu), c * nu)
            }
        };
        Moduli { c11, c12, shear }
    }
}
