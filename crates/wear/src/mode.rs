//! Free rigid modes of body 1: closing velocity phi, force weight psi, prescribed resultant F.
//!
//! phi = -n . u is the closing velocity of the mode u, psi = phi - mu tau . u the work of the traction p (n + mu tau) in it
//! (reversed), so that the balance reads int psi p dS = F. On a plane with n = +e_z this is phi = (1, x, -y) for F0, M0^y, M0^x.

use nalgebra::Vector3;

use crate::SurfacePoint;

/// Largest number of rigid modes of one problem.
pub(crate) const MAX_MODES: usize = 6;

/// A rigid motion of body 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum RigidMotion {
    /// Translation along the direction of the applied load (unit vector; pressing down is -e_z).
    Translation {
        /// Unit direction d.
        direction: Vector3<f64>,
    },
    /// Rotation about an axis through a point; +e_y closes the +x side of a plane surface.
    Rotation {
        /// Unit axis.
        axis: Vector3<f64>,
        /// A point of the axis, mm.
        about: Vector3<f64>,
    },
    /// Uniform normal motion phi = psi = 1 (an expanding shoe); no rigid motion, but a freedom some brakes have.
    Expansion,
}

/// A free mode with the resultant the load prescribes for it: N for translations, N mm for rotations.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RigidMode {
    /// The motion.
    pub motion: RigidMotion,
    /// Prescribed resultant F = int psi p dS.
    pub resultant: f64,
}

impl RigidMode {
    /// Force `force` pressing body 1 towards -z.
    pub fn press_down(force: f64) -> Self {
        Self { motion: RigidMotion::Translation { direction: -Vector3::z() }, resultant: force }
    }

    /// Moment `moment` = int (x - about_x) p dS of the contact pressure about the y direction through `about`.
    pub fn tilt(moment: f64, about: Vector3<f64>) -> Self {
        Self { motion: RigidMotion::Rotation { axis: Vector3::y(), about }, resultant: moment }
    }

    /// Moment `moment` = int (y - about_y) p dS of the contact pressure about the x direction through `about`: phi = y - about_y.
    pub fn tilt_y(moment: f64, about: Vector3<f64>) -> Self {
        Self { motion: RigidMotion::Rotation { axis: -Vector3::x(), about }, resultant: moment }
    }
}

impl RigidMotion {
    /// Displacement of body 1's surface in the mode; zero for `Expansion`, whose closing velocity is 1 by definition.
    pub fn displacement(&self, position: &Vector3<f64>) -> Vector3<f64> {
        match self {
            Self::Translation { direction } => *direction,
            Self::Rotation { axis, about } => axis.cross(&(position - about)),
            Self::Expansion => Vector3::zeros(),
        }
    }

    /// Whether direction and axis are unit vectors, up to what decimals leave.
    pub(crate) fn is_sound(&self) -> bool {
        let unit = |v: &Vector3<f64>| (v.norm() - 1.0).abs() < 1e-4;
        match self {
            Self::Translation { direction } => unit(direction),
            Self::Rotation { axis, about } => unit(axis) && about.norm().is_finite(),
            Self::Expansion => true,
        }
    }

    /// Closing velocity phi = -n . u.
    pub fn closing(&self, point: &SurfacePoint) -> f64 {
        match self {
            Self::Expansion => 1.0,
            Self::Translation { .. } | Self::Rotation { .. } => -point.normal.dot(&self.displacement(&point.position)),
        }
    }

    /// Force weight psi = phi - mu tau . u of the balance (14), corrected for curved surfaces.
    pub fn force_weight(&self, point: &SurfacePoint, friction: f64) -> f64 {
        self.closing(point) - friction * point.drag.dot(&self.displacement(&point.position))
    }
}

/// Which side of the balance the stationary pressure is built from (they differ for mu > 0 on a curved surface).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Modes {
    /// f = sum lambda_k phi_k: compatible with the steady state; not variational where psi != phi.
    Kinematic,
    /// f = sum lambda_k psi_k: the true constrained extremum of the functional.
    Associated,
}

/// How the pressure is scaled to the load.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Balance {
    /// int psi_k p dS = F_k, friction included.
    Equilibrium,
    /// The paper's normalisation of (29)-(37): int p dS = F0, which misses the load on a curved surface.
    Paper,
}

impl RigidMode {
    /// True when the mode acts alike on all points of a ring about the z axis.
    pub(crate) fn keeps_axial_symmetry(&self) -> bool {
        match self.motion {
            RigidMotion::Translation { direction } => direction.x == 0.0 && direction.y == 0.0,
            RigidMotion::Rotation { .. } => false,
            RigidMotion::Expansion => true,
        }
    }
}
