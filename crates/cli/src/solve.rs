//! Runs the stages of the plan.

pub(crate) mod pressure;

use std::time::Instant;

use scene::Fault;

use crate::live::Live;
use crate::setup::Problem;
use crate::solution::{Solution, Status};

/// Options of a run that are no part of the scene.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Options<'a> {
    /// Points of contact.csv instead of the contact points.
    pub(crate) sample: Option<Sampling<'a>>,
    /// Solves the scene's fixed discretisation alone, without the coarser ones that its error estimate needs.
    pub(crate) alone: bool,
    /// Adds what the workshop needs of a shape: the finished surface, and what errors of it do.
    pub(crate) machining: bool,
}

/// Points of a contact surface that the user chooses.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Sampling<'a> {
    /// This many, evenly spaced in the surface's own coordinate, both ends included.
    Even(usize),
    /// At these values of s (mm).
    At(&'a [f64]),
}

impl Sampling<'_> {
    /// Values of s between two ends.
    pub(crate) fn places(self, [from, to]: [f64; 2]) -> Vec<f64> {
        match self {
            Sampling::At(places) => places.iter().map(|s| s.clamp(from.min(to), to.max(from))).collect(),
            Sampling::Even(count) => {
                let last = count.max(2) - 1;
                let place = |i: usize| if i == last { to } else { from + (to - from) * (i as f64 / last as f64) };
                (0..=last).map(place).collect()
            }
        }
    }
}

/// Points of the curves in pictures.
pub(crate) const CURVE: Sampling<'static> = Sampling::Even(401);

/// Trapezoid weights of ascending places: half the way to each neighbour.
pub(crate) fn trapezoid_weights(places: &[f64]) -> Vec<f64> {
    let last = places.len().saturating_sub(1);
    (0..places.len()).map(|i| 0.5 * (places[(i + 1).min(last)] - places[i.saturating_sub(1)])).collect()
}

/// Name of the stage that finds the force of a prescribed approach.
pub(crate) const FORCE: &str = "force of the approach";

/// Computes everything the plan lists. What has no answer is a solution with its status; an `Err` is the user's to mend.
pub(crate) fn solve(problem: &Problem, options: Options) -> Result<Solution, Fault> {
    solve_live(problem, options, &mut Live::silent())
}

/// The same, recorded and shown while it goes.
pub(crate) fn solve_live(problem: &Problem, options: Options, live: &mut Live) -> Result<Solution, Fault> {
    let mut solution = Solution::default();
    let mut known = None;
    if problem.plan.runs(FORCE) {
        match crate::fe::force(problem, options, &mut solution)? {
            Ok(found) => known = Some(found),
            Err(reason) => {
                solution.status = Status::Refused;
                solution.reason = Some(reason);
                return Ok(solution);
            }
        }
    }
    let problem = known.as_ref().map_or(problem, |found| &found.problem);
    solution.passes = known.as_ref().map_or(0, |found| found.passes);
    if problem.plan.runs("optimal pressure") {
        timed(&mut solution, "optimal pressure", |solution| pressure::solve(problem, options, solution))?;
    }
    if let Some((found, error)) = known.as_ref().zip(solution.error.as_mut()) {
        // The pressure is as accurate as the force; without an estimate nothing is said.
        error.pressure_relative = found.error.map(|of_force| of_force.max(f64::EPSILON));
        error.how = "force of the approach, rest of the series of degrees".into();
    }
    if solution.status != Status::Refused && problem.plan.runs("mesh") {
        crate::fe::solve(problem, options, live, &mut solution)?;
    }
    let after = crate::lints::after(&problem.scene, &solution);
    solution.lints.extend(after);
    Ok(solution)
}

/// Does a stage and notes its seconds.
pub(crate) fn timed<T>(
    solution: &mut Solution,
    name: &str,
    stage: impl FnOnce(&mut Solution) -> Result<T, Fault>,
) -> Result<T, Fault> {
    let start = Instant::now();
    let result = stage(solution);
    solution.times.push((name.to_string(), start.elapsed().as_secs_f64()));
    result
}
