//! One run in time on one level of discretisation.

use contact::{ContactLoad, ContactOperator, ContactPoint, ContactSolution, Pair};
use scene::Fault;
use shapeopt::{Evolution, EvolutionStatus, Until, WearProblem, WearState, closing};

use crate::bodies::Reduced;
use crate::effort::Effort;
use crate::ladder::Refusal;
use crate::level::Level;
use crate::results::WearResult;
use crate::stage::Stage;
use crate::step::Step;
use crate::steps::answer::{Answer, Own, Told};
use crate::steps::contact_result::closings;
use crate::steps::heat::running::Running;
use crate::steps::reported::{Moment, Reported};
use crate::steps::wear::columns::{Turn, fill};
use crate::steps::wear::cycles;
use crate::steps::wear::earlier::{check_levels, check_states};
use crate::steps::wear::gaps::{ApartFrom, gaps_apart, with_lowest_rigid_part};
use crate::steps::wear::grown;
use crate::steps::wear::history::{History, of_surface};
use crate::steps::wear::hot::Hot;
use crate::steps::wear::integration_error::{integration_error, refine};
use crate::steps::wear::mesh_lines::mesh_lines;
use crate::steps::wear::open_ends::open_ends;
use crate::steps::wear::pieces::Pieces;
use crate::steps::wear::problem::{Loads, residual_at_end, wear_problem};
use crate::steps::wear::ran::{FAR, MOST_STEPS, Ran};
use crate::steps::wear::round_result::RoundContact;
use crate::steps::wear::run::Run;
use crate::steps::wear::samples::samples;
use crate::steps::wear::torque::Turning;
use crate::steps::{life, torsion};
use crate::turns_result::TurnsResult;
use crate::watch::{Event, FinishedLevel, RunLevel, Watch, WearStep};

/// Run-in distances in the summary, slowest first.
const RUN_IN: usize = 4;

/// The discretisation of a run: a level, with nodes at ends of contact.
#[derive(Clone, Copy)]
pub(super) struct Mesh<'a> {
    pub level: Level,
    pub ends: &'a [f64],
    /// Those of them that were known before all levels: of the final pressure.
    pub known: &'a [f64],
}

/// What is known of a run before a level.
pub(super) struct Known<'a> {
    /// The finished levels.
    pub finished: &'a [FinishedLevel],
    /// The steps of this level that an earlier run made.
    pub states: Vec<WearState>,
}

/// The contact of a level under each load of the schedule.
struct Scenes<'a> {
    stages: &'a [Stage<'a>],
    loads: Vec<ContactLoad>,
    pieces: &'a Pieces,
    reduced: &'a Reduced,
    pair: &'a Pair<'a>,
    operator: &'a ContactOperator<'a>,
    finished: &'a [FinishedLevel],
    /// Where gaps of levels are compared.
    samples: Vec<ContactPoint>,
    /// Frictional heat; none of a scene without it.
    hot: Option<Hot<'a>>,
}

/// Why a level has no end.
pub(super) enum Unfinished {
    /// The watcher cut it short.
    Stopped(History),
    /// What is known of it does not belong to it.
    Unfit(Fault),
}

