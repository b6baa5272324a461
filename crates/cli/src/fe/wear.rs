//! The wear stage: the gap in time, from the start gap until it is steady or a time is over.

use std::time::Instant;

use contact::{ContactOperator, Pair, Status as ContactStatus};
use nalgebra::DMatrix;
use shapeopt::{Curve, Evolution, EvolutionStatus, Stepping, Until, WearProblem, closing, lowest_nonnegative};

use crate::fault::Fault;
use crate::fe::bodies::Level;
use crate::fe::contact::{pressure_at, start_gap};
use crate::fe::recover::{Moment, Reported};
use crate::fe::shape::difference_of_gaps;
use crate::fe::stage::{Stage, add_times, note, rest};
use crate::fe::template::Cut;
use crate::gap;
use crate::profile::Profile;
use crate::record;
use crate::scene;
use crate::setup::Problem;
use crate::solution::{Counters, EnergyResult, Solution, Status, WearResult};
use crate::solve::{CURVE, Options, Sampling};

/// Samples of the gap for the comparison of levels.
const SAMPLES: usize = 201;
/// Certificate of the steady state.
const STEADY: f64 = 1e-9;
/// Most steps of a run.
const MOST_STEPS: usize = 20_000;
/// Run-in distances in the summary, slowest first.
const RUN_IN: usize = 4;

struct Solved {
    gaps: Vec<f64>,
    closing: DMatrix<f64>,
    ended: EvolutionStatus,
    /// For the fields: the end, then the start.
    reported: Option<Reported>,
    solution: Solution,
}

/// Runs the wear in time and fills in the solution.
pub(super) fn solve(problem: &Problem, options: Options, solution: &mut Solution) -> Result<Option<Reported>, Fault> {
    let stage = Stage::new(problem)?;
    let fixed = stage.fixed_level().is_some();
    let mut solved: Vec<Solved> = Vec::new();
    for level in stage.ladder(options) {
        if crate::interrupt::asked() {
            solution.status = Status::Interrupted;
            return Ok(None);
        }
        match run(stage, level, options)? {
            Ok(level) => solved.push(level),
            Err(reason) => {
                solution.status = Status::Refused;
                solution.reason = Some(reason);
                return Ok(None);
            }
        }
        let stuck = matches!(solved.last().map(|s| &s.ended), Some(EvolutionStatus::Stuck { .. }));
        if stuck || (!fixed && estimate(&solved).is_some_and(|error| error <= stage.accuracy())) {
            break;
        }
    }
    // A run that the wish cut short says nothing about its end.
    if crate::interrupt::asked() {
        solution.status = Status::Interrupted;
        return Ok(None);
    }
    Ok(finish(stage, solved, fixed, solution))
}

/// Estimated `max |dg| / max g` at the end, modulo the rigid part.
fn estimate(solved: &[Solved]) -> Option<f64> {
    let [.., a, b, c] = solved else { return None };
    let difference = |a: &Solved, b: &Solved| difference_of_gaps(&a.gaps, &b.gaps, &b.closing);
    Some(rest(difference(a, b), difference(b, c)))
}

