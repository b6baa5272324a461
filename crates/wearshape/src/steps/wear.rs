//! The wear stage: the gap in time, from the start gap until it is steady or a time is over.

mod columns;
mod cycles;
mod earlier;
mod final_ends;
mod found_ends;
mod gaps;
mod grown;
mod history;
mod hot;
mod integration_error;
mod level;
mod mesh_lines;
mod open_ends;
mod pieces;
mod problem;
mod ran;
mod rigid_scar;
mod rough;
mod round;
mod round_mesh;
mod round_result;
mod run;
mod samples;
mod scar;
mod torque;
mod track;
mod turns;

use std::ops::ControlFlow;

use earlier::check_degrees;
use level::{Known, Mesh, Unfinished};
use nalgebra::DMatrix;
use pieces::Pieces;
use problem::STEPS;
use ran::Ran;
use shapeopt::{EvolutionStatus, Measure, WearState, difference_of_gaps};

use crate::effort::Effort;
use crate::ladder::{Climbed, Ladder, Refusal, best, climb, errors, missed};
use crate::level::Level;
use crate::problem::End;
use crate::results::WearResult;
use crate::solution::Status;
use crate::stage::Stage;
use crate::step::Step;
use crate::steps::all_around;
use crate::steps::answer::Outcome;
use crate::steps::pressure_ends::bends;
use crate::steps::shape::FLAT;
use crate::watch::{FinishedLevel, Resume, Watch};

/// A level: what it leaves behind for the others, and what is reported if it is the last.
struct Solved {
    left: FinishedLevel,
    run: Option<Ran>,
}

pub(crate) use self::round::RoundWear;

/// Runs the wear in time.
pub(crate) fn solve(stage: Stage<'_>, watch: &mut Watch<'_>) -> Result<(Outcome, Effort), Refusal> {
    let (pieces, work) = turns::pieces(stage)?;
    let (ends, search) = if stage.grows() { grown::nodes(stage, &pieces)? } else { final_ends::final_ends(stage, &pieces)? };
    let mut ladder = levels(stage);
    // A level that an earlier run did not finish may be any.
    let within = stage.options.resume.is_some_and(|resume| resume.finished.is_empty() && !resume.states.is_empty());
    let (mut outcome, mut effort) = loop {
        match (solve_at(stage, &pieces, (&ladder, &ends), watch), ladder.finer()) {
            (Err(Refusal::TooCoarse(_)), Some(finer)) => ladder = finer,
            (Err(Refusal::Fault(_)), Some(finer)) if within => ladder = finer,
            (done, _) => break done?,
        }
    };
    all_around::refuse_full(stage, &mut outcome);
    effort += work.aside();
    effort += search.aside();
    Ok((outcome, effort))
}

/// The levels of a run: of one that goes on with another those from the first that this has finished.
fn levels(stage: Stage<'_>) -> Ladder {
    let known = stage.options.resume.and_then(|resume| resume.finished.first());
    let mut ladder = Ladder::of(stage.problem, stage.options, Step::Evolution);
    while known.is_some_and(|first| ladder.levels[0].degree < first.degree)
        && let Some(finer) = ladder.finer()
    {
        ladder = finer;
    }
    ladder
}

/// The levels of a run, and the places that are known.
type On<'a> = (&'a Ladder, &'a [f64]);

