//! The wear problem of a level: contact points, wear rules, start gap, and the loads of the schedule.

use contact::{ContactLoad, ContactOperator, Status as ContactStatus};
use shapeopt::faer::Mat;
use shapeopt::{LoadStage, Scheme, Stepping, Times, Until, WearProblem};
use wear::{Counterface, Groove};

use crate::ladder::Refusal;
use crate::problem::End;
use crate::stage::Stage;
use crate::steps::start_gap::start_gaps;
use crate::steps::wear::history::DEVIATION;
use crate::steps::wear::pieces::Pieces;

/// Certificate of the steady state.
const STEADY: f64 = 1e-9;
/// Part of the accuracy asked for that the wear still to come may make where the contact wears itself free or the run ends by a time, depth or volume.
const REST: f64 = 0.01;

/// Error of the steps of a contact that grows over the accuracy asked for at the end, and the roughest accuracy by which they go.
const ROUND: f64 = 10.0;
/// The same of a ball or cylinder on a flat, which goes by the method of order two.
const ROUND_ON_FLAT: f64 = 60.0;
const ROUGHEST: f64 = 2e-4;

/// Accuracies below which steps in time become no finer, of flat and of round contacts: a hundred thousand steps would gain no digit that the
/// levels have. What is missed then is told.
const FINEST: f64 = 1e-9;
const FINEST_ROUND: f64 = 1e-6;

/// How many times as close as its points a profile is looked at for its largest depth, which else is off by the square of their distances.
const CLOSER: usize = 16;
/// Roughest accuracy of the steps of a run until a given end: coarser ones pass over the corners of a punch, whose wear is fast at first, in one step.
const ROUGHEST_SHORT: f64 = 1e-3;

/// Part of the accuracy asked for that steps in time may take from what is reported; the rest is left to the levels.
pub(super) const STEPS: f64 = 0.3;

/// The residual at which a run is steady: of the certificate, or of the wear still to come under a prescribed approach.
pub(super) fn steady_residual(stage: Stage<'_>) -> f64 {
    if stage.problem.load.approach.is_some() { STEADY.max(REST * stage.accuracy()) } else { STEADY }
}

/// The residual at which a run has come to its steady state; one that ends on the way need not come closer than the accuracy asks for.
pub(super) fn residual_at_end(stage: Stage<'_>) -> f64 {
    let by_accuracy = if stage.problem.wear.until.is_some() { REST * stage.accuracy() } else { 0.0 };
    steady_residual(stage).max(by_accuracy)
}

/// Pressure (MPa) and opening (mm) at the start, on the start gap (mm); of loads that act by turns one load after the other.
fn begun(operator: &ContactOperator<'_>, pieces: &Pieces, loads: &[ContactLoad], gap: &[f64]) -> Result<[Vec<f64>; 2], Refusal> {
    let first = pieces.intervals[0].stage;
    let acting = if pieces.shares.is_some() { loads } else { &loads[first..=first] };
    let mut begun = [Vec::new(), Vec::new()];
    for load in acting {
        let start = operator.solve(gap, load, None).map_err(|error| Refusal::Reason(error.to_string()))?;
        if !start.status.is_solved() || start.status == ContactStatus::NoContact {
            return Err(Refusal::Reason(start.status.to_string()));
        }
        begun[0].extend(start.pressure);
        begun[1].extend(start.opening);
    }
    Ok(begun)
}

/// Places between the contact points, by what interpolates there.
fn between(operator: &ContactOperator<'_>) -> Vec<(usize, Vec<f64>)> {
    let (pair, points) = (operator.pair(), operator.points());
    let parts = points
        .windows(2)
        .flat_map(|ends| (1..CLOSER).map(|k| ends[0].arc + (ends[1].arc - ends[0].arc) * k as f64 / CLOSER as f64));
    parts.map(|arc| pair.shapes_at(points, arc)).map(|(range, shapes)| (*range.start(), shapes)).collect()
}

