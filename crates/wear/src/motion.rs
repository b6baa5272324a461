//! The sliding motion: a rigid velocity field of body 2 relative to body 1.

use nalgebra::Vector3;

/// Velocity of body 2 relative to body 1: v(x) = velocity + angular_velocity x (x - about). Covers translation, rotation about an
/// in-plane axis (drum), about the normal axis (disc), and both together.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SlidingMotion {
    /// Translation in mm/s.
    pub velocity: Vector3<f64>,
    /// Angular velocity vector in rad/s. A drum turning anti-clockwise in the picture (x right, z up, y into it) has -omega e_y.
    pub angular_velocity: Vector3<f64>,
    /// A point of the axis, in mm.
    pub about: Vector3<f64>,
}

impl SlidingMotion {
    /// Translation with `speed` towards +x.
    pub fn along_x(speed: f64) -> Self {
        Self { velocity: Vector3::new(speed, 0.0, 0.0), angular_velocity: Vector3::zeros(), about: Vector3::zeros() }
    }

    /// Rotation with `omega` (rad/s) about the z axis through the origin: disc and annulus.
    pub fn about_z(omega: f64) -> Self {
        Self { velocity: Vector3::zeros(), angular_velocity: Vector3::new(0.0, 0.0, omega), about: Vector3::zeros() }
    }

    /// Rotation with `omega` (rad/s, anti-clockwise positive with x to the right and z up) about the y direction through `centre`.
    pub fn in_plane(omega: f64, centre: Vector3<f64>) -> Self {
        Self { velocity: Vector3::zeros(), angular_velocity: Vector3::new(0.0, -omega, 0.0), about: centre }
    }

    /// Sliding speed (mm/s) and drag direction tau (unit tangent along which body 2 drags body 1, zero where the speed is zero).
    pub fn sliding(&self, position: &Vector3<f64>, normal: &Vector3<f64>) -> (f64, Vector3<f64>) {
        let velocity = self.velocity + self.angular_velocity.cross(&(position - self.about));
        let tangential = velocity - normal * velocity.dot(normal);
        let speed = tangential.norm();
        if speed > 0.0 { (speed, tangential / speed) } else { (0.0, Vector3::zeros()) }
    }
}
