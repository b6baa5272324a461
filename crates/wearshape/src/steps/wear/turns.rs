//! Reversals in time: resolved one by one, or averaged where their cycles are short against wear.
//!
//! Over a cycle of the length T the gap strays from the mean of the cycle by `d(t) = integral of (w'_k - mean w') dt`, which is what an average leaves out, to
//! first order in T. A rough run that averages tells it, at its end: where `d` without its rigid part is less than a part of the accuracy asked for, no finer
//! look at the cycles would change the answer.

use meshing::Cut;
use nalgebra::DMatrix;
use shapeopt::{Evolution, EvolutionStatus, Measure, Stepping, Until, WearProblem, closing, difference_of_gaps};

use crate::effort::Effort;
use crate::ladder::Refusal;
use crate::problem::{Cycles, Problem};
use crate::stage::Stage;
use crate::step::Step;
use crate::steps::wear::gaps::with_lowest_rigid_part;
use crate::steps::wear::pieces::Pieces;
use crate::steps::wear::problem::{Loads, wear_problem};
use crate::steps::wear::ran::MOST_STEPS;
use crate::turns_result::TurnsResult;

/// Part of the accuracy asked for that an average over cycles may leave out.
pub(super) const PART: f64 = 0.3;
/// Degree and error of the run that tells what it leaves out.
const FIRST: usize = 4;
const ROUGH: f64 = 1e-3;
/// Steps of a fine level over those of the rough one (2.3 to 3 were met).
const FINER: f64 = 3.0;
/// Most pieces of cycles one after the other.
const MOST_PIECES: f64 = 1e6;

/// The pieces of a run: as they are, repeated, or their mean.
pub(super) fn pieces(stage: Stage<'_>) -> Result<(Pieces, Effort), Refusal> {
    let problem = stage.problem;
    let Some(cycles) = problem.cycles else {
        return Ok((endless(problem), Effort::default()));
    };
    let once = Pieces::of(problem);
    let mean = once.averaged();
    let (Rough { ripple, steps }, effort) = rough(stage, &once, &mean, cycles)?;
    let short = ripple <= PART * stage.accuracy();
    let averaged = short || steps > MOST_STEPS as f64 || cycles.count * once.intervals.len() as f64 > MOST_PIECES;
    let strays = format!("within a cycle the gap strays from its mean by {} of its size", scene::short(ripple));
    let because = match (short, averaged) {
        (true, _) => format!("{strays}, less than {} of the accuracy asked for", scene::short(PART)),
        (false, true) => format!("{strays}, and to resolve so many of them takes too many steps: the error counts it"),
        (false, false) => format!("{strays}, more than {} of the accuracy asked for", scene::short(PART)),
    };
    let pieces = if averaged { mean } else { once.repeated(cycles.count as usize) };
    let turns = Some(told(&pieces, because, Some((cycles, ripple))));
    Ok((Pieces { turns, ..pieces }, effort))
}

/// The pieces of a run without cycles of a known length.
fn endless(problem: &Problem) -> Pieces {
    let Some(share) = problem.reversing else { return Pieces::of(problem) };
    let pieces = Pieces::both_ways(problem, share);
    let turns = told(&pieces, "sliding.reversing has cycles short against wear".into(), None);
    Pieces { turns: Some(turns), ..pieces }
}

fn told(pieces: &Pieces, because: String, cycles: Option<(Cycles, f64)>) -> TurnsResult {
    TurnsResult {
        averaged: pieces.shares.is_some(),
        because,
        cycles: cycles.map(|(cycles, _)| cycles.count),
        resolved: None,
        period: cycles.map(|(cycles, _)| cycles.period),
        ripple: cycles.map(|(_, ripple)| ripple),
        shares: pieces.shares.clone().unwrap_or_default(),
    }
}

/// What a rough run that averages tells of the cycles.
struct Rough {
    /// How far the gap strays from its mean within a cycle at the end, without its rigid part, over the largest gap.
    ripple: f64,
    /// Steps that it takes to resolve the cycles until all that follow are alike, about.
    steps: f64,
}