/// One run on one level after the finished ones, from its start or from the last of the known states.
pub(super) fn run(
    stage: Stage<'_>,
    pieces: &Pieces,
    mesh: Mesh<'_>,
    known: Known<'_>,
    watch: &mut Watch<'_>,
) -> Result<Result<(FinishedLevel, Ran), Unfinished>, Refusal> {
    let Mesh { level, ends, .. } = mesh;
    let Known { finished, states } = known;
    let stages = pieces.problems.iter().map(|problem| stage.with(problem)).collect::<Result<Vec<Stage<'_>>, Fault>>()?;
    let running = Running::new(stages[pieces.intervals[0].stage], level, ends)?;
    let (running, (reduced, mut effort)) = match running {
        Some((running, effort)) => {
            let reduced = running.reduced();
            (Some(running), (reduced, effort))
        }
        None => (None, stage.reduced_at(level, ends)?),
    };
    let pair = reduced.pair()?;
    (stage.options.begun)(Step::Interface);
    let operator = effort.timed(Step::Interface, stage.clock(), |_| reduced.operator(&pair, stage.friction() > 0.0))?;
    let start = stage.clock()();
    let base: Vec<ContactLoad> = stages.iter().map(|stage| stage.contact_load(operator.points())).collect();
    let hot = running.map(|running| Hot { running, base: base.clone(), stages: &stages, pieces });
    let begun = hot.as_ref().map(|hot| hot.begin(&operator)).transpose()?;
    let loads = begun.as_ref().map_or(base, |begun| begun.loads.clone());
    // Gaps of levels are compared at one time: where part of the surface is open, the worn part goes on receding from it.
    let not_before = finished.iter().map(|level| level.time).fold(0.0, f64::max);
    let begun = begun.as_ref().map(|begun| &begun.contact);
    let mut problem = wear_problem(Loads { stages: &stages, loads: &loads, begun }, pieces, &operator, not_before)?;
    hot.iter().try_for_each(|hot| hot.join(&mut problem, &operator))?;
    // What is worn off a round body is measured from what is not: no rigid part is taken out.
    let modes = if stage.ends_move() { 0 } else { pair.shaped.rigid_modes.ncols() };
    let samples = samples(stage, &pair, mesh.known);
    if let Err(fault) = check_levels(finished, samples.len(), modes).and_then(|()| check_states(&states, &problem)) {
        return Ok(Err(Unfinished::Unfit(fault)));
    }
    let (least_error, known_error) = refine(stage, &mut problem, finished);
    let scenes =
        Scenes { stages: &stages, loads, pieces, reduced: &reduced, pair: &pair, operator: &operator, finished, samples, hot };
    let run_level = RunLevel {
        finished,
        known_steps: states.len(),
        message: format!("degree {}, {} layers, {} contact points", level.degree, level.layers, operator.points().len()),
        lines: &|| mesh_lines(stage, level, ends),
    };
    let begun = watch(Event::Run(&run_level)).is_continue();
    let run = evolve(&problem, &scenes, states, begun, watch)?;
    if run.stopped {
        return Ok(Err(Unfinished::Stopped(run.history)));
    }
    let integration_error = known_error.unwrap_or_else(|| scenes.left_by_steps(&problem, &run, least_error));
    effort.add_seconds(Step::Evolution, stage.clock()() - start);
    let (left, ran) = scenes.ran(mesh, &problem, run, effort)?;
    Ok(Ok((FinishedLevel { integration_error, ..left }, ran)))
}

