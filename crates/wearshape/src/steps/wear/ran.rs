//! What a run in time on one level has come to.

use shapeopt::EvolutionStatus;

use crate::effort::Effort;
use crate::heat_result::HeatResult;
use crate::results::WearResult;
use crate::solution::RunningIn;
use crate::steps::answer::Told;
use crate::steps::reported::Reported;

/// Most steps of a run.
pub(super) const MOST_STEPS: usize = 20_000;

/// Wear over the length of the surface beyond which a run that is not steady will not be.
pub(super) const FAR: f64 = 1000.0;

/// A level that was run here, not in an earlier run that this one goes on with.
pub(super) struct Ran {
    pub ended: EvolutionStatus,
    /// Columns of history.csv.
    pub history: Vec<(String, Vec<f64>)>,
    /// Columns of groove.csv; none without a groove.
    pub groove: Vec<(String, Vec<f64>)>,
    pub running_in: RunningIn,
    pub wear: WearResult,
    pub told: Told,
    /// Frictional heat at the end.
    pub heat: Option<HeatResult>,
    /// For the fields: the end, then the start.
    pub reported: Option<Reported>,
    pub effort: Effort,
}

impl Ran {
    /// Why the run has not come to its end, if it has not.
    pub(super) fn failure(&self) -> Option<String> {
        match self.ended {
            EvolutionStatus::Stuck { .. } | EvolutionStatus::Unreached { .. } | EvolutionStatus::Unstable { .. } => {
                Some(self.ended.to_string())
            }
            EvolutionStatus::Running if self.wear.steps < MOST_STEPS => {
                Some("the wear was no rigid motion yet when the surface was worn 1000 times deeper than it is long".into())
            }
            EvolutionStatus::Running => Some(format!("the run was not steady after {MOST_STEPS} steps")),
            EvolutionStatus::Steady | EvolutionStatus::TimeReached | EvolutionStatus::WornOff => None,
        }
    }
}
