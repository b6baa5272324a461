//! Names of boundaries that no scene can have, since its own do not begin with @.

/// The edges on the contact surface.
pub const CONTACT: &str = "@contact";
/// The loaded edges of body 1.
pub const LOAD: &str = "@load";
/// The edges on the axis of revolution, or on a plane of symmetry where half of the bodies is meshed.
pub const AXIS: &str = "@axis";