impl Scenes<'_> {
    /// What the steps of a run leave wrong, at least `least`: in its gap too, where it ends before it is steady.
    fn left_by_steps(&self, problem: &WearProblem, run: &Run, least: f64) -> Option<f64> {
        let stage = self.stages[self.pieces.intervals[run.state.interval].stage];
        let steady = run.state.steady_residual <= residual_at_end(stage);
        let gaps = |other: &[f64]| gaps_apart((stage, self.pair, self.operator), &run.state, other);
        let on_the_way = stage.problem.wear.until.is_some() && !stage.ends_move() && !steady;
        let gaps: Option<ApartFrom<'_>> = if on_the_way { Some(&gaps) } else { None };
        Some(integration_error(problem, self.pieces, run, gaps)?.max(least))
    }

    /// What a run leaves to the levels after it, and what is reported of it.
    fn ran(&self, mesh: Mesh<'_>, problem: &WearProblem, run: Run, mut effort: Effort) -> Result<(FinishedLevel, Ran), Refusal> {
        let (state, level) = (&run.state, mesh.level);
        // The worn gap with its lowest rigid part, and the bodies on it, under the load that acts last.
        let last = self.pieces.intervals[state.interval].stage;
        let stage = self.stages[last];
        let normalised = with_lowest_rigid_part(stage, self.pair, self.operator, &state.gap);
        let found = self.last(&normalised, last, state)?;
        effort.counters.contact_solves += 2;
        effort.counters.wear_steps += state.step;
        let mut told = self.told((stage, problem), state, &normalised, &found);
        let heat = self.hot.as_ref().map(|hot| hot.tell(self.operator, state, (&found, &mut told), self.finished)).transpose()?;
        let mut wear = result(&run, stage);
        [wear.approach, wear.tilt] = closings(stage, self.pair, &found);
        let resolved = cycles::resolved(self.pieces, &run.history.states);
        wear.turns = self.pieces.turns.clone().map(|turns| TurnsResult { resolved, ..turns });
        let moved = moved(state, &found);
        let mut moments: Vec<Moment> = self.moment("", state.time, found, last).into_iter().collect();
        if stage.problem.plan.runs(Step::Fields) && heat.is_none() {
            moments.extend(self.start(problem)?);
            effort.counters.contact_solves += 1;
        }
        let round = stage.ends_move();
        let worn: Vec<f64> = state.gap.iter().zip(&problem.gap).map(|(now, start)| now - start).collect();
        let compared = if round { &worn } else { &normalised };
        let mut left = FinishedLevel {
            gap: self.samples.iter().map(|p| self.operator.value_at(compared, p.arc)).collect(),
            moved,
            to_1_percent: wear.to_1_percent.as_ref().map(|settled| settled.time),
            ends: if mesh.known.is_empty() { self.open_ends(state) } else { Vec::new() },
            singular: heat.as_ref().map(|told| told.singular.clone()).unwrap_or_default(),
            closing: if round { Vec::new() } else { self.samples.iter().flat_map(|point| closing(self.pair, point)).collect() },
            factorisations: effort.counters.factorisations,
            contact_solves: effort.counters.contact_solves,
            ..run.left(level)
        };
        let (mut heat, at_points) = heat.map(|told| (told.result, told.heat)).unzip();
        let reported = Some(Reported { level, ends: mesh.ends.to_vec(), heat: at_points, moments });
        let start = stage.start(self.pair);
        let places: Vec<f64> = self.operator.points().iter().map(|p| start + p.arc).collect();
        let running_in = run.history.running_in(places.clone(), &|pressure| problem.mean_pressure(pressure));
        let Run { ended, history, .. } = run;
        let (mut columns, mut groove) = (history.columns(), Vec::new());
        let turning = Turning { stages: self.stages, pieces: self.pieces, problem };
        columns.extend(turning.torques(&history.states).map(|torques| ("torque_Nmm".into(), torques)));
        if let Some((hot, heat)) = self.hot.as_ref().zip(heat.as_mut()) {
            columns.extend(hot.on_the_way(&history.states, heat)?);
        }
        if round {
            let contact = RoundContact { stage, problem, places };
            let ends = contact.ends(&history);
            groove = contact.fill(&mut wear, &history, ends.last());
            left.passed = grown::passed(stage, &ends);
            columns.extend(contact.columns(&ends));
        }
        Ok((left, Ran { ended, history: columns, groove, running_in, wear, told, heat, reported, effort }))
    }

    /// Ends of contact that a run finds itself.
    fn open_ends(&self, state: &WearState) -> Vec<f64> {
        open_ends(self.stages, self.operator.points(), &state.pressure, self.pair.trace().length())
    }

    /// The contact on the gap of a state under the load that acts last; that of hot bodies, of which there may be several, on the points of the state.
    fn last(&self, gap: &[f64], load: usize, state: &WearState) -> Result<ContactSolution, Fault> {
        let Some(hot) = &self.hot else { return self.solve(gap, load) };
        let (load, pressing) = (hot.load(load, &state.conducting)?, state.pressure.iter().map(|p| *p > 0.0).collect::<Vec<_>>());
        let held = self.operator.solve_on(gap, &load, &pressing).map_err(no_contact)?;
        held.map_or_else(|| self.operator.solve(gap, &load, None).map_err(no_contact), Ok)
    }

    /// The contact on a gap under one of the loads of bodies without heat.
    fn solve(&self, gap: &[f64], load: usize) -> Result<ContactSolution, Fault> {
        self.operator.solve(gap, &self.loads[load], None).map_err(no_contact)
    }

    /// Energies, reactions and columns of a state; of loads that act by turns while the first of them does.
    fn told(&self, (stage, problem): (Stage<'_>, &WearProblem), state: &WearState, gap: &[f64], found: &ContactSolution) -> Told {
        let (pair, operator) = (self.pair, self.operator);
        let points = operator.points();
        let [pressure, opening] = [&state.pressure, &state.opening].map(|values| &values[..points.len()]);
        let between = |point: &ContactPoint| {
            let at = |values: &[f64]| operator.value_at(values, point.arc);
            [operator.pressure_at(pressure, point.arc), at(gap), at(opening)]
        };
        let own = Own { points, pressure, gap, opening, closed: None };
        let states = [Some(&found.shaped), found.counter.as_ref()];
        let mut told = Answer { stage, reduced: self.reduced, pair, states, own, between: &between }.told();
        let (start, length) = (stage.start(pair), pair.trace().length());
        for profile in [&mut told.profile, &mut told.curve] {
            let arcs: Vec<f64> = profile.s.iter().map(|s| (s - start).clamp(0.0, length)).collect();
            fill(
                profile,
                &self.turns(problem, &state.pressure, |pressure| {
                    arcs.iter().map(|arc| operator.pressure_at(pressure, *arc)).collect()
                }),
            );
        }
        told
    }

    /// The loads that act by turns, their pressures (one after the other) read at other places.
    fn turns(&self, problem: &WearProblem, pressure: &[f64], at: impl Fn(&[f64]) -> Vec<f64>) -> Vec<Turn<'_>> {
        let turns = self.stages.iter().zip(problem.pressures(pressure));
        turns.map(|(stage, (pressure, share))| Turn { stage: *stage, share, pressure: at(pressure) }).collect()
    }

    /// The bodies on the start gap.
    fn start(&self, problem: &WearProblem) -> Result<Option<Moment>, Fault> {
        let first = self.pieces.intervals[0].stage;
        Ok(self.moment("start", 0.0, self.solve(&problem.gap, first)?, first))
    }

    /// The bodies at a moment; each is twisted by the sliding of its own piece of the schedule.
    fn moment(&self, name: &'static str, time: f64, at: ContactSolution, load: usize) -> Option<Moment> {
        let stage = self.stages[load];
        let around = torsion::around(stage, self.operator.points(), &at.pressure);
        at.counter.map(|counter| Moment { time, name, states: [stage.held(self.pair, &at.shaped), counter], around })
    }
}