fn finish(stage: Stage<'_>, mut solved: Vec<Solved>, fixed: bool, solution: &mut Solution) -> Option<Reported> {
    let error = estimate(&solved);
    let levels = solved.len();
    let times: Vec<_> = solved.iter().map(|s| s.solution.times.clone()).collect();
    let total = |f: &dyn Fn(&Counters) -> usize| solved.iter().map(|s| f(&s.solution.counters)).sum::<usize>();
    let (steps, factorisations, solves) = (total(&|c| c.wear_steps), total(&|c| c.factorisations), total(&|c| c.contact_solves));
    let Solved { ended, reported, solution: last, .. } = solved.pop()?;
    add_times(&times, &mut solution.times);
    let before = solution.counters.clone();
    solution.counters = last.counters;
    solution.counters.factorisations = factorisations + before.factorisations;
    solution.counters.contact_solves = solves + before.contact_solves;
    solution.counters.check_solves = before.check_solves;
    solution.counters.wear_steps = steps;
    solution.wear = last.wear;
    solution.energy = last.energy;
    solution.reactions = last.reactions;
    solution.profile = last.profile;
    solution.curve = last.curve;
    solution.history = last.history;
    solution.steps = last.steps;
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

/// One run on one level; the inner `Err` is a start without an answer.
fn run(stage: Stage<'_>, level: Level, options: Options) -> Result<Result<Solved, String>, Fault> {
    let mut solution = Solution::default();
    let reduced = stage.reduced(level, Cut::Plain, &mut solution)?;
    let start = Instant::now();
    let pair = reduced.pair()?;
    let operator = reduced.operator(&pair, stage.friction() > 0.0)?;
    note(&mut solution, "interface", start);
    let start = Instant::now();
    let load = stage.contact_load(operator.points());
    let problem = match wear_problem(stage, &pair, &operator, &load)? {
        Ok(problem) => problem,
        Err(reason) => return Ok(Err(reason)),
    };
    let mut evolution = match Evolution::new(&problem) {
        Ok(evolution) => evolution,
        Err(error) => return Ok(Err(error.to_string())),
    };
    let mut history = History::default();
    let mut states_in_time = Vec::new();
    while *evolution.status() == EvolutionStatus::Running && evolution.state().step < MOST_STEPS && !crate::interrupt::asked() {
        let Some(state) = evolution.next() else { break };
        history.push(&state);
        states_in_time.push(state);
    }
    let state = evolution.state().clone();
    let ended = evolution.status().clone();
    let run_in = evolution.run_in();
    note(&mut solution, "evolution", start);
    // The worn gap with its lowest rigid part, and the bodies on it.
    let curve = NodalCurve { pair: &pair, operator: &operator, gap: &state.gap };
    let rigid = if stage.rigid_prescribed() { None } else { lowest_nonnegative(&curve) };
    let rigid = rigid.unwrap_or_else(|| vec![0.0; pair.shaped.rigid_modes.ncols()]);
    let normalised: Vec<f64> = operator
        .points()
        .iter()
        .zip(&state.gap)
        .map(|(p, g)| g + rigid.iter().zip(closing(&pair, p)).map(|(a, phi)| a * phi).sum::<f64>())
        .collect();
    let found = operator
        .solve(&normalised, &load, None)
        .map_err(|error| Fault::at("contact", "no-contact", error.to_string(), "check the contact and its load"))?;
    solution.counters.contact_solves = 2;
    solution.counters.wear_steps = state.step;
    let states = [Some(&found.shaped), found.counter.as_ref()];
    solution.energy = Some(EnergyResult {
        body1_Nmm: Some(pair.shaped.strain_energy(&found.shaped)),
        body2_Nmm: pair.counter.zip(found.counter.as_ref()).map(|(body, state)| body.strain_energy(state)),
    });
    solution.reactions = reduced.reactions(states);
    solution.wear = Some(WearResult {
        status: word(&ended).into(),
        steps: state.step,
        rejected_steps: state.rejected,
        time_s: Some(state.time),
        distance_mm: Some(state.distance),
        steady: state.steady_residual <= STEADY,
        depth_um: Some(1e3 * state.depth),
        volume_mm3: Some(state.volume[0] + state.volume[1]),
        explicit_step_limit_s: run_in.as_ref().map(|r| r.explicit_limit),
        run_in_distance_mm: run_in.map_or_else(Vec::new, |r| r.distances.into_iter().take(RUN_IN).collect()),
        lyapunov_increase: (stage.friction() == 0.0).then_some(state.lyapunov_increase),
    });
    solution.history = history.columns();
    if stage.problem.plan.runs("run.mcap") {
        let step = |state: &shapeopt::WearState| (recorded(state), step_profile(stage, &pair, operator.points(), state));
        solution.steps = states_in_time.iter().map(step).collect();
    }
    let mut profile = stage.profile(&pair, operator.points(), &state.pressure, states);
    profile.gap = normalised.iter().map(|g| 1e3 * g).collect();
    profile.opening = state.opening.iter().map(|g| 1e3 * g).collect();
    let sampled = |sampling: Sampling<'_>| -> Profile {
        let points = stage.sample(&pair, sampling);
        let at = |values: &[f64], arc: f64| operator.value_at(values, arc);
        let pressure: Vec<f64> = points.iter().map(|p| pressure_at(&pair, &operator, &state.pressure, p.arc)).collect();
        let mut profile = stage.profile(&pair, &points, &pressure, states);
        for (row, point) in points.iter().enumerate() {
            profile.gap[row] = 1e3 * at(&normalised, point.arc);
            profile.opening[row] = 1e3 * at(&state.opening, point.arc);
        }
        profile
    };
    let samples = stage.sample(&pair, Sampling::Even(SAMPLES));
    let gaps = samples.iter().map(|p| operator.value_at(&normalised, p.arc)).collect();
    let modes = pair.shaped.rigid_modes.ncols();
    let mut matrix = DMatrix::zeros(SAMPLES, modes);
    for (row, point) in samples.iter().enumerate() {
        closing(&pair, point).into_iter().enumerate().for_each(|(k, phi)| matrix[(row, k)] = phi);
    }
    solution.curve = Some(sampled(CURVE));
    solution.profile = Some(options.sample.map_or(profile, sampled));
    let mut reported = None;
    if stage.problem.plan.runs("field recovery") {
        let started = operator
            .solve(&problem.gap, &load, None)
            .map_err(|error| Fault::at("contact", "no-contact", error.to_string(), "check the contact and its load"))?;
        solution.counters.contact_solves += 1;
        let moments = [("", state.time, found), ("start", 0.0, started)].into_iter();
        let moments = moments.filter_map(|(name, time_s, at)| {
            Some(Moment { time_s, name, states: [at.shaped, at.counter?], pressure: at.pressure })
        });
        reported = Some(Reported { level, moments: moments.collect() });
    }
    Ok(Ok(Solved { gaps, closing: matrix, ended, reported, solution }))
}

