//! Where a run ends.

use crate::evolution::Evolution;
use crate::evolution_status::EvolutionStatus;
use crate::wear_problem::Until;
use crate::wear_state::WearState;

/// Part of the depth or volume wanted at which a run ends.
const WORN: f64 = 1e-10;
/// Part of the wear still to come below which a contact that wears itself free has no pressure left but round-off.
const FREE: f64 = 1e-12;

impl Evolution<'_> {
    /// Status of a state just reached.
    pub(super) fn ended(&self, state: &WearState) -> EvolutionStatus {
        let last = state.interval + 1 == self.problem.schedule.len();
        match self.problem.until {
            Until::Steady { residual, not_before } if last && state.steady_residual <= residual && state.time >= not_before => {
                EvolutionStatus::Steady
            }
            Until::Time(end) if state.time >= end => EvolutionStatus::TimeReached,
            Until::Depth(_) | Until::Volume(_) if self.left(state).is_some_and(|left| left <= WORN) => EvolutionStatus::WornOff,
            Until::Steady { .. } | Until::Time(_) | Until::Depth(_) | Until::Volume(_) => EvolutionStatus::Running,
        }
    }

    /// Time at which the interval or the run ends.
    pub(super) fn limit(&self, state: &WearState) -> f64 {
        let last = state.interval + 1 == self.problem.schedule.len();
        let interval = if last { f64::INFINITY } else { state.interval_start + self.problem.schedule[state.interval].duration };
        match self.problem.until {
            Until::Time(end) => interval.min(end),
            Until::Steady { not_before, .. } if state.time < not_before => interval.min(not_before),
            Until::Steady { .. } | Until::Depth(_) | Until::Volume(_) => interval,
        }
    }

    /// Part of the wear wanted that is still to come, negative beyond it; none where the run does not end by its wear.
    pub(super) fn left(&self, state: &WearState) -> Option<f64> {
        match self.problem.until {
            Until::Depth(depth) => Some(1.0 - state.depth / depth),
            Until::Volume(volume) => Some(1.0 - (state.volume[0] + state.volume[1]) / volume),
            Until::Steady { .. } | Until::Time(_) => None,
        }
    }

    /// The state at which the wear wanted is reached within the last step, if that went beyond it.
    pub(super) fn not_beyond(&self, from: &WearState, to: WearState) -> WearState {
        let Some(beyond) = self.left(&to).filter(|left| *left < -WORN) else { return to };
        let left = |state: &WearState| self.left(state).unwrap_or(0.0);
        let found = self.crossing(from, (to.step_size, beyond), &left);
        found.map_or(to.clone(), |found| WearState { rejected: to.rejected, newton_iterations: to.newton_iterations, ..found })
    }

    /// Part of the wear wanted that the rates of a state wear off each second; none where the run does not end by its wear.
    fn progress(&self, state: &WearState) -> Option<f64> {
        let acting = self.load(state);
        let (rate, weights) = (&acting.load.rate, &acting.load.weights);
        let both = |i: usize| weights[i] * (rate.wear(0, i, state.pressure[i]) + rate.wear(1, i, state.pressure[i]));
        match self.problem.until {
            Until::Depth(depth) => {
                Some((0..state.worn.len()).map(|place| rate.worn(0, place, &state.pressure)).fold(0.0, f64::max) / depth)
            }
            Until::Volume(volume) => Some((0..weights.len()).map(both).sum::<f64>() / volume),
            Until::Steady { .. } | Until::Time(_) => None,
        }
    }

    /// Time that the wear wanted takes at the rates of a state; the longest there is where it is not reached at them.
    pub(super) fn lasts(&self, state: &WearState) -> f64 {
        let (Some(left), Some(progress)) = (self.left(state), self.progress(state)) else { return f64::MAX };
        (left / progress).min(f64::MAX)
    }

    /// Whether the wear wanted is never reached: nothing wears in a state that stays as it is, or the contact has worn itself free.
    pub(super) fn is_out_of_reach(&self, state: &WearState) -> bool {
        let stays = self.progress(state) == Some(0.0) && state.gap_rate.iter().all(|rate| *rate == 0.0);
        self.left(state).is_some() && self.limit(state).is_infinite() && (stays || self.is_free(state))
    }

    /// Whether a contact that no load pushes together has no wear left but round-off.
    pub(super) fn is_free(&self, state: &WearState) -> bool {
        !self.driven(state) && state.steady_residual <= FREE
    }
}