/// The largest displacement of the bodies in a contact (mm), or the depth worn off if that is larger.
fn moved(state: &WearState, found: &ContactSolution) -> f64 {
    let states = [Some(&found.shaped), found.counter.as_ref()].into_iter().flatten();
    states.flat_map(|state| &state.unknowns).fold(state.depth, |most, u| most.max(u.abs()))
}

fn no_contact(error: contact::Error) -> Fault {
    Fault::at("contact", "no-contact", error.to_string(), "check the contact and its load")
}

/// What the summary says of a run.
fn result(run: &Run, stage: Stage<'_>) -> WearResult {
    let Run { state, ended, run_in, .. } = run;
    let steady = state.steady_residual <= residual_at_end(stage);
    WearResult {
        status: ended.into(),
        steps: state.step,
        rejected_steps: state.rejected,
        time: Some(state.time),
        distance: Some(state.distance),
        steady,
        depth: Some(1e3 * state.depth),
        volume: Some(state.volume[0] + state.volume[1]),
        explicit_step_limit: run_in.as_ref().map(|r| r.explicit_limit),
        run_in_distance: run_in.iter().flat_map(|r| r.distances.iter().copied().take(RUN_IN)).collect(),
        lyapunov_increase: (stage.friction() == 0.0).then_some(state.lyapunov_increase),
        approach: None,
        tilt: None,
        scar: None,
        ends: None,
        turns: None,
        life: run.life.clone(),
        volumes: None,
        groove: None,
        run_in_error: None,
        to_1_percent: run.settled.clone().filter(|_| steady),
    }
}

