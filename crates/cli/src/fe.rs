//! The stages that need the elastic bodies: contact, shape, wear in time.

mod bodies;
mod shape;
mod template;

use crate::fault::Fault;
use crate::scene::Task;
use crate::setup::{Problem, word};
use crate::solution::Solution;
use crate::solve::Options;

/// Refuses what is not built yet, before anything is written.
pub(crate) fn available(problem: &Problem) -> Result<(), Fault> {
    let built = [Task::Pressure, Task::Shape];
    let Some(task) = problem.tasks.iter().find(|task| !built.contains(task)) else { return Ok(()) };
    let message = format!("the task \"{}\" is not available yet", word(*task));
    Err(Fault::at("tasks", "not-available", message, "ask for tasks = [\"pressure\", \"shape\"]"))
}

/// Computes contact, shape and wear as the plan asks.
pub(crate) fn solve(problem: &Problem, options: Options, solution: &mut Solution) -> Result<(), Fault> {
    available(problem)?;
    shape::solve(problem, options, solution)
}