/// The same on meshes with nodes at places that are known, from -1 to 1 along the surface, or at those that the first level finds.
fn solve_at(stage: Stage<'_>, pieces: &Pieces, on: On<'_>, watch: &mut Watch<'_>) -> Result<(Outcome, Effort), Refusal> {
    let (ladder, known_ends) = on;
    let (known, mut states) = taken_up(stage, ladder)?;
    let (mut cut, mut given_up, mut effort) = (None, None, Effort::default());
    let run = |level: Level, before: &[Solved], states: Vec<WearState>, watch: &mut Watch<'_>| {
        let finished = lefts(before);
        let mesh = Mesh { level, ends: known_ends, known: known_ends };
        found_ends::run(stage, pieces, mesh, Known { finished: &finished, states }, watch)
    };
    let solve = |level: Level, before: &[Solved], watch: &mut Watch<'_>| {
        let (left, ran) = match run(level, before, std::mem::take(&mut states), watch)? {
            Ok(done) => done,
            Err(unfinished) => {
                cut = Some(unfinished);
                return Ok(ControlFlow::Break(None));
            }
        };
        if let Some(why) = ran.failure().filter(|_| ladder.can_do_without(before)) {
            effort += ran.effort;
            given_up = Some(format!("the level of degree {} has no end ({why})", level.degree));
            return Err(Refusal::Reason(why));
        }
        ladder.unordered(traces(stage, &left));
        // Of a fixed discretisation coarser levels tell the error alone: one that is too coarse for the heat ends nothing.
        let coarser = ladder.is_fixed() && ladder.levels.last() != Some(&level);
        let ends = match ran.ended {
            EvolutionStatus::Unstable { .. } => !coarser,
            ref ended => matches!(ended, EvolutionStatus::Stuck { .. } | EvolutionStatus::Unreached { .. }),
        };
        let solved = Solved { left, run: Some(ran) };
        Ok(if ends { ControlFlow::Break(Some(solved)) } else { ControlFlow::Continue(solved) })
    };
    let decisive = decisive(stage, pieces.left_out());
    let Climbed { mut solved, mut stopped } = climb(ladder, known, solve, decisive, watch)?;
    for level in &solved {
        effort += level.run.as_ref().map_or_else(|| before(&level.left), |ran| ran.effort.clone());
    }
    let found = if stopped { None } else { best(ladder, &solved, &decisive) };
    let found = found.map(|(count, known)| (count, with_times(stage, &solved[..count], pieces.left_out(), known)));
    let levels = solved.len();
    if let Some((count, _)) = found.filter(|(count, _)| *count < levels || given_up.is_some()) {
        // Run again, so that the recording holds the level that is reported, also where this run has gone on with another.
        solved.truncate(count);
        match run(ladder.levels[count - 1], &solved[..count - 1], Vec::new(), watch)? {
            Ok((_, ran)) => solved[count - 1].run = Some(ran),
            Err(unfinished) => (cut, stopped) = (Some(unfinished), solved.pop().is_some()),
        }
    }
    let states = match cut {
        Some(Unfinished::Unfit(fault)) => return Err(fault.into()),
        Some(Unfinished::Stopped(history)) => history.states,
        None => Vec::new(),
    };
    let resume = stopped.then(|| Resume { finished: lefts(&solved), states });
    let outcome =
        finish((stage, pieces), ladder, solved, Levels { count: levels, given_up, errors: found.map(|(_, errors)| errors) });
    Ok((Outcome { stopped, resume, ..outcome }, effort))
}

/// The levels of an earlier run, and the states of the one that it did not finish.
fn taken_up(stage: Stage<'_>, ladder: &Ladder) -> Result<(Vec<Solved>, Vec<WearState>), Refusal> {
    let resume = stage.options.resume.cloned().unwrap_or_default();
    check_degrees(&resume, ladder)?;
    resume.finished.iter().for_each(|left| ladder.unordered(traces(stage, left)));
    Ok((resume.finished.into_iter().map(|left| Solved { left, run: None }).collect(), resume.states))
}

/// What levels leave behind.
fn lefts(solved: &[Solved]) -> Vec<FinishedLevel> {
    solved.iter().map(|level| level.left.clone()).collect()
}

/// Work of a level of an earlier run.
fn before(left: &FinishedLevel) -> Effort {
    let mut effort = Effort::default();
    effort.counters.factorisations = left.factorisations;
    effort.counters.contact_solves = left.contact_solves;
    effort.counters.wear_steps = left.wear_steps;
    effort
}

/// How far two levels are apart: the difference of their worn gaps, modulo the rigid part, over the largest gap, and the relative difference of their
/// times to the steady pressure (0 without them) over the part of the accuracy that the steps leave to the levels.
fn distance(a: &Solved, b: &Solved) -> [f64; 2] {
    let (a, b) = (&a.left, &b.left);
    if is_flat(a) && is_flat(b) {
        return [0.0, times_apart(a, b)];
    }
    let points = b.gap.len();
    let closing = DMatrix::from_row_slice(points, b.closing.len() / points.max(1), &b.closing);
    [difference_of_gaps(&a.gap, &b.gap, &closing, Measure::Largest), times_apart(a, b)]
}

/// Whether a level has no worn gap: what there is is round-off.
fn is_flat(level: &FinishedLevel) -> bool {
    level.gap.iter().fold(0.0_f64, |most, gap| most.max(gap.abs())) <= FLAT * level.moved
}

/// The relative difference of the times of two levels to the steady pressure over the part of the accuracy that the steps leave to the levels.
fn times_apart(a: &FinishedLevel, b: &FinishedLevel) -> f64 {
    let apart = |(a, b): (f64, f64)| if a == b { 0.0 } else { ((a - b) / b).abs() };
    a.to_1_percent.zip(b.to_1_percent).map_or(0.0, apart) / (1.0 - STEPS)
}

