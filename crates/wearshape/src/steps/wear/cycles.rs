//! Cycles resolved one by one, until they are alike: the wear of one is a rigid feed then, and so is that of all that follow.

use shapeopt::{Evolution, Stepping, WearProblem, WearState};

use crate::steps::wear::pieces::Pieces;

/// Part of the error of a step that the cycles still to come may stray where the contact grows; else they may stray by all of it.
const GROWING: f64 = 0.3;

/// The next state of a run: of a step, or of all cycles but the last at once, where they are alike.
pub(super) fn next<'a>(
    evolution: &mut Evolution<'a>,
    problem: &'a WearProblem,
    pieces: &Pieces,
    states: &[WearState],
) -> Option<WearState> {
    let leap = pieces.cycle.and_then(|cycle| leap(evolution, problem, states, cycle));
    let Some(state) = leap else { return evolution.next() };
    *evolution = Evolution::resume(problem, state.clone()).ok()?;
    Some(state)
}

/// How many cycles a run has resolved, if it has taken some at once.
pub(super) fn resolved(pieces: &Pieces, states: &[WearState]) -> Option<f64> {
    let cycle = pieces.cycle?;
    let before = states.windows(2).find(|pair| pair[1].interval > pair[0].interval + 1)?;
    // And the last one.
    Some(((before[0].interval + 1) / cycle + 1) as f64)
}

/// The state before the last cycle, if the cycles until then are alike.
fn leap(evolution: &Evolution<'_>, problem: &WearProblem, states: &[WearState], cycle: usize) -> Option<WearState> {
    let state = evolution.state();
    let (count, done) = (problem.schedule.len() / cycle, state.interval / cycle + 1);
    let over = state.time >= state.interval_start + problem.schedule[state.interval].duration;
    if (state.interval + 1) % cycle != 0 || !over || done < 3 || done + 2 > count {
        return None;
    }
    let end_of = |cycles: usize| states.iter().rev().find(|state| state.interval < cycles * cycle);
    let (before, earlier) = end_of(done - 1).zip(end_of(done - 2))?;
    let [last, one] = [evolution.strayed(before, state), evolution.strayed(earlier, before)];
    let Stepping::Adaptive { accuracy } = problem.stepping else { return None };
    // What cycles stray falls as a geometric series.
    let ratio = last / one;
    let rest = last * ratio / (1.0 - ratio);
    let allowed = if problem.growing { GROWING * accuracy } else { accuracy };
    (ratio < 1.0 && rest <= allowed).then(|| evolution.after_cycles(before, state, count - 1 - done))
}
