//! What a study came to: ladders, and seconds of both at equal error.

use super::case::Study;
use super::front::Point;
use serde_json::Value;

/// One ladder with its errors.
pub(crate) struct Ladder {
    pub(crate) name: String,
    pub(crate) ours: bool,
    pub(crate) points: Vec<Point>,
}

/// A finished study.
pub(crate) struct Outcome {
    pub(crate) study: Study,
    pub(crate) ladders: Vec<Ladder>,
    /// Sentences about the truth: against digits of others, and its own estimate.
    pub(crate) truth: Vec<String>,
    pub(crate) factors: Vec<Factor>,
    pub(crate) versions: Value,
    /// Largest ratio of wall clock to processor time among the levels of dolfinx.
    pub(crate) waited: f64,
    /// Whether the truth agrees with known digits, and every factor is reached.
    pub(crate) passed: bool,
}

/// Seconds of both at one error.
pub(crate) struct Factor {
    pub(crate) error: f64,
    pub(crate) ours: Option<f64>,
    pub(crate) theirs: Option<f64>,
    /// The factor that must be reached.
    pub(crate) least: Option<f64>,
}

impl Factor {
    /// How many times longer dolfinx takes.
    pub(crate) fn value(&self) -> Option<f64> {
        Some(self.theirs? / self.ours?)
    }

    /// Below the factor that must be reached, or without a factor.
    pub(crate) fn missed(&self) -> bool {
        self.least.is_some_and(|least| self.value().is_none_or(|value| value < least))
    }
}