/// What the steps leave wrong in the gap at the end; nothing where the wear has become steady, which no longer knows its steps.
fn of_steps(stage: Stage<'_>, level: &Solved) -> f64 {
    let on_the_way = stage.problem.wear.until.is_some() && level.left.to_1_percent.is_none();
    level.left.integration_error.filter(|_| stage.ends_move() || on_the_way).unwrap_or(0.0)
}

/// How far two levels of a stage are apart. Where the end of contact moves over the elements, levels fall with a power of the degree only: their
/// differences count so many times, but where the largest of them is told. What is left out besides has its part of the accuracy ([`part_of_levels`]).
fn apart(stage: Stage<'_>, left_out: f64) -> impl Fn(&Solved, &Solved) -> [f64; 2] + Copy {
    let on_the_way = stage.problem.wear.until.is_some() && stage.problem.heat.is_none();
    let by_wear = matches!(stage.problem.wear.until, Some(End::Depth(_) | End::Volume(_)));
    move |a, b| {
        let [gap, time] = distance(a, b);
        let unsettled = b.left.partial && b.left.ends.is_empty() && b.left.to_1_percent.is_none();
        let times = match (stage.facing(), stage.grows(), on_the_way && unsettled) {
            (true, _, _) => 3.0,
            (false, false, true) => 2.0,
            (false, true, _) | (false, false, false) => 1.0,
        };
        // Where the wear ends a run, its time is an answer.
        let ends = if by_wear { ((a.left.time - b.left.time) / b.left.time).abs() } else { 0.0 };
        [times * gap / part_of_levels(stage, b, left_out), times * time.max(ends / (1.0 - STEPS))]
    }
}

/// Part of the accuracy that the steps, where the gap at the end has their error too, and a mean over cycles leave to the levels.
fn part_of_levels(stage: Stage<'_>, level: &Solved, left_out: f64) -> f64 {
    1.0 - (of_steps(stage, level) / stage.accuracy()).min(STEPS) - (left_out / stage.accuracy()).min(turns::PART)
}

/// Differences of the last levels of a run that ends on the way of which the largest is its error, where ends of contact move by heat or towards no known
/// place: what they pass over once leaves its trace in the gap, which levels have in no order; of two circles each level has nodes of its own besides.
/// Without heat an end may stay at the end of a cell for some levels. Nor are they in order where a wear rule bends at some pressures, wherever in the elements these are.
fn traces(stage: Stage<'_>, level: &FinishedLevel) -> Option<usize> {
    let hot = stage.problem.heat.is_some() && stage.problem.wear.until.is_some();
    let bends = !bends(stage.problem).is_empty();
    match (hot || stage.grows(), level.ends.is_empty()) {
        (true, _) => Some(2),
        (false, false) => Some(3),
        (false, true) => bends.then_some(1),
    }
}

/// How far two levels are apart in what decides whether they are enough. Heat opens a contact that is not worn in: its ends move over the elements
/// meanwhile, and times fall with a power of the degree only. There the gap decides, and the error of the times is told.
fn decisive(stage: Stage<'_>, left_out: f64) -> impl Fn(&Solved, &Solved) -> [f64; 2] + Copy {
    let apart = apart(stage, left_out);
    let hot = stage.problem.heat.is_some();
    move |a, b| {
        let [gap, time] = apart(a, b);
        [gap, if hot { 0.0 } else { time }]
    }
}

/// Estimated errors of gap and times of the last of some levels, whose gap alone decided that they are enough where the run is hot.
fn with_times(stage: Stage<'_>, solved: &[Solved], left_out: f64, known: [f64; 2]) -> [f64; 2] {
    let hot = errors(solved, &apart(stage, left_out)).filter(|_| stage.problem.heat.is_some());
    hot.map_or(known, |[_, time]| [known[0], time])
}

/// How far two levels are apart in what is worn off, which the gap does not tell where a rigid part of it is left open.
fn worn_apart(a: &Solved, b: &Solved) -> f64 {
    let relative = |a: f64, b: f64| if a == b { 0.0 } else { ((a - b) / b).abs() };
    let [(before, a), (after, b)] = [a, b].map(|level| (level.left.depth, level.left.volumes));
    a.into_iter().zip(b).fold(relative(before, after), |most, (a, b)| most.max(relative(a, b)))
}

/// Estimated relative error of the time to the steady pressure: of the steps, and the rest of the series of the levels. Of a run without such a
/// time that of its depth and its volumes; none before there are three levels.
fn run_in_error(ladder: &Ladder, solved: &[Solved], errors: Option<[f64; 2]>) -> Option<f64> {
    let steps = solved.last()?.left.integration_error?;
    if solved.iter().all(|level| level.left.to_1_percent.is_none()) {
        let worn = if ladder.is_fixed() {
            ladder.error_in_time(solved, &worn_apart)
        } else {
            ladder.errors(solved, &|a, b| [worn_apart(a, b)]).map(|[worn]| worn)
        };
        return errors.zip(worn).map(|([gap, _], worn)| gap.max(worn) + steps);
    }
    let known = solved.iter().rev().take(3).all(|level| level.left.to_1_percent.is_some());
    errors.filter(|_| known).map(|[_, time]| (1.0 - STEPS) * time + steps)
}

