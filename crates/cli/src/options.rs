//! What the options of a command mean: for the solver, and for the threads it works on.

use scene::{Fault, Place};
use wearshape::{Options, Sampling};

use crate::args::Common;
use crate::clock::seconds;

/// The options that reach the solver.
pub(crate) fn options(common: &Common) -> Result<Options<'static>, Fault> {
    if let Some(sample) = common.sample.filter(|sample| !(2..=1_000_000).contains(sample)) {
        return Err(Fault {
            place: Some(Place::Flag(format!("--sample {sample}"))),
            ..Fault::new("wrong-flag", format!("--sample {sample} is out of range"), "ask for 2 to 1000000 points")
        });
    }
    Ok(Options { sample: common.sample.map(Sampling::Even), machining: true, clock: seconds, ..Options::default() })
}

/// Does the work on the number of threads asked for.
pub(crate) fn with_threads<T: Send>(common: &Common, work: impl FnOnce() -> T + Send) -> Result<T, Fault> {
    let Some(threads) = common.threads else {
        return Ok(work());
    };
    let wrong = |message: String| Fault {
        place: Some(Place::Flag(format!("--threads {threads}"))),
        ..Fault::new("wrong-flag", message, "give a number of threads from 1 to 1024")
    };
    if !(1..=1024).contains(&threads) {
        return Err(wrong(format!("--threads {threads} is out of range")));
    }
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
    Ok(pool.map_err(|error| wrong(format!("cannot start {threads} threads: {error}")))?.install(work))
}
