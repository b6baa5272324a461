//! What goes along with a run while it computes: the recording, the progress on the terminal, Ctrl-C.

use std::ops::ControlFlow;
use std::sync::Arc;

use scene::Fault;
use wearshape::{Bodies, Event, Options, Problem, RunLevel, Solution, WearStep};

use crate::interrupt;
use crate::progress::Progress;
use crate::record::{Iteration, Points, SceneUpdate, State, Tape};

/// Recording and progress of a run.
pub(crate) struct Live {
    /// The recording of a run in time.
    pub(crate) tape: Option<Tape>,
    /// What the terminal shows.
    pub(crate) progress: Arc<Progress>,
    /// Why the run was ended from here, but for Ctrl-C.
    fault: Option<Fault>,
}

impl Live {
    /// A recording, if there is one, and the progress.
    pub(crate) fn new(tape: Option<Tape>, progress: Arc<Progress>) -> Live {
        Live { tape, progress, fault: None }
    }

    /// Neither recording nor progress; Ctrl-C ends the run.
    pub(crate) fn silent() -> Live {
        Live::new(None, Arc::new(Progress::none()))
    }

    /// Solves a problem, recorded and shown while it goes.
    pub(crate) fn solve(&mut self, problem: &Problem, options: &Options<'_>, bodies: &Bodies) -> Result<Solution, Fault> {
        let progress = Arc::clone(&self.progress);
        let begun = |step| progress.part(step);
        let options = Options { begun: &begun, ending: &interrupt::asked, ..*options };
        let solved = wearshape::solve(problem, &options, bodies, &mut |event| self.see(event));
        // However it ended, its steps are worth going on from.
        if let Some(tape) = &mut self.tape {
            tape.recorder()?;
        }
        self.fault.take().map_or(solved, Err)
    }

    fn see(&mut self, event: Event<'_>) -> ControlFlow<()> {
        self.progress.see(&event);
        let done = match event {
            Event::Level { .. } => Ok(()),
            Event::Run(level) => self.begin(level),
            Event::WearStep(step) => self.step(step),
        };
        match done {
            Ok(()) if interrupt::asked() => ControlFlow::Break(()),
            Ok(()) => ControlFlow::Continue(()),
            Err(fault) => {
                self.fault = Some(fault);
                ControlFlow::Break(())
            }
        }
    }

    fn begin(&mut self, level: &RunLevel<'_>) -> Result<(), Fault> {
        match &mut self.tape {
            Some(tape) => tape.begin_level(level, || Ok(SceneUpdate::new(&(level.lines)()?))),
            None => Ok(()),
        }
    }

    fn step(&mut self, step: &WearStep<'_>) -> Result<(), Fault> {
        let state = step.state;
        let Some(tape) = &mut self.tape else { return Ok(()) };
        let iteration = Iteration {
            step: state.step as u64,
            tries: step.tries as u64,
            linear_solves: step.linear_solves as u64,
            step_size: state.step_size,
            error: state.error,
            steady_residual: state.steady_residual,
        };
        let points = Points::new(state.step as u64, state.time, &(step.profile)());
        tape.step(iteration, points, State::from(state))
    }
}
