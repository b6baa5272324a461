//! Wear in time: the gap grows by the wear that the contact pressure causes, `dg/dt = w'(p(g))`.
//!
//! Compliance makes this stiff: the fastest mode is a ripple as short as the distance of two contact points. Implicit steps solve pressure
//! and wear together; the gap alone is the state. Source of the model: Paczelt and Mroz (2007), section 2, with optimality theory, section 6,
//! of this project's documents.

mod control;
mod cycles;
mod ends;
mod entering;
mod heat;
mod intervals;

use crate::acting::{Acting, Conducting};
use crate::error::Error;
use crate::evolution_status::EvolutionStatus;
use crate::implicit_stage::Contact;
use crate::rigid_wear::RigidWear;
use crate::run_in::{RunIn, run_in};
use crate::turns::loads;
use crate::wear_problem::{Scheme, Stepping, Until, WearProblem};
use crate::wear_state::WearState;
use crate::wear_step::{Trial, gap_scale, shallow};
use std::cell::RefCell;
use std::sync::Arc;

/// Part of the stability bound that adaptive explicit steps take, and after how many of them the bound is computed anew.
const EXPLICIT_PART: f64 = 0.9;
const EXPLICIT_REVIEW: usize = 50;
/// Part of a deviation whose time is wanted down to which steps see to it.
const NEAR: f64 = 0.3;
/// Error of the steps, as the stepping counts it, over that of the times that come of them (`run_in_times` in the tests).
const TIMES: f64 = 20.0;
/// A step shorter than this part of the time passed, or of the step wanted at first, gives up.
const SHORTEST: [f64; 2] = [1e-14, 1e-10];

/// Length of a step taken and of the next one, and the time at its end where that is given.
struct Taken {
    step: f64,
    next: f64,
    end: Option<f64>,
}

/// Steps of a wear run, one state at a time; the first is the start.
pub struct Evolution<'a> {
    problem: &'a WearProblem,
    /// Each load by itself, or all of them in one where they act by turns.
    acting: Vec<Arc<Acting<'a>>>,
    /// Loads whose points conduct heat otherwise, the last ones met.
    kept: RefCell<Vec<Conducting<'a>>>,
    state: WearState,
    status: EvolutionStatus,
    fresh: bool,
}

