//! What the steps of a run in time leave wrong, and how fine they have to be.

use shapeopt::{Evolution, EvolutionStatus, Stepping, Times, WearProblem, WearState};

use crate::stage::Stage;
use crate::steps::wear::cycles;
use crate::steps::wear::gaps::ApartFrom;
use crate::steps::wear::history::History;
use crate::steps::wear::pieces::Pieces;
use crate::steps::wear::ran::MOST_STEPS;
use crate::steps::wear::run::Run;
use crate::watch::FinishedLevel;

/// Part of the accuracy that the steps may take where ends of contact move: levels are apart by what it is on each of them.
const MOVING: f64 = 0.1;
/// The least part of the error of the first level's steps that finer ones are to leave where the contact is open in part: there the cells leave more.
const FINER: f64 = 0.1;

/// Whether ends of contact pass over the cells of a run: it ends on the way under its only load, and the first level had a part of the surface open. What is
/// steady knows nothing of the way, a contact that grows from a point has its cells where it goes, and loads that change may lift bodies off from wherever they
/// are.
pub(super) fn opens(stage: Stage<'_>, loads: usize, finished: &[FinishedLevel]) -> bool {
    let on_the_way = stage.problem.wear.until.is_some() && !stage.ends_move() && loads == 1;
    on_the_way && finished.first().is_some_and(|first| first.partial)
}

/// Makes the steps of a contact that grows, or that is open in part on its way, as fine as the first level says that they have to be. What they leave
/// wrong is then at least what is expected of steps that much finer, and the second level measures it; without finer steps it is what the first level
/// knows.
pub(super) fn refine(stage: Stage<'_>, problem: &mut WearProblem, finished: &[FinishedLevel]) -> (f64, Option<Option<f64>>) {
    let known = |level: usize| finished.get(level).map(|level| level.integration_error);
    let opened = stage.problem.wanted.fixed.is_none() && opens(stage, problem.stages.len(), finished);
    let Some(first) = known(0).flatten().filter(|_| problem.growing || opened) else { return (0.0, known(0)) };
    let least = if problem.growing { 0.0 } else { FINER * first };
    let wanted = (MOVING * stage.accuracy()).max(least);
    if first <= wanted {
        return (0.0, known(0));
    }
    if let Stepping::Adaptive { accuracy } = &mut problem.stepping {
        *accuracy *= wanted / first;
    }
    (wanted, known(1))
}

/// How much coarser the steps of the run are that a run is compared with, by the error that each may make.
const COARSER: f64 = 16.0;

/// Least error that is told: what wears has the round-off of its pressures, through the condition of the contact, however few steps it took.
const ROUND_OFF: f64 = 1e-10;

/// How many times as large the error of a run of order four is whose steps are fewer: as its number of steps tells, up to what steps of so much larger errors
/// each come to. Runs of few steps (7 and 5) are closer to each other than the errors that they may make.
fn coarser(fine: usize, coarse: usize) -> f64 {
    (fine as f64 / coarse as f64).powi(4).clamp(2.0, COARSER.powf(0.8))
}

/// What the steps of a run leave wrong in its time to the steady pressure and the depth then, or, where it ends before it is steady, in its depth and time at
/// the end; `gaps` tells how far its gap then is from another one, of a run whose gap is an answer of its own beside the depth:
/// its relative difference from a run with coarser steps, by how many times as large the error of that is.
pub(super) fn integration_error(problem: &WearProblem, pieces: &Pieces, run: &Run, gaps: Option<ApartFrom<'_>>) -> Option<f64> {
    let Stepping::Adaptive { accuracy } = problem.stepping else { return None };
    if !matches!(run.ended, EvolutionStatus::Steady | EvolutionStatus::TimeReached | EvolutionStatus::WornOff) {
        return None;
    }
    let stepping = Stepping::Adaptive { accuracy: COARSER * accuracy };
    let times = problem.times.map(|times| Times { accuracy: COARSER * times.accuracy, ..times });
    let coarse = WearProblem { stepping, times, ..problem.clone() };
    let mut evolution = Evolution::new(&coarse).ok()?;
    let mut history = History::default();
    while evolution.state().step < MOST_STEPS
        && let Some(state) = cycles::next(&mut evolution, &coarse, pieces, &history.states)
    {
        history.push(state);
    }
    let relative = |fine: f64, coarse: f64| if fine == coarse { 0.0 } else { (fine - coarse).abs() / fine.abs() };
    // A round contact comes near no steady pressure.
    let settled = problem.times.filter(|_| gaps.is_none()).and_then(|_| history.settled(&evolution));
    let difference = match (run.settled.as_ref().filter(|_| gaps.is_none()), settled) {
        (Some(fine), Some(coarse)) => relative(fine.time, coarse.time).max(relative(fine.depth, coarse.depth)),
        // An end by time has one time, an end by depth one depth.
        (None, None) if run.ended == *evolution.status() => {
            let (fine, coarse) = (&run.state, evolution.state());
            let depth = |state: &WearState| match state.depth {
                // Where body 2 alone opens the gap the depth of body 1 tells nothing.
                0.0 => problem.worn_gap(state).into_iter().fold(0.0, f64::max),
                depth => depth,
            };
            let gap = gaps.map_or(0.0, |apart| apart(&coarse.gap));
            relative(depth(fine), depth(coarse)).max(relative(fine.time, coarse.time)).max(gap)
        }
        _ => return None,
    };
    let times = if problem.growing { COARSER } else { coarser(run.state.step, evolution.state().step) };
    Some((difference / (times - 1.0)).max(ROUND_OFF))
}
