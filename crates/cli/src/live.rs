//! What goes along with a run while it computes: the recording and the progress on the terminal.

use scene::Fault;
use shapeopt::WearState;

use crate::progress::Progress;
use crate::record::{FinishedLevel, Iteration, Points, SceneUpdate, State, Tape};

/// Recording and progress of a run.
pub(crate) struct Live {
    /// The recording of a run in time.
    pub(crate) tape: Option<Tape>,
    /// What the terminal shows.
    pub(crate) progress: Progress,
}

impl Live {
    /// Neither recording nor progress.
    pub(crate) fn silent() -> Live {
        Live { tape: None, progress: Progress::none() }
    }

    /// The levels that an interrupted run had finished.
    pub(crate) fn finished_levels(&self) -> Vec<FinishedLevel> {
        self.tape.as_ref().map_or_else(Vec::new, Tape::finished_levels)
    }

    /// Begins a level of a run in time; returns the states that its recording already has.
    pub(crate) fn begin_level(
        &mut self,
        finished: &[FinishedLevel],
        mesh: impl FnOnce() -> Result<SceneUpdate, Fault>,
        message: &str,
    ) -> Result<Vec<State>, Fault> {
        self.progress.level(message);
        match &mut self.tape {
            Some(tape) => tape.begin_level(finished, &mesh()?, message),
            None => Ok(Vec::new()),
        }
    }

    /// Records a step.
    pub(crate) fn step(
        &mut self,
        iteration: &Iteration,
        profile: impl FnOnce() -> Points,
        state: &WearState,
    ) -> Result<(), Fault> {
        match self.tape.as_mut().and_then(Tape::recorder) {
            Some(recorder) => recorder.step(iteration, &profile(), &State::from(state)),
            None => Ok(()),
        }
    }
}
