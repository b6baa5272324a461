//! Runs on coarse cells that find where the contact of round bodies ends after its wear, before the mesh is made that has nodes there.

use contact::ContactLoad;
use scene::Fault;
use shapeopt::{Evolution, EvolutionStatus, WearState};

use crate::effort::Effort;
use crate::ladder::Refusal;
use crate::stage::Stage;
use crate::step::Step;
use crate::steps::wear::pieces::Pieces;
use crate::steps::wear::problem::{Loads, wear_problem};
use crate::steps::wear::ran::MOST_STEPS;
use crate::steps::wear::round_result::from_touch;
use crate::steps::wear::scar;

/// Degree of these runs.
pub(super) const FIRST: usize = 4;
/// Change of the ends of contact over their distance at which they are found, by the accuracy wanted, and most runs for them. The worn depth has a kink there:
/// inside a cell, a thousandth beside its node, it keeps levels 1e-4 apart.
pub(super) const FOUND: f64 = 0.1;
pub(super) const TRIALS: usize = 8;

/// Ends of the contact at the start and the end of a rough run, from the place of the first touch (mm), or from the axis of revolution.
pub(super) struct Rough {
    pub start: [f64; 2],
    pub end: [f64; 2],
    /// The outermost places that they came to on the way.
    pub widest: [f64; 2],
}

/// Runs the wear roughly on meshes cut at the given nodes.
pub(super) fn run(stage: Stage<'_>, pieces: &Pieces, nodes: &[f64], effort: &mut Effort) -> Result<Rough, Refusal> {
    let (reduced, work) = stage.reduced_at(stage.problem.level(FIRST), nodes)?;
    *effort += work;
    let pair = reduced.pair()?;
    let operator = effort.timed(Step::Interface, stage.clock(), |_| reduced.operator(&pair, stage.friction() > 0.0))?;
    let began = stage.clock()();
    let stages = pieces.problems.iter().map(|problem| stage.with(problem)).collect::<Result<Vec<Stage<'_>>, Fault>>()?;
    let loads: Vec<ContactLoad> = stages.iter().map(|stage| stage.contact_load(operator.points())).collect();
    let problem = wear_problem(Loads { stages: &stages, loads: &loads, begun: None }, pieces, &operator, 0.0)?;
    let mut evolution = Evolution::new(&problem).map_err(|error| Refusal::Reason(error.to_string()))?;
    let first = evolution.state().clone();
    let places = from_touch(stage, &pair, &operator);
    let ends = |state: &WearState| scar::ends(&places, &problem.mean_pressure(&state.pressure), &problem.worn_gap(state));
    let none = || Refusal::Reason("no point presses at the end of the run".into());
    let start = ends(&first).ok_or_else(none)?;
    let mut widest = start;
    for [from, to] in evolution.by_ref().take(MOST_STEPS).filter_map(|state| ends(&state)) {
        widest = [widest[0].min(from), widest[1].max(to)];
    }
    if !matches!(evolution.status(), EvolutionStatus::TimeReached | EvolutionStatus::WornOff) {
        return Err(Refusal::Reason(evolution.status().to_string()));
    }
    let state = evolution.state();
    effort.counters.contact_solves += 1;
    effort.counters.wear_steps += state.step;
    effort.add_seconds(Step::Evolution, stage.clock()() - began);
    Ok(Rough { start, end: ends(state).ok_or_else(none)?, widest })
}
