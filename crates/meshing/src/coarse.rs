//! A mesh before it is graded, and the grading.

use hpfem::Mesh;
use scene::Fault;

/// Ratio of the sizes of successive layers. Of 0.1, 0.15, 0.25 the last reached a given error of the drum gap with the least work
/// in degrees 6 to 12.
pub const RATIO: f64 = 0.25;

/// A coarse mesh and the points towards which it is to be graded.
#[derive(Debug)]
pub(crate) struct Coarse {
    pub mesh: Mesh,
    pub singular: Vec<[f64; 2]>,
    /// How far the body reaches beyond the left and right of its mesh (mm): less than a cell, added once cells there are as small.
    pub ledges: [f64; 2],
    /// Ends of contact, where the pressure goes like a square root: half as many layers do.
    pub free: Vec<[f64; 2]>,
}

/// The fault of a geometry whose cells are folded or too thin.
pub(crate) fn degenerate(key: &str, error: &hpfem::Error) -> Fault {
    Fault::at(key, "degenerate", error.to_string(), "make the body less thin or less distorted")
}
