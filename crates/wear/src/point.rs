//! A point of the contact surface.

use nalgebra::Vector3;

/// A point of the contact surface with all a wear rule needs. `y` is the out-of-plane direction of plane scenes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SurfacePoint {
    /// Position in mm.
    pub position: Vector3<f64>,
    /// Unit normal out of body 2 into body 1.
    pub normal: Vector3<f64>,
    /// Area weight in mm^2: sums of weight f approximate int f dS.
    pub weight: f64,
    /// Sliding speed in mm/s, >= 0.
    pub sliding_speed: f64,
    /// Unit tangent along which body 2 drags body 1 (traction on body 1 is p n + mu p drag); zero where the speed is zero.
    pub drag: Vector3<f64>,
}
