//! Where the contact of a run in time will end, if the load is too far off the middle to use the whole surface.

use scene::{Fault, Functional};

use crate::effort::Effort;
use crate::stage::Stage;
use crate::steps::pressure_ends::pressure_ends;
use crate::steps::wear::pieces::Pieces;
use crate::steps::{pressure, reversing};
use crate::surface::PatchKind;

/// Ends inside the surface, from -1 to 1, of the steady pressures: the gap gets its kinks there. A run that ends on the way has the end of its contact near
/// them if it is long. None where no steady pressures are known.
pub(super) fn final_ends(stage: Stage<'_>, pieces: &Pieces) -> Result<(Vec<f64>, Effort), Fault> {
    // Whether a body that may turn has a steady pressure where friction bends its balance takes longer to find out than such a run.
    let (problem, turns) = (stage.problem, stage.problem.freedoms.len() > 1 && stage.patch.kind != PatchKind::Plane);
    if problem.wear.until.is_some() && turns && problem.friction.shear() > 0.0 {
        return Ok(Default::default());
    }
    if pieces.shares.is_none() {
        return Ok((of_one_pressure(stage, pieces)?, Effort::default()));
    }
    // Those of a schedule that repeats are not computed by themselves.
    let known = stage.problem.reversing.is_some() && stage.problem.cycles.is_none();
    Ok(if known { reversing::ends(stage).unwrap_or_default() } else { Default::default() })
}

/// Those of the steady pressure under the load that acts last.
fn of_one_pressure(stage: Stage<'_>, pieces: &Pieces) -> Result<Vec<f64>, Fault> {
    let Some(last) = pieces.intervals.last().map(|interval| &pieces.problems[interval.stage]) else { return Ok(Vec::new()) };
    let mut steady = last.clone();
    steady.optimum.functional = Functional::Steady;
    steady.optimum.p_max = None;
    if steady.load.force.is_none() {
        return Ok(Vec::new());
    }
    let optimum = pressure::wear_problem(&steady).ok().and_then(|problem| wear::optimal_pressure(&problem).ok());
    Ok(optimum.map(|optimum| pressure_ends(stage, &optimum)).unwrap_or_default())
}
