//! Names of boundaries that no scene can have, and the grading.

/// Name of the edges on the contact surface.
pub const CONTACT: &str = "@contact";
/// Name of the loaded edges.
pub const LOAD: &str = "@load";
/// Name of the edges on the axis of revolution or a plane of symmetry.
pub const AXIS: &str = "@axis";

/// Ratio of the sizes of successive layers. Of 0.1, 0.15, 0.25 the last reached a given error of the drum gap with the least work
/// in degrees 6 to 12.
pub const RATIO: f64 = 0.25;

/// Share of the contact below which two points of it are meant to be one: a mesh file has fewer digits than its geometry.
pub(crate) const SAME: f64 = 1e-6;
