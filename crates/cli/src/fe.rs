//! The stages that need the elastic bodies: contact, shape, wear in time.

mod approach;
mod bodies;
mod cells;
mod contact;
mod cuts;
mod diagnosis;
mod ends;
mod ends_profile;
mod ends_scope;
mod forecast;
mod free_ends;
mod gap_difference;
mod half_disc;
mod hertz_trial;
mod matching;
mod near_ends;
mod operators;
mod pressure_ends;
mod recover;
mod round;
mod round_cells;
mod round_trip;
mod rungs;
mod shape;
mod sharp_edges;
mod stage;
mod template;
mod tolerance;
mod torsion;
mod twist;
mod wear;

pub(crate) use approach::force;
pub(crate) use forecast::{Forecast, forecast};
pub(crate) use gap_difference::{Measure, difference_of_gaps};
pub(crate) use operators::Operators;
pub(crate) use stage::rest;

use scene::{Fault, Geometry};

use crate::live::Live;
use crate::setup::Problem;
use crate::solution::{Solution, Status};
use crate::solve::Options;

/// Refuses what is not built yet, before anything is written.
pub(crate) fn available(problem: &Problem) -> Result<(), Fault> {
    if !problem.plan.runs("mesh") {
        return Ok(());
    }
    if let Some(round) = round::Round::of(&problem.scene)? {
        return round::available(problem, &round);
    }
    match half_disc::Couple::of(&problem.scene)? {
        Some(couple) => ends_scope::available(problem, &couple),
        None => {
            let stage = stage::Stage::new(problem)?;
            // Cells of the user's own making may not match: better said before anything is written.
            let geometries = [&problem.scene.body1, &problem.scene.body2].map(|body| body.as_ref().map(|body| &body.geometry));
            if geometries.iter().flatten().any(|g| matches!(g, Geometry::Blocks(_) | Geometry::Mesh(_))) {
                template::meshes(&problem.scene, stage.extent, 1, template::Cut::Plain)?;
            }
            Ok(())
        }
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
    if let Some(round) = round::Round::of(&problem.scene)? {
        return round::solve(problem, &round, options, solution);
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
    if let Some(reported) = reported.as_ref().filter(|_| problem.plan.runs("torsion")) {
        torsion::fill(stage::Stage::new(problem)?, reported, options, solution)?;
    }
    match reported {
        Some(reported) if problem.plan.runs("field recovery") => crate::solve::timed(solution, "field recovery", |solution| {
            recover::recover(stage::Stage::new(problem)?, &reported, solution)
        }),
        _ => Ok(()),
    }
}