/// The wear problem on an operator; the inner `Err` says why it has no answer.
fn wear_problem(
    stage: Stage<'_>,
    pair: &Pair<'_>,
    operator: &ContactOperator<'_>,
    load: &contact::ContactLoad,
) -> Result<Result<WearProblem, String>, Fault> {
    let points: Vec<wear::SurfacePoint> =
        operator.points().iter().map(|p| stage.surface_point(p.position, p.normal, p.weight)).collect();
    let friction = stage.scene().contact.as_ref().and_then(|c| c.friction).unwrap_or(0.0);
    let laws = crate::solve::pressure::wear_pair(stage.scene(), friction)
        .map_err(|error| Fault::at("wear", "wrong-value", error.to_string(), "mend the numbers in the message"))?;
    let counterface = match stage.scene().wear.as_ref().and_then(|wear| wear.counterface) {
        Some(scene::Counterface::Congruent) => wear::Counterface::Congruent,
        Some(scene::Counterface::Revolving) => wear::Counterface::Revolving,
        _ => wear::Counterface::Fresh,
    };
    let gap: Vec<f64> = operator.points().iter().map(|p| start_gap(stage, pair, p.arc)).collect();
    let start = match operator.solve(&gap, load, None) {
        Ok(start) if start.status.is_solved() && start.status != ContactStatus::NoContact => start,
        Ok(start) => return Ok(Err(start.status.to_string())),
        Err(error) => return Ok(Err(error.to_string())),
    };
    let system = match operator.system(load) {
        Ok(system) => system,
        Err(error) => return Ok(Err(error.to_string())),
    };
    let mut problem = WearProblem::new(points, laws, counterface, gap, system);
    problem.start = Some([start.pressure, start.opening]);
    problem.track_area = stage.patch.surface.track_area();
    problem.until = Until::Steady { residual: STEADY };
    if let Some(gap::Until::Time(time)) = stage.scene().wear.as_ref().and_then(|wear| wear.until) {
        problem.until = Until::Time(time.0);
        problem.stepping = Stepping::Adaptive { accuracy: stage.accuracy() };
    }
    Ok(Ok(problem))
}

