//! One run in time on one level of discretisation.

use std::time::Instant;

use contact::{ContactLoad, ContactOperator, ContactPoint, ContactSolution, Pair};
use scene::Fault;
use shapeopt::{Evolution, EvolutionStatus, WearProblem, WearState, closing, lowest_nonnegative};

use crate::fe::bodies::Level;
use crate::fe::contact::pressure_at;
use crate::fe::recover::{Moment, Reported};
use crate::fe::stage::{Stage, note};
use crate::fe::torsion;
use crate::fe::wear::Solved;
use crate::fe::wear::history::History;
use crate::fe::wear::mesh_lines::mesh_lines;
use crate::fe::wear::nodal_curve::NodalCurve;
use crate::fe::wear::pieces::Pieces;
use crate::fe::wear::problem::{steady_residual, wear_problem};
use crate::fe::wear::settled::RunningIn;
use crate::live::Live;
use crate::profile::Profile;
use crate::record::{FinishedLevel, Iteration, Points, State};
use crate::solution::{EnergyResult, Solution, WearResult};
use crate::solve::{CURVE, Options, Sampling};

/// Samples of the gap for the comparison of levels.
const SAMPLES: usize = 201;
/// Most steps of a run.
pub(super) const MOST_STEPS: usize = 20_000;
/// Run-in distances in the summary, slowest first.
const RUN_IN: usize = 4;

/// The discretisation of a run: a level, with nodes at the ends of the final pressure.
#[derive(Clone, Copy)]
pub(super) struct Mesh<'a> {
    pub(super) level: Level,
    pub(super) ends: &'a [f64],
}

/// One run on one level after the `finished` ones; the inner `Err` is a start without an answer.
pub(super) fn run(
    stage: Stage<'_>,
    mesh: Mesh<'_>,
    finished: &[FinishedLevel],
    options: Options,
    live: &mut Live,
) -> Result<Result<Solved, String>, Fault> {
    let mut solution = Solution::default();
    let Mesh { level, ends } = mesh;
    let reduced = stage.reduced_at(level, ends, &mut solution)?;
    let start = Instant::now();
    let pair = reduced.pair()?;
    let operator = reduced.operator(&pair, stage.friction() > 0.0)?;
    note(&mut solution, "interface", start);
    let start = Instant::now();
    let pieces = Pieces::of(stage.problem)?;
    let stages = pieces.scenes.iter().map(Stage::new).collect::<Result<Vec<Stage<'_>>, Fault>>()?;
    let loads: Vec<ContactLoad> = stages.iter().map(|stage| stage.contact_load(operator.points())).collect();
    // Gaps of levels are compared at one time: where part of the surface is open, the worn part goes on receding from it.
    let not_before = finished.iter().map(|level| level.time_s).fold(0.0, f64::max);
    let problem = match wear_problem(&stages, &pieces.intervals, &pair, &operator, &loads, not_before)? {
        Ok(problem) => problem,
        Err(reason) => return Ok(Err(reason)),
    };
    let message = format!("degree {}, {} layers, {} contact points", level.degree, level.layers, operator.points().len());
    let recorded = live.begin_level(finished, || mesh_lines(stage, level, ends), &message)?;
    let surface = Surface { stages: &stages, pair: &pair, points: operator.points() };
    let run = match evolve(&problem, &surface, recorded, live)? {
        Ok(run) => run,
        Err(reason) => return Ok(Err(reason)),
    };
    let state = &run.state;
    note(&mut solution, "evolution", start);
    // The worn gap with its lowest rigid part, and the bodies on it, under the load that acts last.
    let last = pieces.intervals[state.interval].stage;
    let (stage, load) = (stages[last], &loads[last]);
    let normalised = with_lowest_rigid_part(stage, &pair, &operator, &state.gap);
    let found = operator
        .solve(&normalised, load, None)
        .map_err(|error| Fault::at("contact", "no-contact", error.to_string(), "check the contact and its load"))?;
    solution.counters.contact_solves = 2;
    solution.counters.wear_steps = state.step;
    let states = [Some(&found.shaped), found.counter.as_ref()];
    solution.energy = Some(EnergyResult {
        body1_Nmm: Some(pair.shaped.strain_energy(&found.shaped)),
        body2_Nmm: pair.counter.zip(found.counter.as_ref()).map(|(body, state)| body.strain_energy(state)),
    });
    solution.reactions = reduced.reactions(states);
    let weights: Vec<f64> = operator.points().iter().map(|p| p.weight).collect();
    solution.wear = Some(result(&run, &weights, stage));
    solution.history = run.history.columns();
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
    solution.curve = Some(sampled(CURVE));
    solution.profile = Some(options.sample.map_or(profile, sampled));
    // Each moment is twisted by the sliding of its own piece of the schedule.
    let around = torsion::around(stage, operator.points(), &found.pressure);
    let moment = |name, time_s, at: ContactSolution, around| {
        at.counter.map(|counter| Moment { time_s, name, states: [stage.held(&pair, &at.shaped), counter], around })
    };
    let mut moments: Vec<Moment> = moment("", state.time, found, around).into_iter().collect();
    if stage.problem.plan.runs("field recovery") {
        let first = pieces.intervals[0].stage;
        let started = operator
            .solve(&problem.gap, &loads[first], None)
            .map_err(|error| Fault::at("contact", "no-contact", error.to_string(), "check the contact and its load"))?;
        solution.counters.contact_solves += 1;
        let around = torsion::around(stages[first], operator.points(), &started.pressure);
        moments.extend(moment("start", 0.0, started, around));
    }
    let reported = Some(Reported { level, ends: ends.to_vec(), moments });
    let left = FinishedLevel {
        degree: level.degree,
        layers: level.layers,
        gap_mm: samples.iter().map(|p| operator.value_at(&normalised, p.arc)).collect(),
        time_s: state.time,
        closing: samples.iter().flat_map(|point| closing(&pair, point)).collect(),
        wear_steps: state.step,
        factorisations: solution.counters.factorisations,
        contact_solves: solution.counters.contact_solves,
    };
    Ok(Ok(Solved { left, ended: run.ended, reported, solution }))
}