impl<'a> Evolution<'a> {
    /// Prepares a run and solves the contact at its start.
    ///
    /// # Errors
    /// [`Error::WearInput`] if the numbers do not fit each other, [`Error::NoContactAtStart`] if the start has no contact pressure.
    pub fn new(problem: &'a WearProblem) -> Result<Evolution<'a>, Error> {
        let mut evolution = Evolution::prepare(problem)?;
        let (n, points) = (problem.points.len(), problem.values());
        let acting = &evolution.acting[problem.schedule[0].stage];
        // Every point just in contact, unless more is known.
        let [pressure, opening] = problem.start.clone().unwrap_or_else(|| [vec![0.0; points], vec![-f64::MIN_POSITIVE; points]]);
        let start = Contact { pressure, opening, coordinates: vec![0.0; acting.load.system.load.len()] };
        let solved = acting.load.solve(&problem.gap, 0.0, &start).map_err(|_| Error::NoContactAtStart)?;
        if !solved.contact.pressure.iter().any(|p| *p > 0.0) {
            return Err(Error::NoContactAtStart);
        }
        let mut state = WearState {
            gap: problem.gap.clone(),
            approach: vec![0.0; solved.contact.coordinates.len()],
            worn: vec![0.0; n],
            newton_iterations: solved.iterations,
            ..WearState::default()
        };
        evolution.take_contact(&mut state, solved.contact);
        evolution.conduct_at_first(&mut state);
        state.next_step = evolution.first_step(&state);
        evolution.state = state;
        Ok(evolution)
    }

    /// Goes on from a state of an earlier run of the same problem; the steps that follow are the same bit for bit.
    ///
    /// # Errors
    /// [`Error::WearInput`] if the numbers do not fit each other.
    pub fn resume(problem: &'a WearProblem, state: WearState) -> Result<Evolution<'a>, Error> {
        let mut evolution = Evolution::prepare(problem)?;
        let n = problem.points.len();
        let fits = [&state.gap, &state.worn, &state.gap_rate].iter().all(|v| v.len() == n)
            && [&state.pressure, &state.opening].iter().all(|v| v.len() == problem.values());
        let conducts = state.conducting.is_empty() || state.conducting.len() == n;
        if !(fits && conducts) || state.interval >= problem.schedule.len() {
            return Err(Error::WearInput { what: format!("the state to go on from does not belong to the {n} contact points") });
        }
        evolution.status = evolution.ended(&state);
        evolution.state = state;
        evolution.fresh = false;
        Ok(evolution)
    }

    fn prepare(problem: &'a WearProblem) -> Result<Evolution<'a>, Error> {
        problem.check()?;
        // Loads that act by turns are one load with the rigid motions of the first of them.
        let rigid = problem.stages.iter().map(|stage| RigidWear::new(&stage.system));
        let acting = loads(problem).into_iter().zip(rigid).map(|(load, rigid)| Arc::new(Acting { load, rigid })).collect();
        let (state, status) = (WearState::default(), EvolutionStatus::Running);
        Ok(Evolution { problem, acting, kept: RefCell::default(), state, status, fresh: true })
    }

    /// How the run stands.
    pub fn status(&self) -> &EvolutionStatus {
        &self.status
    }

    /// The last state.
    pub fn state(&self) -> &WearState {
        &self.state
    }

    /// Modes of the linearised wear at the last state.
    pub fn run_in(&self) -> Option<RunIn> {
        let acting = self.load(&self.state);
        run_in(&acting.load, &acting.rigid, &self.state.pressure, self.mean_speed(&self.state))
    }

    /// Rates of the gap (mm/s) under each of the loads that act by turns, at the last state; under one load its rate alone.
    pub fn rates_by_turns(&self) -> Vec<Vec<f64>> {
        self.load(&self.state).load.rate.by_turns(&self.state.pressure)
    }

    /// How long the rates of a state take until a depth is worn off body 1, and the mean sliding speed; `None` if body 1 does not wear.
    pub(crate) fn lasting(&self, state: &WearState, depth: f64) -> Option<[f64; 2]> {
        let acting = self.load(state);
        let time = |i: usize| (depth - state.worn[i]) / acting.load.rate.worn(0, i, &state.pressure);
        let shortest = (0..state.worn.len()).map(time).fold(f64::INFINITY, f64::min);
        shortest.is_finite().then(|| [shortest, self.mean_speed(state)])
    }

    /// Areas of the contact points by the part of the time that acts there.
    pub(crate) fn weights(&self) -> impl Iterator<Item = f64> {
        let load = &self.acting[self.stage(&self.state)].load;
        load.weights.iter().enumerate().map(|(i, weight)| load.rate.part(i) * weight)
    }

    /// Whether a load pushes along a rigid motion; without one the contact wears itself free.
    pub(crate) fn driven(&self, state: &WearState) -> bool {
        self.acting[self.stage(state)].rigid.driven
    }

    /// A state of this run with its contact solved again on its gap, so that it need not be whole; at the end of an interval under the load of
    /// the next one.
    pub(crate) fn restored(&self, state: &WearState) -> Option<WearState> {
        let mut state = state.clone();
        while let Some(next) = self.next_interval(&state) {
            (state.interval, state.interval_start) = next;
        }
        let acting = self.load(&state);
        let free = acting.load.system.load.len();
        let start =
            Contact { pressure: state.pressure.clone(), opening: vec![0.0; state.pressure.len()], coordinates: vec![0.0; free] };
        let solved = acting.load.solve_anyhow(&state.gap, &start)?;
        state.approach = vec![0.0; free];
        self.take_contact(&mut state, solved.contact);
        Some(state)
    }

    /// The state a step after a whole one.
    pub(crate) fn after(&self, state: &WearState, step: f64) -> Option<WearState> {
        let tried = self.trial(state, step)?;
        let mut state = state.clone();
        self.accept(&mut state, tried, Taken { step, next: step, end: None });
        Some(state)
    }

    /// Factors on the estimated errors of gap and pressure of a step from a state.
    fn severity(&self, state: &WearState) -> [f64; 2] {
        // What is left to wear off a contact that wears itself free is measured by what there was.
        if !self.driven(state) {
            return [1.0, state.steady_residual];
        }
        let last = state.interval + 1 == self.problem.schedule.len();
        match (self.problem.times, self.problem.stepping, self.problem.until) {
            // The certificate goes with the deviation from the steady pressure.
            (Some(times), Stepping::Adaptive { accuracy }, Until::Steady { .. })
                if last && state.steady_residual > NEAR * times.deviation =>
            {
                let closer = (accuracy / (TIMES * times.accuracy)).max(1.0);
                [closer, closer / state.steady_residual.clamp(times.deviation, 1.0)]
            }
            _ => {
                let [gap, pressure] = self.problem.early(state);
                [gap * shallow(self.problem, &self.load(state).load, state), pressure]
            }
        }
    }

    fn stage(&self, state: &WearState) -> usize {
        self.problem.schedule[state.interval].stage
    }

    fn mean_speed(&self, state: &WearState) -> f64 {
        let area: f64 = self.problem.points.iter().map(|p| p.weight).sum();
        let of = |stage: usize| -> f64 {
            let speeds = &self.problem.stages[stage].speeds;
            speeds.iter().zip(&self.problem.points).map(|(v, p)| v * p.weight).sum::<f64>() / area
        };
        match &self.problem.shares {
            Some(shares) => shares.iter().enumerate().map(|(stage, share)| share * of(stage)).sum(),
            None => of(self.stage(state)),
        }
    }

    /// Fills in what follows from the contact.
    fn take_contact(&self, state: &mut WearState, contact: Contact) {
        let acting = self.load(state);
        let Acting { load, rigid } = &*acting;
        state.gap_rate = load.rate.total(&contact.pressure);
        state.lyapunov = load.weights.iter().enumerate().map(|(i, w)| w * load.rate.potential(i, contact.pressure[i])).sum();
        let elastic = load.elastic(&contact.pressure).iter().fold(0.0_f64, |m, v| m.max(v.abs()));
        let opened = state.gap.iter().zip(&self.problem.gap).map(|(now, start)| now - start).fold(0.0, f64::max);
        let mean = load.rate.in_mean(&contact.pressure);
        state.steady_residual = rigid.residual(&load.weights[..mean.len()], &state.gap_rate, &mean, [elastic, opened]);
        state.pressure = contact.pressure;
        state.opening = contact.opening;
        state.coordinates = contact.coordinates;
    }

    fn first_step(&self, state: &WearState) -> f64 {
        match self.problem.stepping {
            Stepping::Fixed(step) => step,
            Stepping::Adaptive { .. } if self.problem.scheme == Scheme::Explicit => self.explicit_step_length(state),
            Stepping::Adaptive { accuracy } => {
                let fastest = state.gap_rate.iter().copied().fold(0.0, f64::max);
                if fastest > 0.0 { accuracy * gap_scale(&self.load(state).load, state) / fastest } else { self.lasts(state) }
            }
        }
    }

    /// A safe part of the stability bound at a state.
    fn explicit_step_length(&self, state: &WearState) -> f64 {
        let acting = self.load(state);
        let modes = run_in(&acting.load, &acting.rigid, &state.pressure, self.mean_speed(state));
        modes.map_or_else(|| self.lasts(state), |modes| EXPLICIT_PART * modes.explicit_limit)
    }

    /// Takes one step into a new state, no farther than the wear wanted.
    fn advance(&self) -> Result<WearState, EvolutionStatus> {
        let mut state = self.state.clone();
        self.enter_interval(&mut state);
        if self.left(&state).is_none() {
            return self.step_from(state);
        }
        if self.is_out_of_reach(&state) {
            return Err(EvolutionStatus::Unreached { time: state.time });
        }
        let to = self.step_from(state.clone())?;
        Ok(self.not_beyond(&state, to))
    }

    /// Takes one step from a state into a new one, shorter until it is accurate enough.
    fn step_from(&self, mut state: WearState) -> Result<WearState, EvolutionStatus> {
        let limit = self.limit(&state);
        if self.is_free(&state) && limit.is_finite() {
            return Ok(self.idle(state, limit));
        }
        let mut wanted = state.first_to_try();
        let mut failures = 0;
        loop {
            let left = limit - state.time;
            let fixed = matches!(self.problem.stepping, Stepping::Fixed(_));
            // Without a rest too short for a step of its own.
            let last = wanted * (1.0 + 1e-9) >= left;
            let (step, cut) = match (last, fixed) {
                (true, _) => (left, true),
                (false, false) if 2.0 * wanted > left => (0.5 * left, true),
                _ => (wanted, false),
            };
            let stuck = self.stuck(&state, step);
            if !step.is_finite() || step <= SHORTEST[0] * state.time || wanted < SHORTEST[1] * state.next_step {
                return Err(stuck);
            }
            let trial = self.trial(&state, step);
            let factor = match (&trial, self.problem.stepping) {
                (None, Stepping::Fixed(_)) => return Err(stuck),
                (None, _) => 0.2,
                (Some(_), Stepping::Fixed(_)) => 1.0,
                (Some(_), _) if self.problem.scheme == Scheme::Explicit => 1.0,
                (Some((trial, _)), Stepping::Adaptive { accuracy }) => {
                    self.factor(&state, accuracy, (step, trial.error), failures)
                }
            };
            match trial {
                Some(tried) if fixed || factor >= 0.9 => {
                    let next = if cut && !fixed {
                        (step * factor).max(wanted)
                    } else if fixed {
                        wanted
                    } else {
                        step * factor
                    };
                    self.accept(&mut state, tried, Taken { step, next, end: last.then_some(limit) });
                    return Ok(state);
                }
                trial => {
                    let trial = trial.map(|(trial, _)| trial);
                    wanted = step * self.part_to_try(&state, trial.as_ref(), (failures, factor));
                    state.newton_iterations += trial.map_or(0, |trial| trial.iterations);
                    state.rejected += 1;
                    failures += 1;
                }
            }
        }
    }

    /// The same contact at a later time: nothing wears any more.
    fn idle(&self, mut state: WearState, until: f64) -> WearState {
        state.step += 1;
        state.step_size = until - state.time;
        state.distance += state.step_size * self.mean_speed(&state);
        state.time = until;
        state.error = 0.0;
        state
    }

    /// Moves a state on by a step that is accurate enough.
    fn accept(&self, state: &mut WearState, (trial, conducting): (Trial, Vec<bool>), Taken { step, next, end }: Taken) {
        state.conducting = conducting;
        self.await_next(state, &trial.contact, step);
        let (before, step_before) = (state.lyapunov, state.next_step);
        state.step += 1;
        state.time = end.unwrap_or(state.time + step);
        state.distance += step * self.mean_speed(state);
        state.gap = trial.gap;
        state.worn = trial.worn;
        state.depth = self.problem.deepest(&state.worn);
        state.recession = trial.recession;
        state.volume = trial.volume;
        state.error = trial.error;
        state.step_size = step;
        state.next_step = next;
        state.newton_iterations += trial.iterations;
        change_approach(state, &trial.contact.coordinates);
        self.take_contact(state, trial.contact);
        let adaptive = matches!(self.problem.stepping, Stepping::Adaptive { .. });
        if adaptive && self.problem.scheme == Scheme::Explicit {
            state.next_step =
                if state.step.is_multiple_of(EXPLICIT_REVIEW) { self.explicit_step_length(state) } else { step_before };
        }
        if before > 0.0 {
            state.lyapunov_increase = state.lyapunov_increase.max((state.lyapunov - before) / before);
        }
    }
}

fn change_approach(state: &mut WearState, coordinates: &[f64]) {
    for (j, approach) in state.approach.iter_mut().enumerate() {
        *approach += coordinates[j] - state.coordinates[j];
    }
}

impl Iterator for Evolution<'_> {
    type Item = WearState;

    fn next(&mut self) -> Option<WearState> {
        if self.fresh {
            self.fresh = false;
            let mut state = self.state.clone();
            self.status = self.unstable(None, &mut state).unwrap_or_else(|| self.ended(&state));
            return Some(self.state.clone());
        }
        if self.status != EvolutionStatus::Running {
            return None;
        }
        match self.advance() {
            Ok(mut state) => {
                self.conduct(&mut state);
                self.status = self.unstable(Some(&self.state), &mut state).unwrap_or_else(|| self.ended(&state));
                self.state = state.clone();
                Some(state)
            }
            Err(status) => {
                self.status = status;
                None
            }
        }
    }
}
