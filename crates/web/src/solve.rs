//! A solve, and what the page shows of it.

use std::ops::ControlFlow;
use std::sync::{Mutex, PoisonError};

use report::Track;
use scene::{Fault, Kinematics};
use serde_json::{Value, json};
use wearshape::{Options, Problem};

use crate::engine::Engine;
use crate::outside;

/// Solves a problem and keeps what was found; of a coarse answer neither the error nor what the workshop needs.
pub(crate) fn solve(engine: &mut Engine, problem: Problem, coarse: bool) -> Result<Value, Fault> {
    let start = outside::seconds();
    let track = Mutex::new(Track::of(&problem));
    let tell = |change: &dyn Fn(&mut Track)| {
        let mut track = track.lock().unwrap_or_else(PoisonError::into_inner);
        change(&mut track);
        outside::tell(track.share(), &track.words());
    };
    let begun = |step| tell(&|track| track.part(step));
    let options = Options { alone: coarse, machining: !coarse, clock: outside::seconds, begun: &begun, ..Options::default() };
    let solution = wearshape::solve(&problem, &options, &engine.bodies, &mut |event| {
        tell(&|track| track.see(&event));
        ControlFlow::Continue(())
    })?;
    let summary = report::summary(&problem, &solution);
    let revolved = problem.scene().kinematics == Some(Kinematics::Axisymmetric);
    let answer = json!({
        "curves": report::curves(&problem, &solution),
        "glance": report::glance(&summary),
        "tables": report::tables(&summary, revolved),
        "running_in": solution.running_in.as_ref().and_then(|run| report::run_in(run, revolved)),
        "summary": summary,
        "seconds": outside::seconds() - start,
    });
    engine.solved = Some((problem, solution));
    Ok(answer)
}