/// Why a run whose every rate is 0 has no end.
const NO_RATE: &str = "the wear rates beta (mu p)^b v^a are below the smallest number, so that nothing wears in a finite time; give a larger \
                       factor or friction, or a smaller exponent";

/// Why a run under a threshold does not begin.
const NOWHERE_ABOVE: &str = "the pressure is nowhere above wear.threshold, so that nothing wears and the shape stays as it is; press harder, or \
                             give a lower threshold";

/// Steps until the end, from the start or from the last of the known states; each new step is told. Nothing is done where the watcher has not let it
/// begin.
fn evolve(
    problem: &WearProblem,
    scenes: &Scenes<'_>,
    known: Vec<WearState>,
    begun: bool,
    watch: &mut Watch<'_>,
) -> Result<Run, Refusal> {
    let mut history = History::default();
    let mut last = known.last().map(|last| (last.rejected, last.newton_iterations));
    let start = match known.last().cloned() {
        Some(state) => Evolution::resume(problem, state),
        None => Evolution::new(problem),
    };
    known.into_iter().for_each(|state| history.push(state));
    let mut evolution = start.map_err(|error| match error {
        // A short contact may lie between the points of a coarse mesh, or be one of them, about which body 1 tilts.
        shapeopt::Error::NoContactAtStart => Refusal::TooCoarse(error.to_string()),
        error => Refusal::Reason(error.to_string()),
    })?;
    let mut stopped = !begun;
    let deepest = if matches!(problem.until, Until::Steady { .. }) { FAR * scenes.pair.trace().length() } else { f64::INFINITY };
    let goes_on = |state: &WearState| state.step < MOST_STEPS && state.depth < deepest;
    while *evolution.status() == EvolutionStatus::Running && goes_on(evolution.state()) && !stopped {
        let Some(state) = cycles::next(&mut evolution, problem, scenes.pieces, &history.states) else { break };
        if state.step == 0 && state.gap_rate.iter().all(|rate| *rate == 0.0) {
            let above = scenes.stages[0].problem.wear.lowest_threshold().is_some();
            return Err(Refusal::Reason(if above { NOWHERE_ABOVE } else { NO_RATE }.into()));
        }
        let (rejected, solves) = last.unwrap_or((0, 0));
        let step = WearStep {
            state: &state,
            tries: state.rejected - rejected + 1,
            linear_solves: state.newton_iterations - solves,
            share: share(&state, problem),
            profile: &|| {
                let stage = scenes.stages[problem.schedule[state.interval].stage];
                let all = of_surface(&state, history.states.last());
                let mut profile =
                    stage.profile(scenes.pair, scenes.operator.points(), &all[..problem.points.len()], [None, None]);
                fill(&mut profile, &scenes.turns(problem, &all, |pressure| pressure.to_vec()));
                profile.gap = state.gap.iter().map(|g| 1e3 * g).collect();
                profile.opening = state.opening.iter().map(|g| 1e3 * g).collect();
                profile
            },
        };
        let ended = *evolution.status() != EvolutionStatus::Running;
        stopped = watch(Event::WearStep(&step)).is_break() && !ended;
        last = Some((state.rejected, state.newton_iterations));
        history.push(state);
    }
    let (state, ended, run_in) = (evolution.state().clone(), evolution.status().clone(), evolution.run_in());
    let settled = if stopped || problem.times.is_none() { None } else { history.settled(&evolution) };
    let life = if stopped { None } else { life::of_run(scenes.stages[0].problem, &evolution, &history.states) };
    Ok(Run { state, ended, stopped, history, settled, life, run_in })
}

/// How far a run is, from 0 to 1, about; the steady state counts in the last piece of a schedule alone.
fn share(state: &WearState, problem: &WearProblem) -> f64 {
    match problem.until {
        Until::Time(end) => state.time / end,
        Until::Depth(depth) => state.depth / depth,
        Until::Volume(volume) => (state.volume[0] + state.volume[1]) / volume,
        Until::Steady { .. } if state.interval + 1 < problem.schedule.len() => 0.0,
        Until::Steady { residual, .. } => state.steady_residual.max(f64::MIN_POSITIVE).ln() / residual.ln(),
    }
}
