//! What the two coordinates of a mesh mean.

use std::f64::consts::TAU;

/// What the two coordinates mean and which strains there are.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
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
    /// A scalar potential in the plane (temperature, pressure of a porous flow, warping), coordinates (x, z):
    /// `int grad v . k grad u dV = int f v dV + int q v dA`. The "displacement" is the potential, the "traction" the flux into the body,
    /// the "body force" the source, a support holds the potential, and the normal stiffness of a foundation is a film coefficient.
    Potential {
        /// Thickness, mm.
        thickness: f64,
    },
    /// The same in a body of revolution, coordinates (r, z); integrals go over the full turn.
    AxisymmetricPotential,
}

impl Kinematics {
    /// Number of displacement components.
    pub fn components(self) -> usize {
        match self {
            Kinematics::PlaneStress { .. } | Kinematics::PlaneStrain { .. } | Kinematics::Axisymmetric => 2,
            Kinematics::Torsion | Kinematics::Potential { .. } | Kinematics::AxisymmetricPotential => 1,
        }
    }

    /// Measure of a unit area of the (x, z) plane at first coordinate `r`, mm^3 per mm^2: the thickness, or `2 pi r`.
    pub fn measure(self, r: f64) -> f64 {
        match self.thickness() {
            Some(thickness) => thickness,
            None => TAU * r,
        }
    }

    /// Thickness of a plane body, mm; none in a body of revolution.
    pub fn thickness(self) -> Option<f64> {
        match self {
            Kinematics::PlaneStress { thickness } | Kinematics::PlaneStrain { thickness } => Some(thickness),
            Kinematics::Potential { thickness } => Some(thickness),
            Kinematics::Axisymmetric | Kinematics::Torsion | Kinematics::AxisymmetricPotential => None,
        }
    }

    /// Whether the first coordinate is a radius.
    pub fn is_revolved(self) -> bool {
        self.thickness().is_none()
    }

    /// The kinematics in words.
    pub(crate) fn words(self) -> &'static str {
        match self {
            Kinematics::PlaneStress { .. } => "plane stress",
            Kinematics::PlaneStrain { .. } => "plane strain",
            Kinematics::Axisymmetric => "a body of revolution",
            Kinematics::Torsion => "torsion",
            Kinematics::Potential { .. } => "the problem of a potential",
            Kinematics::AxisymmetricPotential => "the problem of a potential in a body of revolution",
        }
    }

    /// Whether the unknown is a scalar potential.
    pub fn is_conduction(self) -> bool {
        matches!(self, Kinematics::Potential { .. } | Kinematics::AxisymmetricPotential)
    }

    /// Whether this is how heat is conducted in bodies of another kinematics, which thermal strains bend.
    pub(crate) fn conducts_in(self, body: Kinematics) -> bool {
        match self {
            Kinematics::Potential { .. } => matches!(body, Kinematics::PlaneStress { .. } | Kinematics::PlaneStrain { .. }),
            Kinematics::AxisymmetricPotential => body == Kinematics::Axisymmetric,
            Kinematics::PlaneStress { .. } | Kinematics::PlaneStrain { .. } | Kinematics::Axisymmetric | Kinematics::Torsion => {
                false
            }
        }
    }

    /// Whether the first component is itself part of a strain, divided by the radius.
    pub(crate) fn has_hoop_strain(self) -> bool {
        matches!(self, Kinematics::Axisymmetric | Kinematics::Torsion)
    }
}
