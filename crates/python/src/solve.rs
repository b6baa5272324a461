//! A solve on a thread of its own, without Python's lock: the thread that called waits, hears what happens, and lets Python handle signals.

use std::ops::ControlFlow;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, channel};
use std::sync::{Arc, LazyLock, Mutex, PoisonError};
use std::time::{Duration, Instant};

use pyo3::exceptions::PyRuntimeError;
use pyo3::prelude::*;
use report::Track;
use scene::Fault;
use wearshape::{Options, Sampling};

use crate::bodies::Bodies;
use crate::pool::{STACK, within};
use crate::solution::{Solution, Solved};

/// Time between two looks at signals.
const LOOK: Duration = Duration::from_millis(50);

static START: LazyLock<Instant> = LazyLock::new(Instant::now);

/// Seconds since the first call.
pub(crate) fn seconds() -> f64 {
    START.elapsed().as_secs_f64()
}

/// What a caller chooses beside the scene.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub(crate) struct Run {
    /// Called with the share that is done and words; what it returns as `False` ends the run.
    progress: Option<Py<PyAny>>,
    /// Points of the table.
    sample: Option<usize>,
    /// Threads of the solver.
    threads: Option<usize>,
    /// What was factorised before.
    bodies: Option<Py<Bodies>>,
    /// A run in time to go on with.
    resume: Option<Py<Solution>>,
}

/// What the solving thread says.
enum Said {
    /// How far it is.
    Progress(f64, String),
    /// It is done.
    Done(Box<Outcome>),
}

/// What came of a solve, or what the user has to mend.
type Outcome = Result<wearshape::Solution, Fault>;

/// Solves a problem. On a signal of which Python makes an exception the solver is told to stop, and the exception goes up at once.
pub(crate) fn solve(py: Python<'_>, problem: &Arc<wearshape::Problem>, run: Run) -> PyResult<Outcome> {
    let earlier = run.resume.as_ref().map(|solution| solution.get().solved.problem.resolved());
    if earlier.is_some_and(|scene| scene != problem.resolved()) {
        let remedy = "run the scene that it was begun with, or begin anew without it";
        return Ok(Err(Fault::at("resume", "another-recording", "the run to go on with is one of another scene", remedy)));
    }
    let (said, heard) = channel();
    let stop = Arc::new(AtomicBool::new(false));
    let work = Work {
        problem: Arc::clone(problem),
        bodies: run.bodies.as_ref().map(|bodies| Arc::clone(&bodies.get().shared)).unwrap_or_default(),
        resume: run.resume.as_ref().map(|solution| Arc::clone(&solution.get().solved)),
        sample: run.sample,
        threads: run.threads,
        told: run.progress.is_some(),
        stop: Arc::clone(&stop),
        said,
    };
    let thread = std::thread::Builder::new().name("wearshape".into()).stack_size(STACK);
    thread.spawn(move || work.done()).map_err(|error| PyRuntimeError::new_err(format!("no thread: {error}")))?;
    wait(py, heard, run.progress.as_ref(), &stop).inspect_err(|_| {
        // It ends by itself between two parts of its work.
        stop.store(true, Ordering::Relaxed);
    })
}

/// Waits for the solver.
fn wait(py: Python<'_>, heard: Receiver<Said>, progress: Option<&Py<PyAny>>, stop: &AtomicBool) -> PyResult<Outcome> {
    let heard = Mutex::new(heard);
    loop {
        // A receiver is for one thread at a time, which a lock proves.
        let next = py.detach(|| heard.lock().unwrap_or_else(PoisonError::into_inner).recv_timeout(LOOK));
        match next {
            Ok(Said::Done(solved)) => return Ok(*solved),
            Ok(Said::Progress(share, words)) => {
                let answer = progress.map(|progress| progress.bind(py).call1((share, words))).transpose()?;
                if answer.is_some_and(|answer| answer.extract::<bool>().is_ok_and(|go_on| !go_on)) {
                    stop.store(true, Ordering::Relaxed);
                }
            }
            Err(RecvTimeoutError::Timeout) => py.check_signals()?,
            Err(RecvTimeoutError::Disconnected) => {
                return Err(PyRuntimeError::new_err("the solver ended by an error of its own; please report it with the scene"));
            }
        }
    }
}

/// What the solving thread needs.
struct Work {
    problem: Arc<wearshape::Problem>,
    bodies: Arc<wearshape::Bodies>,
    resume: Option<Arc<Solved>>,
    sample: Option<usize>,
    threads: Option<usize>,
    told: bool,
    stop: Arc<AtomicBool>,
    said: Sender<Said>,
}

impl Work {
    fn done(self) {
        let solved = within(self.threads, || self.solved());
        // Nobody listens any more where a signal came first.
        let _ = self.said.send(Said::Done(Box::new(solved)));
    }

    fn solved(&self) -> Outcome {
        let track = Mutex::new(Track::of(&self.problem));
        let tell = |change: &dyn Fn(&mut Track)| {
            if self.told {
                let mut track = track.lock().unwrap_or_else(PoisonError::into_inner);
                change(&mut track);
                let _ = self.said.send(Said::Progress(track.share(), track.words()));
            }
        };
        let begun = |step| tell(&|track| track.part(step));
        let sample = self.sample.map(Sampling::Even);
        let resume = self.resume.as_ref().and_then(|solved| solved.solution.resume.as_ref());
        let options = Options { sample, machining: true, clock: seconds, resume, begun: &begun, ..Options::default() };
        wearshape::solve(&self.problem, &options, &self.bodies, &mut |event| {
            tell(&|track| track.see(&event));
            if self.stop.load(Ordering::Relaxed) { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        })
    }
}
