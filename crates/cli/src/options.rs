//! What the options of a command mean: for the solver, and for the threads it works on.

use rayon::ThreadPool;
use scene::{Fault, Place};
use wearshape::{Options, Sampling};

use crate::args::Points;
use crate::clock::seconds;

/// The options that reach the solver.
pub(crate) fn options(points: &Points) -> Result<Options<'static>, Fault> {
    if let Some(sample) = points.sample.filter(|sample| !(2..=1_000_000).contains(sample)) {
        return Err(Fault {
            place: Some(Place::Flag(format!("--sample {sample}"))),
            ..Fault::new("wrong-flag", format!("--sample {sample} is out of range"), "ask for 2 to 1000000 points")
        });
    }
    Ok(Options { sample: points.sample.map(Sampling::Even), machining: true, clock: seconds, ..Options::default() })
}

/// The number of threads asked for, or those that the machine has.
pub(crate) struct Threads(Option<ThreadPool>);

impl Threads {
    /// Does the work on them.
    pub(crate) fn install<T: Send>(&self, work: impl FnOnce() -> T + Send) -> T {
        match &self.0 {
            Some(pool) => pool.install(work),
            None => work(),
        }
    }
}

/// The threads to work on, before anything is written.
pub(crate) fn threads(asked: Option<usize>) -> Result<Threads, Fault> {
    let Some(threads) = asked else {
        return Ok(Threads(None));
    };
    let wrong = |message: String| Fault {
        place: Some(Place::Flag(format!("--threads {threads}"))),
        ..Fault::new("wrong-flag", message, "give a number of threads from 1 to 1024")
    };
    if !(1..=1024).contains(&threads) {
        return Err(wrong(format!("--threads {threads} is out of range")));
    }
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
    Ok(Threads(Some(pool.map_err(|error| wrong(format!("cannot start {threads} threads: {error}")))?)))
}
