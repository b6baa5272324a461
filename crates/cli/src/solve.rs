//! Runs the stages of the plan.

pub(crate) mod pressure;

use std::time::Instant;

use crate::fault::Fault;
use crate::setup::Problem;
use crate::solution::{Solution, Status};

/// Options of a run that are no part of the scene.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Options {
    /// Number of evenly spaced points of contact.csv.
    pub(crate) sample: Option<usize>,
}

/// Computes everything the plan lists. What has no answer is a solution with its status; an `Err` is the user's to mend.
pub(crate) fn solve(problem: &Problem, options: Options) -> Result<Solution, Fault> {
    let mut solution = Solution::default();
    if problem.plan.runs("optimal pressure") {
        timed(&mut solution, "optimal pressure", |solution| pressure::solve(problem, options, solution))?;
    }
    if solution.status != Status::Refused && problem.plan.runs("mesh") {
        crate::fe::solve(problem, options, &mut solution)?;
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
