//! The shape of a reversing motion: level by level until its gap is accurate enough, with the pressures forward and backward, then the round trip.

mod columns;
mod ends;
mod level;
mod proof;
mod summary;

use std::ops::ControlFlow;

use shapeopt::difference_of_gaps;

use crate::effort::Effort;
use crate::ladder::{Climbed, Ladder, Refusal, climb, missed};
use crate::problem::Problem;
use crate::results::ErrorResult;
use crate::solution::Status;
use crate::stage::Stage;
use crate::step::Step;
use crate::steps::answer::Outcome;
use crate::watch::Watch;
use level::{Senses, Solved};

/// Degree of the level that tells where the senses open.
const ENDS: usize = 8;

/// Where a sense of sliding opens once the shape is steady: places from -1 to 1 along the surface.
pub(crate) fn ends(stage: Stage<'_>) -> Result<(Vec<f64>, Effort), Refusal> {
    let backward = backward(stage);
    let Solved { ends, effort, .. } = senses(stage, &backward)?.level(stage.problem.level(ENDS), &[])?;
    Ok((ends, effort))
}

/// The same problem, sliding backward.
fn backward(stage: Stage<'_>) -> Problem {
    stage.problem.under([1.0, 1.0, -1.0])
}

fn senses<'a>(stage: Stage<'a>, backward: &'a Problem) -> Result<Senses<'a>, Refusal> {
    Ok(Senses { stages: [stage, stage.with(backward)?], share: stage.problem.reversing.unwrap_or(1.0) })
}

/// Solves for the shape and both pressures.
pub(crate) fn solve(stage: Stage<'_>, watch: &mut Watch<'_>) -> Result<(Outcome, Effort), Refusal> {
    let backward = backward(stage);
    let senses = senses(stage, &backward)?;
    let ladder = Ladder::of(stage.problem, stage.options, Step::Shape);
    let measure = stage.problem.measure();
    let distance = |a: &Solved, b: &Solved| [difference_of_gaps(&a.gaps, &b.gaps, &b.closing, measure)];
    let solve = |level, before: &[Solved], _: &mut Watch<'_>| {
        senses.level(level, before.last().map(|last| last.ends.as_slice()).unwrap_or_default()).map(ControlFlow::Continue)
    };
    let Climbed { solved, mut stopped } = climb(&ladder, Vec::new(), solve, distance, watch)?;
    let ends = solved.last().map(|last| last.ends.clone()).unwrap_or_default();
    let beside = ladder.beside(&mut stopped, watch).and_then(|level| senses.level(level, &ends).ok());
    let mut effort = Effort::default();
    beside.iter().chain(&solved).for_each(|level| effort += level.effort.clone());
    let mut outcome = Outcome { stopped, ladder: ladder.rungs(&solved, ("gap", 0), distance), ..Outcome::default() };
    let (last, error) = ladder.to_report(&solved, beside.as_ref(), &distance);
    outcome.tell(error.filter(|_| ladder.is_fixed()));
    let Some(last) = last else { return Ok((outcome, effort)) };
    let how = match error {
        Some(_) => format!("gap: {}", ladder.told_by(solved.len())),
        None => "gap: not estimated".to_string(),
    };
    outcome.error = ErrorResult { gap_relative: error, how, ..ErrorResult::default() };
    if let Some((error, accuracy)) = error.and_then(|error| Some((error, ladder.missed(error)?))) {
        outcome.ended = Some((Status::AccuracyMissed, missed("gap", error, accuracy)));
    }
    effort += senses.report(last, &mut outcome)?;
    Ok((outcome, effort))
}
