//! The force of a prescribed approach: what the optimal pressure has to carry so that its smallest shape needs just this approach.

use std::ops::ControlFlow;

use contact::Pair;
use meshing::Cut;
use shapeopt::{ApproachForce, force_of_approach};
use wear::WearError;

use crate::effort::Effort;
use crate::ladder::{Climbed, Ladder, Refusal, climb, errors};
use crate::level::Level;
use crate::problem::Problem;
use crate::stage::Stage;
use crate::step::Step;
use crate::steps::pressure;
use crate::steps::rigid_coordinates::motion;
use crate::steps::shaper::{Shaper, unanswered};
use crate::watch::Watch;

/// The force is found to this part of the accuracy asked for.
const SHARE: f64 = 0.1;

/// A force with its estimated relative error.
pub(crate) struct Found {
    /// The problem with the force filled in beside the approach.
    pub problem: Problem,
    /// Shapes solved for on the last level.
    pub passes: usize,
    /// Estimated relative error of the force; `None` from fewer than three levels.
    pub error: Option<f64>,
    /// Whether the watcher ended the search.
    pub stopped: bool,
}

/// One level of the search.
struct Solved {
    found: ApproachForce,
    effort: Effort,
}

/// Finds the force level by level.
pub(crate) fn force(stage: Stage<'_>, watch: &mut Watch<'_>) -> Result<(Found, Effort), Refusal> {
    let approach = stage.problem.load.approach.unwrap_or(0.0);
    let ladder = Ladder::of(stage.problem, stage.options, Step::Force).closer(SHARE);
    let solve = |level: Level, before: &[Solved], _: &mut Watch<'_>| {
        let (reduced, mut effort) = stage.reduced(level, Cut::Plain)?;
        let pair = reduced.pair()?;
        // Mean pressures of a millionth of the modulus deform like any other.
        let trial = before.last().map_or_else(|| 1e-6 * stage.couple.softest() * area(&pair), |level| level.found.force);
        (stage.options.begun)(Step::Force);
        let found = effort
            .timed(Step::Force, stage.clock(), |_| force_of_approach(approach, trial, |force| needed(stage, &pair, force)))?;
        let found = found.ok_or_else(|| {
            Refusal::Reason("no force goes with the prescribed approach: the surfaces do not come together far enough".into())
        })?;
        Ok(ControlFlow::Continue(Solved { found, effort }))
    };
    let distance = |a: &Solved, b: &Solved| [((a.found.force - b.found.force) / b.found.force).abs()];
    let Climbed { solved, stopped } = climb(&ladder, Vec::new(), solve, distance, watch)?;
    let error = errors(&solved, &distance).map(|[error]| error);
    let mut effort = Effort::default();
    solved.iter().for_each(|level| effort += level.effort.clone());
    let Some(last) = solved.last() else {
        return Ok((Found { problem: stage.problem.clone(), passes: 0, error, stopped }, effort));
    };
    let problem = stage.problem.with_force(last.found.force);
    Ok((Found { problem, passes: last.found.passes, error, stopped }, effort.aside()))
}

/// The approach that the smallest shape of a force needs; `None` if the force is too small for its moment.
fn needed(stage: Stage<'_>, pair: &Pair<'_>, force: f64) -> Result<Option<f64>, Refusal> {
    let problem = stage.problem.with_force(force);
    let stage = stage.with(&problem)?;
    let optimum = match wear::optimal_pressure(&pressure::wear_problem(&problem)?) {
        Ok(optimum) => optimum,
        Err(WearError::Infeasible { .. }) => return Ok(None),
        Err(error) => return Err(Refusal::Reason(error.to_string())),
    };
    unanswered(stage, &optimum)?;
    let shape = Shaper::new(stage, &optimum).smallest(pair)?;
    Ok(Some(motion(pair, &shape.rigid, stage.about())[0]))
}

fn area(pair: &Pair<'_>) -> f64 {
    pair.points().iter().map(|point| point.weight).sum()
}
