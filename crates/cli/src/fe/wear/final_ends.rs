//! Where the contact of a run in time will end, if the load is too far off the middle to use the whole surface.

use scene::{Fault, Functional, Until};

use crate::fe::pressure_ends::pressure_ends;
use crate::fe::stage::Stage;
use crate::fe::wear::pieces::Pieces;

/// Ends inside the surface, from -1 to 1, of the steady pressure under the load that acts last: the gap gets its kinks there. None for a run
/// to a given time, or where no steady pressure is known.
pub(super) fn final_ends(stage: Stage<'_>) -> Result<Vec<f64>, Fault> {
    if let Some(Until::Time(_)) = stage.scene().wear.as_ref().and_then(|wear| wear.until) {
        return Ok(Vec::new());
    }
    let pieces = Pieces::of(stage.problem)?;
    let Some(last) = pieces.intervals.last().map(|interval| &pieces.scenes[interval.stage]) else { return Ok(Vec::new()) };
    let mut scene = last.scene.clone();
    let optimum = scene.optimum.get_or_insert_default();
    optimum.functional = Some(Functional::Steady);
    optimum.p_max = None;
    if scene.load.as_ref().is_none_or(|load| load.force.is_none()) {
        return Ok(Vec::new());
    }
    let steady = crate::solve::pressure::wear_problem(&scene, stage.patch, &last.freedoms)
        .and_then(|problem| wear::optimal_pressure(&problem));
    Ok(steady.map(|optimum| pressure_ends(stage, &optimum)).unwrap_or_default())
}
