//! The line or circle that a contact edge lies on.

/// Where a contact edge lies.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum ContactLine {
    /// On a horizontal line.
    Line {
        /// Height (mm).
        z: f64,
        /// From and to (mm).
        x: [f64; 2],
    },
    /// On a circle.
    Circle {
        /// Centre [x, z] (mm).
        centre: [f64; 2],
        /// Radius (mm).
        radius: f64,
        /// From and to (rad), from the z axis towards +x.
        angles: [f64; 2],
        /// Whether body 1 lies inside the circle, and body 2 outside.
        internal: bool,
    },
}
