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
        let step = |state: &WearState| RunningInStep {
            step: state.step,
            time: state.time,
            pressure: mean(&state.pressure),
            gap: state.gap.iter().map(|g| 1e3 * g).collect(),
        };
        RunningIn { s, steps: self.states.iter().map(step).collect() }
    }

    /// Names and values of the columns of history.csv.
    pub(super) fn columns(&self) -> Vec<(String, Vec<f64>)> {
        let rows: Vec<[f64; COLUMNS.len()]> = self.states.iter().map(row).collect();
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

fn row(state: &WearState) -> [f64; COLUMNS.len()] {
    let extreme = |start: f64, f: fn(f64, f64) -> f64| state.pressure.iter().copied().fold(start, f);
    [
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
        state.interval as f64,
    ]
}