/// The different loads that occur: their stages and what acts in each.
#[derive(Clone, Copy)]
pub(super) struct Loads<'a> {
    pub stages: &'a [Stage<'a>],
    pub loads: &'a [ContactLoad],
    /// Pressure (MPa) and opening (mm) at the start, where they are known.
    pub begun: Option<&'a [Vec<f64>; 2]>,
}

/// The wear problem on an operator; `pieces` tell which load acts when. A run until the steady state goes on to the time `not_before` at least.
pub(super) fn wear_problem(
    Loads { stages, loads, begun: known }: Loads<'_>,
    pieces: &Pieces,
    operator: &ContactOperator<'_>,
    not_before: f64,
) -> Result<WearProblem, Refusal> {
    let reason = |error: contact::Error| Refusal::Reason(error.to_string());
    let intervals = &pieces.intervals;
    let stage = stages[intervals[0].stage];
    let surface = |stage: &Stage<'_>| -> Vec<wear::SurfacePoint> {
        operator.points().iter().map(|p| stage.surface_point(p.position, p.normal, p.weight)).collect()
    };
    let (laws, counterface) = stage.rules()?;
    let gap = start_gaps(stage, operator);
    let begun = known.cloned().map_or_else(|| begun(operator, pieces, loads, &gap), Ok)?;
    let mut load_stages = Vec::new();
    for (stage, load) in stages.iter().zip(loads) {
        let speeds = surface(stage).iter().map(|p| p.sliding_speed).collect();
        load_stages.push(LoadStage { system: operator.system(load).map_err(reason)?, speeds, heated: None });
    }
    let first = load_stages[intervals[0].stage].system.clone();
    let mut problem = WearProblem::new(surface(&stage), laws, counterface, gap, first);
    problem.stages = load_stages;
    problem.schedule.clone_from(intervals);
    problem.shares.clone_from(&pieces.shares);
    problem.start = Some(begun);
    problem.between = between(operator);
    problem.track_area = stage.patch.surface.track_area();
    problem.until = Until::Steady { residual: steady_residual(stage), not_before };
    let accuracy = stage.accuracy().max(FINEST);
    problem.times = Some(Times { deviation: DEVIATION, accuracy: STEPS * accuracy });
    if let Some(end) = stage.problem.wear.until {
        problem.until = match end {
            End::Time(time) => Until::Time(time),
            End::Depth(depth) => Until::Depth(depth),
            End::Volume(volume) => Until::Volume(volume),
        };
        problem.stepping = Stepping::Adaptive { accuracy: (STEPS * accuracy).min(ROUGHEST_SHORT) };
    }
    if stage.ends_move() {
        (problem.scheme, problem.stepping) = growing(stage);
        problem.times = None;
        problem.growing = true;
    }
    if stage.facing() {
        let start = stage.start(operator.pair());
        let places: Vec<f64> = operator.points().iter().map(|p| start + p.arc).collect();
        problem.passing = stage.problem.track().map(|track| {
            let mean = Groove::new(track, &places).mean();
            Mat::from_fn(places.len(), places.len(), |i, j| mean[(i, j)])
        });
        problem.counterface = if problem.passing.is_some() { Counterface::Fresh } else { counterface };
    }
    Ok(problem)
}

/// How a contact that grows is integrated. Points that come into contact bend the rates, and the error of their steps falls with the wear after them. A flat
/// worn on a ball is deep against all that the bodies give way by: for a step its points come into contact at once, which the weights of the method of order
/// four, up to 8 and of both signs, throw about.
fn growing(stage: Stage<'_>) -> (Scheme, Stepping) {
    let (scheme, share) = if stage.facing() { (Scheme::Sdirk2, ROUND_ON_FLAT) } else { (Scheme::Sdirk4, ROUND) };
    (scheme, Stepping::Adaptive { accuracy: share * stage.accuracy().clamp(FINEST_ROUND, ROUGHEST) })
}
