//! The force of a prescribed approach: what the optimal pressure has to carry so that its smallest shape needs just this approach.

use contact::Pair;
use nalgebra::{DMatrix, DVector};
use scene::{Fault, Force};
use shapeopt::{ApproachForce, force_of_approach};
use wear::WearError;

use crate::fe::rungs::add_times;
use crate::fe::shape::{Shaper, unanswered};
use crate::fe::stage::{Stage, rest};
use crate::fe::template::Cut;
use crate::setup::Problem;
use crate::solution::Solution;
use crate::solve::Options;

/// The force is found to this part of the accuracy asked for.
const SHARE: f64 = 0.1;

/// A force with its estimated relative error.
pub(crate) struct Found {
    /// The scene with the force filled in beside the approach.
    pub(crate) problem: Problem,
    /// Shapes solved for on the last level.
    pub(crate) passes: usize,
    /// Estimated relative error of the force; `None` from fewer than three levels.
    pub(crate) error: Option<f64>,
}

/// Finds the force level by level; the inner `Err` says why there is none.
pub(crate) fn force(problem: &Problem, options: Options, solution: &mut Solution) -> Result<Result<Found, String>, Fault> {
    let stage = Stage::new(problem)?;
    let approach = stage.scene().load.as_ref().and_then(|load| load.approach).map_or(0.0, |approach| approach.0);
    let mut ladder = stage.ladder(options);
    if stage.fixed_level().is_some() {
        ladder = ladder.split_off(ladder.len().saturating_sub(1));
    }
    let mut forces: Vec<ApproachForce> = Vec::new();
    let mut times = Vec::new();
    for level in ladder {
        let mut work = Solution::default();
        let reduced = stage.reduced(level, Cut::Plain, &mut work)?;
        let start = std::time::Instant::now();
        let pair = reduced.pair()?;
        // Mean pressures of a millionth of the modulus deform like any other.
        let trial = forces.last().map_or_else(|| 1e-6 * softest(stage) * area(&pair), |found| found.force);
        let found = match force_of_approach(approach, trial, |force| needed(stage, &pair, force)) {
            Ok(Some(found)) => found,
            Ok(None) => {
                return Ok(
                    Err("no force goes with the prescribed approach: the surfaces do not come together far enough".into()),
                );
            }
            Err(Stop::Reason(reason)) => return Ok(Err(reason)),
            Err(Stop::Fault(fault)) => return Err(fault),
        };
        work.times.push(("force of the approach".into(), start.elapsed().as_secs_f64()));
        solution.counters.factorisations += work.counters.factorisations;
        times.push(work.times);
        forces.push(found);
        if error(&forces).is_some_and(|error| error <= SHARE * stage.accuracy()) {
            break;
        }
    }
    add_times(&times, &mut solution.times);
    let Some(found) = forces.last() else { return Ok(Err("there is no discretisation to find the force on".into())) };
    Ok(Ok(Found { problem: with_force(problem, found.force)?, passes: found.passes, error: error(&forces) }))
}

fn error(forces: &[ApproachForce]) -> Option<f64> {
    let difference = |a: &ApproachForce, b: &ApproachForce| ((a.force - b.force) / b.force).abs();
    let [.., a, b, c] = forces else { return None };
    Some(rest(difference(a, b), difference(b, c)))
}

/// The problem under a force, its approach kept.
pub(super) fn with_force(problem: &Problem, force: f64) -> Result<Problem, Fault> {
    let mut problem = problem.clone();
    if let Some(load) = &mut problem.scene.load {
        load.force = Some(Force(force));
    }
    problem.freedoms = crate::freedom::freedoms(&problem.scene, problem.patch.as_ref())?;
    Ok(problem)
}

/// Why a force cannot be tried.
enum Stop {
    Fault(Fault),
    Reason(String),
}

/// The approach that the smallest shape of a force needs; `None` if the force is too small for its moment.
fn needed(stage: Stage<'_>, pair: &Pair<'_>, force: f64) -> Result<Option<f64>, Stop> {
    let problem = with_force(stage.problem, force).map_err(Stop::Fault)?;
    let stage = Stage { problem: &problem, ..stage };
    let wear = crate::solve::pressure::wear_problem(&problem.scene, stage.patch, &problem.freedoms);
    let optimum = match wear.and_then(|wear| wear::optimal_pressure(&wear)) {
        Ok(optimum) => optimum,
        Err(WearError::Infeasible { .. }) => return Ok(None),
        Err(error) => return Err(Stop::Reason(error.to_string())),
    };
    if let Some(reason) = unanswered(stage, &optimum) {
        return Err(Stop::Reason(reason));
    }
    let shape = Shaper::new(stage, &optimum).smallest(pair).map_err(Stop::Fault)?;
    Ok(Some(motion(pair, &shape.rigid, stage.about())[0]))
}

/// Young's modulus of the softer body.
fn softest(stage: Stage<'_>) -> f64 {
    let bodies = [&stage.scene().body1, &stage.scene().body2];
    let young = bodies.into_iter().flatten().filter_map(|body| body.material).map(|material| material.young.0);
    young.fold(f64::INFINITY, f64::min)
}

fn area(pair: &Pair<'_>) -> f64 {
    pair.points().iter().map(|point| point.weight).sum()
}

/// Closing at `about` and turning (closing more at larger x) of body 1's rigid modes, `2 x modes`.
fn motions(pair: &Pair<'_>, about: f64) -> DMatrix<f64> {
    let modes = &pair.shaped.rigid_motions;
    DMatrix::from_fn(2, modes.len(), |row, k| {
        let [_, tz, theta] = modes[k];
        if row == 0 { -(tz + theta * about) } else { -theta }
    })
}

/// Closing at `about` and turning of rigid coordinates.
pub(super) fn motion(pair: &Pair<'_>, coordinates: &[f64], about: f64) -> [f64; 2] {
    let sums = motions(pair, about) * DVector::from_row_slice(coordinates);
    [sums[0], sums[1]]
}

/// Rigid coordinates of a closing at `about` and a turning, as far as body 1 has these motions.
pub(super) fn coordinates(pair: &Pair<'_>, [closing, turning]: [f64; 2], about: f64) -> Vec<f64> {
    let wanted = DVector::from_row_slice(&[closing, turning]);
    // Rows of unlike units: the modes are scaled by the distance from the middle that they are about.
    let size = pair.trace().length();
    let scale = DMatrix::from_diagonal(&DVector::from_row_slice(&[1.0, size]));
    let svd = (&scale * motions(pair, about)).svd(true, true);
    svd.solve(&(scale * wanted), 1e-12).map(|x| x.iter().copied().collect()).unwrap_or_default()
}
