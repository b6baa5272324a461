//! What can keep a shape from being found.

/// Wrong input or a problem without an answer, with the numbers that show it.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// No rigid part of the gap is the lowest.
    #[error(
        "no rigid motion of the shaped body ({modes} free) brings the surfaces together with no overlap; load it towards the counter-face, and keep the surface off the radius through a pin"
    )]
    NoLowestGap {
        /// Number of free rigid modes.
        modes: usize,
    },
    /// Numbers of a shape problem do not fit each other.
    #[error("{what}")]
    ShapeInput {
        /// What is wrong.
        what: &'static str,
    },
    /// Numbers of a wear run do not fit each other.
    #[error("{what}")]
    WearInput {
        /// What is wrong.
        what: String,
    },
    /// The start of a wear run has no contact pressure that balances the load.
    #[error("no contact pressure balances the load on the gap at the start; check the direction of the load and the gap")]
    NoContactAtStart,
    /// No steady shape of a reversing motion was found.
    #[error(
        "no shape was found that wears steadily in both senses of sliding ({why}); press nearer the middle, or take less friction"
    )]
    NoSteadyReversal {
        /// How the search ended.
        why: String,
    },
}
