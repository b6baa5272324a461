//! Runs the stages of the plan.

pub(crate) mod pressure;

use std::time::Instant;

use crate::fault::Fault;
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

/// Computes everything the plan lists. What has no answer is a solution with its status; an `Err` is the user's to mend.
pub(crate) fn solve(problem: &Problem, options: Options) -> Result<Solution, Fault> {
    solve_live(problem, options, &mut Live::silent())
}

/// The same, recorded and shown while it goes.
pub(crate) fn solve_live(problem: &Problem, options: Options, live: &mut Live) -> Result<Solution, Fault> {
    let mut solution = Solution::default();
    if problem.plan.runs("optimal pressure") {
        timed(&mut solution, "optimal pressure", |solution| pressure::solve(problem, options, solution))?;
    }
    if solution.status != Status::Refused && problem.plan.runs("mesh") {
        crate::fe::solve(problem, options, live, &mut solution)?;
    }
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
