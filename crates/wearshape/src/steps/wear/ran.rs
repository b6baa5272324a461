//! What a run in time on one level has come to.

use shapeopt::EvolutionStatus;

use crate::effort::Effort;
use crate::results::WearResult;
use crate::solution::RunningIn;
use crate::steps::answer::Told;
use crate::steps::reported::Reported;

/// A level that was run here, not in an earlier run that this one goes on with.
pub(super) struct Ran {
    pub ended: EvolutionStatus,
    /// Columns of history.csv.
    pub history: Vec<(String, Vec<f64>)>,
    pub running_in: RunningIn,
    pub wear: WearResult,
    pub told: Told,
    /// For the fields: the end, then the start.
    pub reported: Option<Reported>,
    pub effort: Effort,
}
