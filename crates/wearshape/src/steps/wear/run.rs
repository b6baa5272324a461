//! A run in time as far as it has come.

use shapeopt::{EvolutionStatus, WearState};

use crate::life_result::LifeResult;
use crate::results::Settled;
use crate::steps::wear::history::History;

/// What a run in time has come to.
pub(super) struct Run {
    pub(super) state: WearState,
    pub(super) ended: EvolutionStatus,
    /// Whether the watcher ended it.
    pub(super) stopped: bool,
    pub(super) history: History,
    /// What it took until the pressure was nearly the last one.
    pub(super) settled: Option<Settled>,
    /// How long what may wear off lasts.
    pub(super) life: Option<LifeResult>,
    pub(super) run_in: Option<shapeopt::RunIn>,
}