fn rough(stage: Stage<'_>, once: &Pieces, mean: &Pieces, cycles: Cycles) -> Result<(Rough, Effort), Refusal> {
    let (reduced, mut effort) = stage.reduced(stage.problem.level(FIRST), Cut::Plain)?;
    let pair = reduced.pair()?;
    let operator = effort.timed(Step::Interface, stage.clock(), |_| reduced.operator(&pair, stage.friction() > 0.0))?;
    let began = stage.clock()();
    let stages = mean.problems.iter().map(|problem| stage.with(problem)).collect::<Result<Vec<Stage<'_>>, scene::Fault>>()?;
    let loads: Vec<contact::ContactLoad> = stages.iter().map(|stage| stage.contact_load(operator.points())).collect();
    let acting = Loads { stages: &stages, loads: &loads, begun: None };
    let mut problem = wear_problem(acting, mean, &operator, 0.0)?;
    problem.stepping = Stepping::Adaptive { accuracy: ROUGH };
    let mut evolution = Evolution::new(&problem).map_err(|error| Refusal::Reason(error.to_string()))?;
    evolution.by_ref().take(MOST_STEPS).for_each(drop);
    if *evolution.status() != EvolutionStatus::TimeReached {
        return Err(Refusal::Reason(evolution.status().to_string()));
    }
    let state = evolution.state();
    let rows: Vec<f64> = operator.points().iter().flat_map(|point| closing(&pair, point)).collect();
    let modes = DMatrix::from_row_slice(state.gap.len(), rows.len() / state.gap.len().max(1), &rows);
    let gap = with_lowest_rigid_part(stage, &pair, &operator, &state.gap);
    let ripple = ripple(&evolution, once, &gap, &modes);
    let mut steps = 0.0;
    if ripple > PART * stage.accuracy() {
        let one = WearProblem {
            gap: state.gap.clone(),
            start: None,
            until: Until::Time(cycles.period),
            ..wear_problem(acting, once, &operator, 0.0)?
        };
        steps = FINER * steps_of(&one) * until_alike(stage, &evolution, cycles).min(cycles.count);
    }
    effort.counters.contact_solves += 1;
    effort.counters.wear_steps += state.step;
    effort.add_seconds(Step::Evolution, stage.clock()() - began);
    Ok((Rough { ripple, steps }, effort))
}

/// The largest `d(t)` of a cycle that begins with a gap, over its size, without its rigid part.
fn ripple(mean: &Evolution<'_>, once: &Pieces, gap: &[f64], modes: &DMatrix<f64>) -> f64 {
    let rates = mean.rates_by_turns();
    let mut strayed = gap.to_vec();
    let mut most = 0.0_f64;
    for piece in &once.intervals {
        let apart = rates[piece.stage].iter().zip(&mean.state().gap_rate).map(|(rate, mean)| piece.duration * (rate - mean));
        strayed.iter_mut().zip(apart).for_each(|(gap, d)| *gap += d);
        most = most.max(difference_of_gaps(&strayed, gap, modes, Measure::Largest));
    }
    most
}

/// Steps of one cycle; endless where it does not come to its end.
fn steps_of(cycle: &WearProblem) -> f64 {
    let Ok(mut evolution) = Evolution::new(cycle) else { return f64::INFINITY };
    evolution.by_ref().take(MOST_STEPS).for_each(drop);
    if *evolution.status() == EvolutionStatus::TimeReached { evolution.state().step as f64 } else { f64::INFINITY }
}

/// Number of cycles until the slowest mode of the mean has died away to a part of the accuracy; endless where there are no modes.
fn until_alike(stage: Stage<'_>, mean: &Evolution<'_>, cycles: Cycles) -> f64 {
    let state = mean.state();
    let slowest = mean.run_in().and_then(|modes| modes.distances.first().copied()).unwrap_or(f64::INFINITY);
    let time = slowest * state.time / state.distance;
    time * (1.0 / (PART * stage.accuracy())).ln() / cycles.period
}
