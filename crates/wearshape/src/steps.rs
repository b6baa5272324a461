//! The stages that need the elastic bodies: contact, shape, wear in time.

mod answer;
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
mod scope;
mod shape;
mod sharp_edges;
mod stage;
mod template;
mod tolerance;
mod torsion;
mod twist;
mod wear;

pub(crate) use answer::Outcome;
pub(crate) use bodies::Level;
pub(crate) use forecast::{Forecast, forecast};
pub(crate) use gap_difference::{Measure, difference_of_gaps};
pub(crate) use operators::Bodies;
pub(crate) use scope::Scope;
pub(crate) use shape::Before;
pub(crate) use stage::Stage;

pub(crate) use approach::force;
pub(crate) use contact::solve as contact;
pub(crate) use recover::{Reported, recover};
pub(crate) use shape::solve as shape;
pub(crate) use torsion::fill as twist;
pub(crate) use wear::solve as wear;

use scene::Fault;

use crate::options::Options;
use crate::plan::Step;
use crate::problem::Problem;
use template::Cut;

/// Refuses what is not built yet, before anything is written.
pub(crate) fn available(problem: &Problem) -> Result<(), Fault> {
    if !problem.plan.runs(Step::Mesh) {
        return Ok(());
    }
    Scope::of(problem, &Options::default(), &Bodies::default())?.available()
}

/// The meshes of both bodies at the problem's fixed discretisation, or with the layers of degree 8.
pub(crate) fn meshes_of(problem: &Problem) -> Result<[hpfem::Mesh; 2], Fault> {
    let (options, bodies) = (Options::default(), Bodies::default());
    let layers = problem.wanted.fixed.map_or(8, |level| level.layers);
    Stage::new(problem, &options, &bodies)?.meshes(layers, Cut::Plain)
}
