//! What can be wrong with a contact problem.

/// Wrong input, with the numbers that show it.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum Error {
    /// The two boundaries do not share their break points.
    #[error("the contact boundaries differ at edge {edge} by {distance:.3e}; mesh both with the same break points")]
    Unmatched {
        /// Number of the edge along the path.
        edge: usize,
        /// Distance of points that should coincide.
        distance: f64,
    },
}
