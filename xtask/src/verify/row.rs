//! What a comparison of one quantity came to.

use super::case::Norm;

/// One compared quantity.
pub(crate) struct Row {
    pub(crate) quantity: String,
    pub(crate) points: usize,
    /// Largest value of ours: what the differences are relative to.
    pub(crate) scale: f64,
    pub(crate) difference: f64,
    pub(crate) tolerance: f64,
    /// Difference between the two levels of the reference, relative.
    pub(crate) self_error: f64,
    pub(crate) norm: Norm,
    /// Arc length of the points, our values, the reference's with the rigid motion taken out.
    pub(crate) at: Vec<f64>,
    pub(crate) ours: Vec<f64>,
    pub(crate) theirs: Vec<f64>,
}

impl Row {
    /// Within the tolerance, and the reference is at least that sure of itself.
    pub(crate) fn passed(&self) -> bool {
        self.difference <= self.tolerance && self.self_error <= self.tolerance
    }

    /// Difference in units of the tolerance.
    pub(crate) fn excess(&self) -> f64 {
        self.difference / self.tolerance
    }

    /// In a word, or why not.
    pub(crate) fn verdict(&self) -> &'static str {
        if self.difference > self.tolerance {
            "FAILED"
        } else if self.self_error > self.tolerance {
            "FAILED (the reference is not that sure of itself)"
        } else {
            "ok"
        }
    }
}
