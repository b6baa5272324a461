//! The wear stage: the gap in time, from the start gap until it is steady or a time is over.

mod final_ends;
mod history;
mod level;
mod mesh_lines;
mod pieces;
mod problem;
mod ran;

use std::ops::ControlFlow;

use level::{Known, MOST_STEPS, Mesh, run};
use nalgebra::DMatrix;
use pieces::Pieces;
use ran::Ran;
use shapeopt::{EvolutionStatus, Measure, difference_of_gaps};

use crate::effort::Effort;
use crate::ladder::{Climbed, Ladder, Refusal, climb, missed, rungs};
use crate::results::WearResult;
use crate::solution::Status;
use crate::stage::Stage;
use crate::step::Step;
use crate::steps::answer::Outcome;
use crate::watch::{FinishedLevel, Resume, Watch};

/// A level: what it leaves behind for the others, and what is reported if it is the last.
struct Solved {
    left: FinishedLevel,
    run: Option<Ran>,
}

/// Runs the wear in time.
pub(crate) fn solve(stage: Stage<'_>, watch: &mut Watch<'_>) -> Result<(Outcome, Effort), Refusal> {
    let ladder = Ladder::of(stage.problem, stage.options, Step::Evolution);
    let pieces = Pieces::of(stage.problem);
    let resume = stage.options.resume.cloned().unwrap_or_default();
    let (known, mut states) = if fits(&resume, &ladder) { (resume.finished, resume.states) } else { Default::default() };
    let ends = final_ends::final_ends(stage, &pieces)?;
    let known: Vec<Solved> = known.into_iter().map(|left| Solved { left, run: None }).collect();
    let mut cut = None;
    let solve = |level, before: &[Solved], watch: &mut Watch<'_>| {
        let finished: Vec<FinishedLevel> = before.iter().map(|solved| solved.left.clone()).collect();
        let states = std::mem::take(&mut states);
        let known = Known { finished: &finished, states };
        let (left, ran) = match run(stage, &pieces, Mesh { level, ends: &ends }, known, watch)? {
            Ok(done) => done,
            Err(history) => {
                cut = Some(history);
                return Ok(ControlFlow::Break(None));
            }
        };
        let stuck = matches!(ran.ended, EvolutionStatus::Stuck { .. });
        let solved = Solved { left, run: Some(ran) };
        Ok(if stuck { ControlFlow::Break(Some(solved)) } else { ControlFlow::Continue(solved) })
    };
    let Climbed { solved, stopped } = climb(&ladder, known, solve, distance, watch)?;
    let mut effort = Effort::default();
    for level in &solved {
        match &level.run {
            Some(ran) => effort += ran.effort.clone(),
            None => effort += before(&level.left),
        }
    }
    let finished = || solved.iter().map(|level| level.left.clone()).collect();
    let resume = stopped.then(|| Resume { finished: finished(), states: cut.map_or_else(Vec::new, |cut| cut.states) });
    Ok((Outcome { stopped, resume, ..finish(stage, &ladder, solved) }, effort))
}

/// Whether an unfinished run is one on these levels.
fn fits(resume: &Resume, ladder: &Ladder) -> bool {
    let same = resume.finished.iter().zip(&ladder.levels).all(|(left, l)| (left.degree, left.layers) == (l.degree, l.layers));
    same && resume.finished.len() < ladder.levels.len()
}

/// Work of a level of an earlier run.
fn before(left: &FinishedLevel) -> Effort {
    let mut effort = Effort::default();
    effort.counters.factorisations = left.factorisations;
    effort.counters.contact_solves = left.contact_solves;
    effort.counters.wear_steps = left.wear_steps;
    effort
}

/// Difference of the worn gaps of two levels, modulo the rigid part, over the largest gap.
fn distance(a: &Solved, b: &Solved) -> [f64; 1] {
    let (a, b) = (&a.left, &b.left);
    let points = b.gap.len();
    let closing = DMatrix::from_row_slice(points, b.closing.len() / points.max(1), &b.closing);
    [difference_of_gaps(&a.gap, &b.gap, &closing, Measure::Largest)]
}

/// Estimated relative error of the time to the steady pressure: of the steps, and the rest of the series of the levels. Of a run without such a
/// time what the steps leave in its depth; none before there are three levels.
fn run_in_error(ladder: &Ladder, solved: &[Solved], gap: Option<f64>) -> Option<f64> {
    let steps = solved.last()?.left.integration_error?;
    let relative = |a: f64, b: f64| if a == b { 0.0 } else { ((a - b) / b).abs() };
    if solved.iter().all(|level| level.left.to_1_percent.is_none()) {
        return gap.map(|gap| gap + steps);
    }
    let known = solved.iter().rev().take(3).all(|level| level.left.to_1_percent.is_some());
    let time = |level: &Solved| level.left.to_1_percent.unwrap_or(0.0);
    let levels = ladder.error_of_gap(solved, None, &|a, b| [relative(time(a), time(b))]).filter(|_| known)?;
    Some(levels + steps)
}

fn finish(stage: Stage<'_>, ladder: &Ladder, mut solved: Vec<Solved>) -> Outcome {
    let degrees: Vec<usize> = solved.iter().map(|level| level.left.degree).collect();
    let mut outcome = Outcome { ladder: rungs(&degrees, &solved, "gap", 0, distance), ..Outcome::default() };
    let error = ladder.error_of_gap(&solved, None, &distance);
    outcome.tell(error.filter(|_| ladder.is_fixed()));
    let run_in_error = run_in_error(ladder, &solved, error);
    let levels = solved.len();
    let Some(last) = solved.pop().and_then(|level| level.run) else { return outcome };
    let arrived = matches!(last.ended, EvolutionStatus::Steady | EvolutionStatus::TimeReached);
    outcome.wear = Some(WearResult { run_in_error: run_in_error.filter(|_| arrived), ..last.wear });
    outcome.history = last.history;
    outcome.running_in = Some(last.running_in);
    outcome.told = Some(last.told);
    outcome.reported = last.reported;
    outcome.ended = match last.ended {
        EvolutionStatus::Stuck { .. } => Some((Status::NotConverged, last.ended.to_string())),
        EvolutionStatus::Running => Some((Status::NotConverged, format!("the run was not steady after {MOST_STEPS} steps"))),
        EvolutionStatus::Steady | EvolutionStatus::TimeReached => None,
    };
    let Some(error) = error.filter(|_| outcome.ended.is_none()) else { return outcome };
    outcome.error.gap_relative = Some(error);
    outcome.error.how = format!("gap at the end: rest of the series of {levels} degrees");
    if ladder.missed(error).is_some() {
        outcome.ended = Some((Status::AccuracyMissed, missed("worn gap", error, stage.accuracy())));
    }
    outcome
}
