//! When a run has come within a given part of its steady state, and what it has cost until then.

use crate::evolution::Evolution;
use crate::evolution_status::EvolutionStatus;
use crate::wear_state::WearState;

/// Tries of the root finder, and the part of the time passed at which the moment is found.
const TRIES: usize = 60;
const FOUND: f64 = 1e-12;

/// Time, distance and wear until the pressure stays within a part of the steady one.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Settling {
    /// Deviation `||p - p_end|| / ||p_end||` in the area norm.
    pub deviation: f64,
    /// Time, s.
    pub time: f64,
    /// Sliding distance, mm.
    pub distance: f64,
    /// Largest depth worn off body 1, mm.
    pub depth: f64,
    /// Volumes worn off the bodies, mm^3.
    pub volume: [f64; 2],
}

impl Evolution<'_> {
    /// The moment after which the pressure of a run that ended steady stays within `deviation` of its last pressure, from all states of this run
    /// (whole ones need only their time, distance, gap, pressure, worn depth, recession, volumes and interval). Between the two states around it
    /// the moment is the end of a step of the integrator itself, so that it is as accurate as the run.
    ///
    /// `None` if the run never comes that close before its last state, if the contact wears itself free and no steady pressure is left, or if
    /// there are no states.
    pub fn settling(&self, states: &[WearState], deviation: f64) -> Option<Settling> {
        let end = states.last().filter(|end| self.driven(end))?;
        let norm = |difference: &dyn Fn(usize) -> f64| -> f64 {
            self.weights().enumerate().map(|(i, weight)| weight * difference(i).powi(2)).sum::<f64>().sqrt()
        };
        let size = norm(&|i| end.pressure[i]);
        let away = |pressure: &[f64]| (norm(&|i| pressure[i] - end.pressure[i]) / size / deviation).ln();
        let Some(before) = states.iter().rposition(|state| away(&state.pressure) > 0.0) else {
            return states.first().map(|state| settled(state, deviation));
        };
        if before + 2 >= states.len() {
            return None;
        }
        let from = self.restored(&states[before])?;
        let after = &states[before + 1];
        let found = self.crossing(&from, (after.time - from.time, away(&after.pressure)), &|state| away(&state.pressure))?;
        Some(settled(&found, deviation))
    }

    /// Time (s) and sliding distance (mm) at which a depth (mm) is worn off body 1 where most is, from all states of this run: within it, by a step of the
    /// integrator, or after its steady end by the rates that stay. `None` if the run ends before both.
    pub fn worn_off(&self, states: &[WearState], depth: f64) -> Option<[f64; 2]> {
        let last = states.last()?;
        if let Some(after) = states.iter().position(|state| state.depth >= depth) {
            let left = |state: &WearState| 1.0 - state.depth / depth;
            let (from, to) = (&states[after.checked_sub(1)?], &states[after]);
            if to.interval > from.interval + 1 {
                return self.worn_off_alike([from, to], &states[after..], depth);
            }
            let from = self.restored(from)?;
            let found = self.crossing(&from, (to.time - from.time, left(to)), &left)?;
            return Some([found.time, found.distance]);
        }
        let steady = *self.status() == EvolutionStatus::Steady && self.driven(last);
        let [time, speed] = if steady { self.lasting(last, depth)? } else { return None };
        Some([last.time + time, last.distance + time * speed])
    }

    /// The state at which a value falls to zero within a step from a state where it is positive; `long` is a step at whose end it is not, with the
    /// value there. Regula falsi with halved ends (Illinois).
    pub(crate) fn crossing(
        &self,
        from: &WearState,
        mut long: (f64, f64),
        value_of: &dyn Fn(&WearState) -> f64,
    ) -> Option<WearState> {
        let mut short = (0.0, value_of(from));
        let mut kept = 0.0;
        let mut found = None;
        for _ in 0..TRIES {
            let secant = (short.0 * long.1 - long.0 * short.1) / (long.1 - short.1);
            let step = if secant > short.0 && secant < long.0 { secant } else { 0.5 * (short.0 + long.0) };
            if !(step > short.0 && step < long.0) {
                break;
            }
            let state = self.after(from, step)?;
            let value = value_of(&state);
            let done = value.abs() <= FOUND || long.0 - short.0 <= FOUND * state.time;
            found = Some(state);
            if done {
                break;
            }
            let again = if kept == value.signum() { 0.5 } else { 1.0 };
            if value > 0.0 {
                short = (step, value);
                long.1 *= again;
            } else {
                long = (step, value);
                short.1 *= again;
            }
            kept = value.signum();
        }
        found
    }
}

fn settled(state: &WearState, deviation: f64) -> Settling {
    Settling { deviation, time: state.time, distance: state.distance, depth: state.depth, volume: state.volume }
}
