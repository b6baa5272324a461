//! Reversals in time: resolved one by one, or averaged where their cycles are short against wear.
//!
//! Over a cycle of the length T the gap strays from the mean of the cycle by `d(t) = integral of (w'_k - mean w') dt`, which is what an average leaves out, to
//! first order in T. A rough run that averages tells it, at its end: where `d` without its rigid part is less than a part of the accuracy asked for, no finer
//! look at the cycles would change the answer.

use meshing::Cut;
use nalgebra::DMatrix;
use shapeopt::{Evolution, EvolutionStatus, Measure, Stepping, closing, difference_of_gaps};

use crate::effort::Effort;
use crate::ladder::Refusal;
use crate::problem::{Cycles, Problem};
use crate::stage::Stage;
use crate::step::Step;
use crate::steps::wear::level::with_lowest_rigid_part;
use crate::steps::wear::pieces::Pieces;
use crate::steps::wear::problem::{Loads, wear_problem};
use crate::steps::wear::ran::MOST_STEPS;
use crate::turns_result::TurnsResult;

/// Part of the accuracy asked for that an average over cycles may leave out.
const PART: f64 = 0.3;
/// Degree and error of the run that tells what it leaves out.
const FIRST: usize = 4;
const ROUGH: f64 = 1e-3;
/// Steps that a piece takes at least, about, where it is resolved.
const STEPS: f64 = 2.0;

/// The pieces of a run: as they are, repeated, or their mean.
pub(super) fn pieces(stage: Stage<'_>) -> Result<(Pieces, Effort), Refusal> {
    let problem = stage.problem;
    let Some(cycles) = problem.cycles else {
        return Ok((endless(problem), Effort::default()));
    };
    let once = Pieces::of(problem);
    let mean = once.averaged();
    let (ripple, effort) = ripple(stage, &once, &mean)?;
    let steps = STEPS * cycles.count * once.intervals.len() as f64;
    let short = ripple <= PART * stage.accuracy();
    let averaged = short || steps > MOST_STEPS as f64;
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
        period: cycles.map(|(cycles, _)| cycles.period),
        ripple: cycles.map(|(_, ripple)| ripple),
        shares: pieces.shares.clone().unwrap_or_default(),
    }
}

/// How far the gap strays from its mean within a cycle at the end of a rough run, without its rigid part, over the largest gap.
fn ripple(stage: Stage<'_>, once: &Pieces, mean: &Pieces) -> Result<(f64, Effort), Refusal> {
    let (reduced, mut effort) = stage.reduced(stage.problem.level(FIRST), Cut::Plain)?;
    let pair = reduced.pair()?;
    let operator = effort.timed(Step::Interface, stage.clock(), |_| reduced.operator(&pair, stage.friction() > 0.0))?;
    let began = stage.clock()();
    let stages = mean.problems.iter().map(|problem| stage.with(problem)).collect::<Result<Vec<Stage<'_>>, scene::Fault>>()?;
    let loads: Vec<contact::ContactLoad> = stages.iter().map(|stage| stage.contact_load(operator.points())).collect();
    let mut problem = wear_problem(Loads { stages: &stages, loads: &loads, begun: None }, mean, &operator, 0.0)?;
    problem.stepping = Stepping::Adaptive { accuracy: ROUGH };
    let mut evolution = Evolution::new(&problem).map_err(|error| Refusal::Reason(error.to_string()))?;
    evolution.by_ref().take(MOST_STEPS).for_each(drop);
    if *evolution.status() != EvolutionStatus::TimeReached {
        return Err(Refusal::Reason(evolution.status().to_string()));
    }
    let (state, rates) = (evolution.state(), evolution.rates_by_turns());
    effort.counters.contact_solves += 1;
    effort.counters.wear_steps += state.step;
    effort.add_seconds(Step::Evolution, stage.clock()() - began);
    let rows: Vec<f64> = operator.points().iter().flat_map(|point| closing(&pair, point)).collect();
    let modes = DMatrix::from_row_slice(state.gap.len(), rows.len() / state.gap.len().max(1), &rows);
    let gap = with_lowest_rigid_part(stage, &pair, &operator, &state.gap);
    let mut strayed = gap.clone();
    let mut most = 0.0_f64;
    for piece in &once.intervals {
        let apart = rates[piece.stage].iter().zip(&state.gap_rate).map(|(rate, mean)| piece.duration * (rate - mean));
        strayed.iter_mut().zip(apart).for_each(|(gap, d)| *gap += d);
        most = most.max(difference_of_gaps(&strayed, &gap, &modes, Measure::Largest));
    }
    Ok((most, effort))
}
