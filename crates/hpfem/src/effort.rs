//! What a reduction takes.

use std::time::Duration;

/// Sizes and times of a reduction.
#[derive(Clone, Copy, Debug, Default)]
pub struct Effort {
    /// Number of cells.
    pub cells: usize,
    /// Number of unknowns of the whole body.
    pub unknowns: usize,
    /// Memory that the reduction was estimated to hold at once, see [`Sizes::bytes`](crate::Sizes::bytes); bodies are refused by this number.
    pub bytes: u64,
    /// Time to make the element matrices, condense them and prepare the loads.
    pub assemble: Duration,
    /// Time to order and eliminate the skeleton.
    pub factor: Duration,
}