/// What climbing has come to.
struct Levels {
    /// Number of levels solved.
    count: usize,
    /// Why a finer one is not among them.
    given_up: Option<String>,
    /// Estimated errors of the one to report, of a ladder without end.
    errors: Option<[f64; 2]>,
}

/// A groove too deep for a contact that knows it by its mean around the axis of the ball: the square of this ratio is left out.
const DEEP: f64 = 0.3;

/// The end of a run whose groove is too deep.
fn too_deep(wear: Option<&WearResult>) -> Option<(Status, String)> {
    let ratio = wear?.groove.as_ref()?.depth_ratio;
    let why = format!(
        "the groove in body 2 is {} of the depth worn off body 1, so that the contact has no symmetry about the axis of the ball: this answer is none",
        scene::short(ratio)
    );
    (ratio > DEEP).then_some((Status::AccuracyMissed, why))
}

/// Whether all levels of a run with heat came to a steady pressure, or none did: one that the heat ended before tells no error.
fn alike(stage: Stage<'_>, solved: &[Solved]) -> bool {
    let steady = |level: &Solved| level.left.to_1_percent.is_some();
    stage.problem.heat.is_none() || solved.iter().all(|level| Some(steady(level)) == solved.last().map(steady))
}

fn finish((stage, pieces): (Stage<'_>, &Pieces), ladder: &Ladder, mut solved: Vec<Solved>, levels: Levels) -> Outcome {
    let left_out = pieces.left_out();
    let distance = apart(stage, left_out);
    let mut outcome = Outcome { ladder: ladder.rungs(&solved, ("gap", 0), distance), ..Outcome::default() };
    let of = |k: usize| ladder.error_in_time(&solved, &|a, b| distance(a, b)[k]);
    let errors = if ladder.is_fixed() && !alike(stage, &solved) {
        None
    } else if ladder.is_fixed() {
        of(0).zip(of(1)).map(|(gap, time)| [gap, time])
    } else {
        levels.errors
    };
    // The depth of a round contact is the worn gap itself, with what the steps leave in it.
    let part = solved.last().map_or(1.0, |level| part_of_levels(stage, level, left_out));
    let errors = errors.map(|[gap, time]| [part * gap, time]);
    let steps = solved.last().map_or(0.0, |level| of_steps(stage, level));
    let error = errors.map(|[gap, _]| gap + steps);
    outcome.tell(error.filter(|_| ladder.is_fixed()));
    let run_in_error = run_in_error(ladder, &solved, errors);
    let reported = solved.len();
    let Some(last) = solved.pop().and_then(|level| level.run) else { return outcome };
    let failure = last.failure();
    let run_in_error = run_in_error.filter(|_| failure.is_none());
    outcome.wear = Some(WearResult { run_in_error, ..last.wear });
    outcome.history = last.history;
    outcome.groove = last.groove;
    outcome.running_in = Some(last.running_in);
    outcome.told = Some(last.told);
    outcome.reported = last.reported;
    outcome.heat = last.heat;
    outcome.ended = failure.map(|why| (Status::NotConverged, why)).or(too_deep(outcome.wear.as_ref()));
    let Some(error) = error.filter(|_| outcome.ended.is_none()).map(|error| error + left_out) else { return outcome };
    outcome.error.gap_relative = Some(error);
    outcome.error.how = if stage.ends_move() {
        format!("depth worn off along the surface at the end: {}, and of the steps", ladder.told_by(levels.count))
    } else {
        let of_steps = if steps > 0.0 { ", and of the steps" } else { "" };
        format!("gap at the end: {}{of_steps}", ladder.told_by(levels.count))
    };
    if left_out > 0.0 {
        outcome.error.how += ", and what the mean over the cycles leaves out";
    }
    if reported < levels.count || levels.given_up.is_some() {
        outcome.error.how += &format!("; the best of them is reported, of degree {}", ladder.levels[reported - 1].degree);
    }
    outcome.error.how += &levels.given_up.map_or_else(String::new, |why| format!("; {why}"));
    if ladder.missed(error).is_some() {
        outcome.ended = Some((Status::AccuracyMissed, missed("worn gap", error, stage.accuracy())));
    }
    outcome
}
