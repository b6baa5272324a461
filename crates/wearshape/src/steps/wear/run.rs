//! A run in time as far as it has come.

use shapeopt::{EvolutionStatus, WearState};

use crate::level::Level;
use crate::life_result::LifeResult;
use crate::results::Settled;
use crate::steps::wear::history::History;
use crate::watch::FinishedLevel;

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

impl Run {
    /// What its last state and its way leave to the levels after it.
    pub(super) fn left(&self, level: Level) -> FinishedLevel {
        FinishedLevel {
            degree: level.degree,
            layers: level.layers,
            time: self.state.time,
            depth: self.state.depth,
            volumes: self.state.volume,
            partial: self.history.states.iter().any(|state| is_partial(&state.pressure)),
            wear_steps: self.state.step,
            ..FinishedLevel::default()
        }
    }
}

/// Whether some of the points press and some do not.
fn is_partial(pressure: &[f64]) -> bool {
    pressure.iter().any(|p| *p > 0.0) && pressure.iter().any(|p| *p <= 0.0)
}
