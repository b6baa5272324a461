//! The stages that need the elastic bodies: contact, shape, wear in time.

use crate::fault::Fault;
use crate::scene::Task;
use crate::setup::{Problem, word};
use crate::solution::Solution;
use crate::solve::Options;

/// Refuses what is not built yet, before anything is written.
pub(crate) fn available(problem: &Problem) -> Result<(), Fault> {
    if !problem.plan.runs("mesh") {
        return Ok(());
    }
    let task = problem
        .tasks
        .iter()
        .find(|task| **task != Task::Pressure)
        .copied()
        .unwrap_or(Task::Shape);
    let message = format!("the task \"{}\" is not available yet", word(task));
    Err(Fault::at(
        "tasks",
        "not-available",
        message,
        "ask for the pressure alone: --set tasks=[pressure]",
    ))
}

/// Computes contact, shape and wear as the plan asks.
pub(crate) fn solve(
    problem: &Problem,
    _options: Options,
    _solution: &mut Solution,
) -> Result<(), Fault> {
    available(problem)
}
