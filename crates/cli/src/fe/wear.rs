//! The wear stage: the gap in time, from the start gap until it is steady or a time is over.

mod final_ends;
mod history;
mod level;
mod mesh_lines;
mod nodal_curve;
mod pieces;
mod problem;
mod settled;

use nalgebra::DMatrix;
use scene::Fault;
use shapeopt::EvolutionStatus;

use crate::fe::bodies::Level;
use crate::fe::gap_difference::{Measure, difference_of_gaps};
use crate::fe::recover::Reported;
use crate::fe::rungs::{add_times, rungs};
use crate::fe::stage::{Stage, rest};
use crate::live::Live;
use crate::record::FinishedLevel;
use crate::setup::Problem;
use crate::solution::{Counters, Solution, Status};
use crate::solve::Options;

use level::{MOST_STEPS, Mesh, run};

pub(super) use problem::rules;

/// A solved level: what it leaves behind for the others, and what is reported if it is the last.
struct Solved {
    left: FinishedLevel,
    ended: EvolutionStatus,
    /// For the fields: the end, then the start.
    reported: Option<Reported>,
    solution: Solution,
}

/// Runs the wear in time and fills in the solution.
pub(super) fn solve(
    problem: &Problem,
    options: Options,
    live: &mut Live,
    solution: &mut Solution,
) -> Result<Option<Reported>, Fault> {
    let stage = Stage::new(problem)?;
    let fixed = stage.fixed_level().is_some();
    let ladder = stage.ladder(options);
    // Levels that an interrupted run has finished are not solved again.
    let mut finished: Vec<FinishedLevel> = live.finished_levels();
    let known = finished.iter().zip(&ladder).all(|(left, level)| (left.degree, left.layers) == (level.degree, level.layers));
    if !known || finished.len() >= ladder.len() {
        finished.clear();
    }
    let ends = final_ends::final_ends(stage)?;
    let mut last: Option<Solved> = None;
    let mut times = Vec::new();
    for level in ladder.into_iter().skip(finished.len()) {
        if crate::interrupt::asked() {
            break;
        }
        if let Some(before) = last.take() {
            finished.push(before.left);
        }
        match run(stage, Mesh { level, ends: &ends }, &finished, options, live)? {
            Ok(solved) => {
                times.push(solved.solution.times.clone());
                let stuck = matches!(solved.ended, EvolutionStatus::Stuck { .. });
                let enough = !fixed && estimate(&finished, &solved.left).is_some_and(|error| error <= stage.accuracy());
                last = Some(solved);
                if stuck || enough {
                    break;
                }
            }
            Err(reason) => {
                solution.status = Status::Refused;
                solution.reason = Some(reason);
                return Ok(None);
            }
        }
    }
    // A run that the wish cut short says nothing about its end.
    if crate::interrupt::asked() {
        solution.status = Status::Interrupted;
        return Ok(None);
    }
    add_times(&times, &mut solution.times);
    Ok(last.and_then(|last| finish(stage, &finished, last, fixed, solution)))
}

/// Estimated `max |dg| / max g` at the end, modulo the rigid part.
fn estimate(finished: &[FinishedLevel], last: &FinishedLevel) -> Option<f64> {
    let [.., a, b] = finished else { return None };
    Some(rest(difference(a, b), difference(b, last)))
}

/// Difference of the worn gaps of two levels.
fn difference(a: &FinishedLevel, b: &FinishedLevel) -> f64 {
    let points = b.gap_mm.len();
    let closing = DMatrix::from_row_slice(points, b.closing.len() / points.max(1), &b.closing);
    difference_of_gaps(&a.gap_mm, &b.gap_mm, &closing, Measure::Largest)
}

fn finish(stage: Stage<'_>, finished: &[FinishedLevel], last: Solved, fixed: bool, solution: &mut Solution) -> Option<Reported> {
    let error = estimate(finished, &last.left);
    let levels = finished.len() + 1;
    let all: Vec<FinishedLevel> = finished.iter().chain([&last.left]).cloned().collect();
    let solved: Vec<Level> = all.iter().map(|left| Level { degree: left.degree, layers: left.layers }).collect();
    solution.ladder = rungs(&solved, levels, "gap", |i| difference(&all[i - 1], &all[i]), |i| estimate(&all[..i], &all[i]));
    let total = |f: &dyn Fn(&FinishedLevel) -> usize| finished.iter().chain([&last.left]).map(f).sum::<usize>();
    let before = solution.counters.clone();
    solution.counters = Counters {
        factorisations: total(&|left| left.factorisations) + before.factorisations,
        contact_solves: total(&|left| left.contact_solves) + before.contact_solves,
        check_solves: before.check_solves,
        wear_steps: total(&|left| left.wear_steps),
        ..last.solution.counters
    };
    let Solved { ended, reported, solution: result, .. } = last;
    solution.wear = result.wear;
    solution.energy = result.energy;
    solution.reactions = result.reactions;
    solution.profile = result.profile;
    solution.curve = result.curve;
    solution.history = result.history;
    if let EvolutionStatus::Stuck { .. } = ended {
        solution.status = Status::NotConverged;
        solution.reason = Some(ended.to_string());
        return reported;
    }
    if ended == EvolutionStatus::Running {
        solution.status = Status::NotConverged;
        solution.reason = Some(format!("the run was not steady after {MOST_STEPS} steps"));
        return reported;
    }
    let Some(error) = error else { return reported };
    let result = solution.error.get_or_insert_default();
    result.gap_relative = Some(error);
    result.how = format!("gap at the end: rest of the series of {levels} degrees");
    if !fixed && error > stage.accuracy() {
        solution.status = Status::AccuracyMissed;
        solution.reason = Some(format!("the worn gap is accurate to {error:.1e}, not to the {:.0e} asked for", stage.accuracy()));
    }
    reported
}
