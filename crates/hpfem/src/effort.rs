//! What a reduction takes.

/// Seconds since any fixed moment. This crate reads no clock of its own: who wants to know how long the parts of a reduction take hands one
/// to [`Body::timed`](crate::Body::timed) or [`Body::interface_timed`](crate::Body::interface_timed).
pub type Clock = fn() -> f64;

/// The clock of those who do not ask: it stands still.
pub(crate) fn still() -> f64 {
    0.0
}

/// Sizes and times of a reduction.
#[derive(Clone, Copy, Debug, Default)]
#[non_exhaustive]
pub struct Effort {
    /// Number of cells.
    pub cells: usize,
    /// Number of unknowns of the whole body.
    pub unknowns: usize,
    /// Memory that the reduction was estimated to hold at once, see [`Sizes::bytes`](crate::Sizes::bytes); bodies are refused by this number.
    pub bytes: u64,
    /// Time to make the element matrices, condense them and prepare the loads, s by the caller's [`Clock`]; 0 without one.
    pub assemble: f64,
    /// Time to order and eliminate the skeleton, s by the caller's [`Clock`]; 0 without one.
    pub factor: f64,
}
