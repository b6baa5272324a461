//! A point of the contact surface.

/// A point of the contact surface.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct ContactPoint {
    /// Edge of both paths and parameter on it.
    pub place: (usize, f64),
    /// Arc length from the start of the path.
    pub arc: f64,
    /// Position.
    pub position: [f64; 2],
    /// Unit normal out of body 2 into body 1.
    pub normal: [f64; 2],
    /// Unit tangent: the normal turned clockwise, along growing x where the normal points up.
    pub tangent: [f64; 2],
    /// Area of the surface that belongs to the point.
    pub weight: f64,
}

/// `a - b`.
pub(crate) fn difference(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    [a[0] - b[0], a[1] - b[1]]
}

/// Part of `v` along a unit direction.
pub(crate) fn along(direction: [f64; 2], v: [f64; 2]) -> f64 {
    direction[0] * v[0] + direction[1] * v[1]
}