/// A state as the recording keeps it.
fn recorded(state: &shapeopt::WearState) -> record::State {
    record::State {
        step: state.step as u64,
        time_s: state.time,
        step_s: state.next_step,
        rejected: state.rejected as u64,
        distance_mm: Some(state.distance),
        volume_mm3: Some(state.volume[0] + state.volume[1]),
        steadiness: Some(state.steady_residual),
        gap_um: state.gap.iter().map(|g| 1e3 * g).collect(),
        pressure_MPa: state.pressure.clone(),
        ..record::State::default()
    }
}

/// The contact points at a step.
fn step_profile(stage: Stage<'_>, pair: &Pair<'_>, points: &[contact::ContactPoint], state: &shapeopt::WearState) -> Profile {
    let mut profile = stage.profile(pair, points, &state.pressure, [None, None]);
    profile.gap = state.gap.iter().map(|g| 1e3 * g).collect();
    profile.opening = state.opening.iter().map(|g| 1e3 * g).collect();
    profile
}

/// The status in the summary's word.
fn word(status: &EvolutionStatus) -> &'static str {
    match status {
        EvolutionStatus::Steady => "steady",
        EvolutionStatus::TimeReached => "time-reached",
        EvolutionStatus::Running => "step-limit",
        EvolutionStatus::Stuck { .. } => "stuck",
    }
}

/// Columns of history.csv.
#[derive(Default)]
struct History {
    rows: Vec<[f64; 12]>,
}

const COLUMNS: [&str; 12] = [
    "step",
    "time_s",
    "distance_mm",
    "step_size_s",
    "p_max_MPa",
    "p_min_MPa",
    "depth_um",
    "volume1_mm3",
    "volume2_mm3",
    "steady_residual",
    "lyapunov_mW",
    "rejected",
];

impl History {
    fn push(&mut self, state: &shapeopt::WearState) {
        let extreme = |start: f64, f: fn(f64, f64) -> f64| state.pressure.iter().copied().fold(start, f);
        self.rows.push([
            state.step as f64,
            state.time,
            state.distance,
            state.step_size,
            extreme(0.0, f64::max),
            extreme(f64::INFINITY, f64::min),
            1e3 * state.depth,
            state.volume[0],
            state.volume[1],
            state.steady_residual,
            state.lyapunov,
            state.rejected as f64,
        ]);
    }

    fn columns(&self) -> Vec<(String, Vec<f64>)> {
        let column = |k: usize| self.rows.iter().map(|row| row[k]).collect();
        COLUMNS.iter().enumerate().map(|(k, name)| (name.to_string(), column(k))).collect()
    }
}

/// A gap given at the contact points, as a curve for the choice of the rigid part.
struct NodalCurve<'a> {
    pair: &'a Pair<'a>,
    operator: &'a ContactOperator<'a>,
    gap: &'a [f64],
}

impl Curve for NodalCurve<'_> {
    fn length(&self) -> f64 {
        self.pair.trace().length()
    }

    fn samples(&self) -> Vec<f64> {
        let trace = self.pair.trace();
        let mut samples: Vec<f64> = trace
            .edges
            .iter()
            .flat_map(|edge| {
                let n = 4 * (edge.degree + 1);
                let (start, length) = (edge.start, edge.curve.length());
                (0..n).map(move |i| start + length * i as f64 / n as f64)
            })
            .collect();
        samples.push(trace.length());
        samples
    }

    fn value(&self, arc: f64) -> (f64, Vec<f64>) {
        (self.operator.value_at(self.gap, arc), closing(self.pair, &self.pair.at_arc(arc)))
    }

    fn mean_modes(&self) -> Vec<f64> {
        let mut sums = vec![0.0; self.pair.shaped.rigid_modes.ncols()];
        for point in self.operator.points() {
            for (sum, phi) in sums.iter_mut().zip(closing(self.pair, point)) {
                *sum += point.weight * phi;
            }
        }
        sums
    }
}
