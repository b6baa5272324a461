//! How long the next step is.

use crate::evolution::Evolution;
use crate::tableau::Tableau;
use crate::wear_state::WearState;

/// Largest growth of the step from one to the next.
pub(super) const GROWTH: f64 = 8.0;
/// Power of the step with which the error falls across a kink of the rates.
const KINK: f64 = 2.0;
/// Part of the step that its error would allow, and the least part that is tried next.
const SAFETY: f64 = 0.9;
const LEAST: f64 = 0.1;

impl Evolution<'_> {
    /// Factor on a step by its error, of errors that add up to an accuracy: `0.9 (tolerance / error)^(1 / power)`. Below 0.9 the step is rejected.
    pub(super) fn factor(&self, state: &WearState, accuracy: f64, (step, error): (f64, f64), failures: usize) -> f64 {
        let tableau = Tableau::of(self.problem.scheme);
        let (power, tolerance) = tableau.map_or((1.0, accuracy), |t| (t.power, t.tolerance(accuracy)));
        let ratio = tolerance / error.max(f64::MIN_POSITIVE);
        // Where points enter or leave, rates have kinks and the order is lost.
        let power = if failures > 0 { KINK } else { power };
        let growth = if failures > 0 { 1.0 } else { GROWTH };
        let factor = (SAFETY * ratio.powf(1.0 / power)).clamp(LEAST, growth);
        self.where_points_enter(state, (step, error), (ratio, power), factor)
    }
}
