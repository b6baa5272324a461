//! The stages that need the elastic bodies: contact, shape, wear in time.

mod approach;
mod bodies;
mod contact;
mod ends;
mod ends_profile;
mod half_disc;
mod operators;
mod recover;
mod round_trip;
mod shape;
mod stage;
mod template;
mod tolerance;
mod torsion;
mod wear;

pub(crate) use approach::force;
pub(crate) use operators::Operators;
pub(crate) use shape::difference_of_gaps;
pub(crate) use stage::rest;

use crate::fault::Fault;
use crate::live::Live;
use crate::setup::Problem;
use crate::solution::{Solution, Status};
use crate::solve::Options;

/// Refuses what is not built yet, before anything is written.
pub(crate) fn available(problem: &Problem) -> Result<(), Fault> {
    if !problem.plan.runs("mesh") {
        return Ok(());
    }
    match half_disc::Couple::of(&problem.scene)? {
        Some(couple) => ends::available(problem, &couple),
        None => stage::Stage::new(problem).map(|_| ()),
    }
}

/// The meshes of both bodies at the scene's fixed discretisation, or with the layers of degree 8.
pub(crate) fn meshes_of(problem: &Problem) -> Result<[hpfem::Mesh; 2], Fault> {
    let stage = stage::Stage::new(problem)?;
    let layers = stage.fixed_level().map_or(8, |level| level.layers);
    template::meshes(stage.scene(), stage.extent, layers, template::Cut::Plain)
}

/// Computes contact, shape and wear as the plan asks.
pub(crate) fn solve(problem: &Problem, options: Options, live: &mut Live, solution: &mut Solution) -> Result<(), Fault> {
    available(problem)?;
    if let Some(couple) = half_disc::Couple::of(&problem.scene)? {
        return ends::solve(problem, &couple, options, solution);
    }
    let mut reported = None;
    if problem.plan.runs("contact") {
        reported = contact::solve(problem, options, solution)?;
    }
    if solution.status != Status::Refused && problem.plan.runs("shape") {
        reported = shape::solve(problem, options, solution)?;
    }
    if solution.status != Status::Refused && problem.plan.runs("evolution") {
        reported = wear::solve(problem, options, live, solution)?;
    }
    match reported {
        Some(reported) if problem.plan.runs("field recovery") => crate::solve::timed(solution, "field recovery", |solution| {
            recover::recover(stage::Stage::new(problem)?, &reported, solution)
        }),
        _ => Ok(()),
    }
}
