//! The states of a run as far as they are looked at again: the table history.csv, what the running-in has cost, and where to go on.

use shapeopt::{Evolution, WearState};

use crate::results::Settled;
use crate::solution::{RunningIn, RunningInStep};

/// How close to the steady pressure counts as worn in.
pub(super) const DEVIATION: f64 = 0.01;

/// All states of a run; only the last one is whole.
#[derive(Debug, Clone, Default)]
pub(super) struct History {
    /// The states, step by step.
    pub states: Vec<WearState>,
}

const COLUMNS: [&str; 13] = [
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
    "piece",
];

impl History {
    /// Adds a state; the one before gives up what a run needs only to go on from it.
    pub(super) fn push(&mut self, state: WearState) {
        if let Some(last) = self.states.last_mut() {
            let whole = std::mem::take(last);
            *last =
                WearState { opening: Vec::new(), coordinates: Vec::new(), approach: Vec::new(), gap_rate: Vec::new(), ..whole };
        }
        self.states.push(state);
    }

    /// Pressure, in the mean where loads act by turns, and gap of every step, at places along the surface (mm).
    pub(super) fn running_in(&self, s: Vec<f64>, mean: &dyn Fn(&[f64]) -> Vec<f64>) -> RunningIn {
        let step = |(k, state): (usize, &WearState)| RunningInStep {
            step: state.step,
            time: state.time,
            pressure: mean(&of_surface(state, k.checked_sub(1).map(|k| &self.states[k]))),
            gap: state.gap.iter().map(|g| 1e3 * g).collect(),
        };
        RunningIn { s, steps: self.states.iter().enumerate().map(step).collect() }
    }

    /// Names and values of the columns of history.csv.
    pub(super) fn columns(&self) -> Vec<(String, Vec<f64>)> {
        let rows: Vec<[f64; COLUMNS.len()]> =
            self.states.iter().enumerate().map(|(k, state)| row(state, k.checked_sub(1).map(|k| &self.states[k]))).collect();
        let column = |k: usize| rows.iter().map(|row| row[k]).collect();
        COLUMNS.iter().enumerate().map(|(k, name)| (name.to_string(), column(k))).collect()
    }

    /// What the running-in of a run that ended steady has cost.
    pub(super) fn settled(&self, evolution: &Evolution<'_>) -> Option<Settled> {
        evolution.settling(&self.states, DEVIATION).map(|found| Settled {
            time: found.time,
            distance: found.distance,
            depth: 1e3 * found.depth,
            volume: found.volume[0] + found.volume[1],
        })
    }
}

fn row(state: &WearState, before: Option<&WearState>) -> [f64; COLUMNS.len()] {
    let extreme = |start: f64, f: fn(f64, f64) -> f64| state.pressure.iter().copied().fold(start, f);
    [
        state.step as f64,
        state.time,
        state.distance,
        state.step_size,
        largest(state, before),
        extreme(f64::INFINITY, f64::min),
        1e3 * state.depth,
        state.volume[0],
        state.volume[1],
        state.steady_residual,
        state.lyapunov,
        state.rejected as f64,
        state.interval as f64,
    ]
}

/// The largest pressure (MPa) of the points that pressed in the state before, too: where a point closes within a step, the last stage of the
/// step makes up for those in which it was open, and its pressure is none of the surface. All points count where none is left.
fn largest(state: &WearState, before: Option<&WearState>) -> f64 {
    let most = |pressed: &dyn Fn(usize) -> bool| {
        state.pressure.iter().enumerate().filter(|(k, _)| pressed(*k)).map(|(_, p)| *p).fold(0.0, f64::max)
    };
    let lasting = before.map_or(0.0, |before| most(&|k| before.pressure.get(k).is_some_and(|p| *p > 0.0)));
    if lasting > 0.0 { lasting } else { most(&|_| true) }
}

/// Pressures of a state (MPa), NaN where they are none of the surface: at points that have closed within the step with more than the [`largest`].
pub(super) fn of_surface(state: &WearState, before: Option<&WearState>) -> Vec<f64> {
    let most = largest(state, before);
    state.pressure.iter().map(|p| if *p > most { f64::NAN } else { *p }).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn state(pressure: [f64; 4]) -> WearState {
        WearState { pressure: pressure.to_vec(), ..WearState::default() }
    }

    /// A point that has just closed does not count as the largest pressure, unless it stands alone.
    #[test]
    fn largest_pressure_is_that_of_points_that_stay_in_contact() {
        let history =
            History { states: vec![state([5.0, 4.0, 0.0, 0.0]), state([3.0, 4.0, 9.0, 0.0]), state([0.0, 0.0, 0.0, 7.0])] };
        assert_eq!(history.columns()[4].1, [5.0, 4.0, 7.0]);
        let running_in = history.running_in(vec![0.0; 4], &<[f64]>::to_vec);
        assert_eq!(running_in.steps[0].pressure, [5.0, 4.0, 0.0, 0.0]);
        assert!(running_in.steps[1].pressure[2].is_nan() && running_in.steps[1].pressure[..2] == [3.0, 4.0]);
        assert_eq!(running_in.steps[2].pressure, [0.0, 0.0, 0.0, 7.0]);
    }
}
