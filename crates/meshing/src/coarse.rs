//! A mesh before it is graded.

use hpfem::Mesh;

/// A coarse mesh and the points towards which it is to be graded.
pub(crate) struct Coarse {
    pub mesh: Mesh,
    pub singular: Vec<[f64; 2]>,
    /// Ends of contact, where the pressure goes like a square root: half as many layers do.
    pub free: Vec<[f64; 2]>,
}