/// A gap with its lowest rigid part that keeps it open, unless the rigid part is prescribed.
fn with_lowest_rigid_part(stage: Stage<'_>, pair: &Pair<'_>, operator: &ContactOperator<'_>, gap: &[f64]) -> Vec<f64> {
    let curve = NodalCurve { pair, operator, gap };
    let rigid = if stage.rigid_prescribed() || stage.turned() != 0.0 { None } else { lowest_nonnegative(&curve) };
    let rigid = rigid.unwrap_or_else(|| vec![0.0; pair.shaped.rigid_modes.ncols()]);
    let lifted = |p: &ContactPoint| rigid.iter().zip(closing(pair, p)).map(|(a, phi)| a * phi).sum::<f64>();
    operator.points().iter().zip(gap).map(|(p, g)| g + lifted(p)).collect()
}

/// What the summary says of a run; weights are the areas of the contact points.
fn result(run: &Run, weights: &[f64], stage: Stage<'_>) -> WearResult {
    let Run { state, ended, running_in, run_in, .. } = run;
    let steady = state.steady_residual <= steady_residual(stage);
    WearResult {
        status: word(ended).into(),
        steps: state.step,
        rejected_steps: state.rejected,
        time_s: Some(state.time),
        distance_mm: Some(state.distance),
        steady,
        depth_um: Some(1e3 * state.depth),
        volume_mm3: Some(state.volume[0] + state.volume[1]),
        explicit_step_limit_s: run_in.as_ref().map(|r| r.explicit_limit),
        run_in_distance_mm: run_in.iter().flat_map(|r| r.distances.iter().copied().take(RUN_IN)).collect(),
        lyapunov_increase: (stage.friction() == 0.0).then_some(state.lyapunov_increase),
        to_1_percent: if steady { running_in.cost(weights) } else { None },
    }
}

/// The contact surface under each load of the schedule.
struct Surface<'a> {
    stages: &'a [Stage<'a>],
    pair: &'a Pair<'a>,
    points: &'a [ContactPoint],
}

/// Why a run whose every rate is 0 has no end.
const NO_RATE: &str = "the wear rates beta (mu p)^b v^a are below the smallest number, so that nothing wears in a finite time; give a larger \
                       factor or friction, or a smaller exponent";

/// What a run in time has come to.
struct Run {
    state: WearState,
    ended: EvolutionStatus,
    history: History,
    running_in: RunningIn,
    run_in: Option<shapeopt::RunIn>,
}

/// Steps until the end, from the start or from the last of the recorded states; each new step is recorded.
fn evolve(
    problem: &WearProblem,
    surface: &Surface<'_>,
    recorded: Vec<State>,
    live: &mut Live,
) -> Result<Result<Run, String>, Fault> {
    let (mut history, mut running_in) = (History::default(), RunningIn::default());
    let mut last: Option<WearState> = None;
    for state in recorded.into_iter().map(WearState::from) {
        history.push(&state);
        running_in.push(&state);
        last = Some(state);
    }
    let begun = match last.clone() {
        Some(state) => Evolution::resume(problem, state),
        None => Evolution::new(problem),
    };
    let mut evolution = match begun {
        Ok(evolution) => evolution,
        Err(error) => return Ok(Err(error.to_string())),
    };
    while *evolution.status() == EvolutionStatus::Running && evolution.state().step < MOST_STEPS && !crate::interrupt::asked() {
        let Some(state) = evolution.next() else { break };
        if state.step == 0 && state.gap_rate.iter().all(|rate| *rate == 0.0) {
            return Ok(Err(NO_RATE.into()));
        }
        history.push(&state);
        running_in.push(&state);
        let before = last.as_ref().map_or((0, 0), |last| (last.rejected, last.newton_iterations));
        let iteration = Iteration {
            step: state.step as u64,
            tries: (state.rejected - before.0 + 1) as u64,
            linear_solves: (state.newton_iterations - before.1) as u64,
            step_s: state.step_size,
            error: state.error,
            steady_residual: state.steady_residual,
        };
        let profile = || {
            let stage = surface.stages[problem.schedule[state.interval].stage];
            let mut profile = stage.profile(surface.pair, surface.points, &state.pressure, [None, None]);
            profile.gap = state.gap.iter().map(|g| 1e3 * g).collect();
            profile.opening = state.opening.iter().map(|g| 1e3 * g).collect();
            Points::new(state.step as u64, state.time, &profile)
        };
        live.step(&iteration, profile, &state)?;
        live.progress.wear(&state, problem.schedule.len(), problem.until);
        last = Some(state);
    }
    let (state, ended, run_in) = (evolution.state().clone(), evolution.status().clone(), evolution.run_in());
    Ok(Ok(Run { state, ended, history, running_in, run_in }))
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
