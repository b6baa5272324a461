//! What an earlier run left behind, checked before it is gone on with.

use scene::Fault;
use shapeopt::{WearProblem, WearState};

use crate::ladder::Ladder;
use crate::watch::{FinishedLevel, Resume};

/// Refuses an unfinished run that is not one on these levels.
///
/// # Errors
/// `another-recording` with the level that is not one of them.
pub(super) fn check_degrees(resume: &Resume, ladder: &Ladder) -> Result<(), Fault> {
    if resume.finished.len() >= ladder.levels.len() {
        return Err(unfit(&format!(
            "it has {} finished levels, of {} that there are",
            resume.finished.len(),
            ladder.levels.len()
        )));
    }
    let other = resume.finished.iter().zip(&ladder.levels).find(|(left, l)| (left.degree, left.layers) != (l.degree, l.layers));
    let what = |left: &FinishedLevel| format!("it has a level of degree {} with {} layers", left.degree, left.layers);
    other.map_or(Ok(()), |(left, _)| Err(unfit(&what(left))))
}

/// Refuses finished levels whose lists are not those of `samples` points with `modes` closings each.
///
/// # Errors
/// `another-recording` with the level.
pub(super) fn check_levels(finished: &[FinishedLevel], samples: usize, modes: usize) -> Result<(), Fault> {
    for level in finished {
        let fits = level.gap.len() == samples && level.closing.len() == samples * modes;
        let times = [Some(level.time), Some(level.moved), level.to_1_percent, level.integration_error].into_iter().flatten();
        let finite =
            level.gap.iter().chain(&level.closing).all(|v| v.is_finite()) && times.into_iter().all(|t| t >= 0.0 && t.is_finite());
        let counts =
            [level.wear_steps, level.factorisations, level.contact_solves].iter().all(|count| *count <= u32::MAX as usize);
        let inside = level.ends.iter().all(|end| end.abs() < 1.0);
        if !(fits && finite && counts && inside) {
            let what = "numbers of its level of degree";
            return Err(unfit(&format!("{what} {} are not those of {samples} points with {modes} free motions", level.degree)));
        }
    }
    Ok(())
}

/// Refuses states that are not of the contact points of a run; the last one must be whole.
///
/// # Errors
/// `another-recording` with the step.
pub(super) fn check_states(states: &[WearState], problem: &WearProblem) -> Result<(), Fault> {
    let points = problem.points.len();
    let long = |list: &Vec<f64>, length: usize| list.len() == length && list.iter().all(|v| v.is_finite());
    let right = |list: &Vec<f64>| long(list, points);
    let loaded = |list: &Vec<f64>| long(list, problem.values());
    let part = |state: &WearState| {
        let times = [state.time, state.interval_start].iter().all(|t| t.is_finite());
        times
            && state.interval < problem.schedule.len()
            && [&state.gap, &state.worn].into_iter().all(right)
            && loaded(&state.pressure)
            && (state.conducting.is_empty() || state.conducting.len() == points)
    };
    let whole = |state: &WearState| {
        let free = problem.coordinates(state.interval);
        let moved = [&state.coordinates, &state.approach].iter().all(|list| list.len() == free);
        moved && loaded(&state.opening) && right(&state.gap_rate)
    };
    let wrong = states.iter().find(|state| !part(state)).or_else(|| states.last().filter(|last| !whole(last)));
    wrong.map_or(Ok(()), |state| Err(unfit(&format!("its step {} is not one of {points} contact points", state.step))))
}

fn unfit(what: &str) -> Fault {
    let message = format!("the recording to go on from does not belong to this run: {what}");
    Fault::new("another-recording", message, "leave out --resume to begin again without it")
}
