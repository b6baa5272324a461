//! The table history.csv: one row a step.

use shapeopt::WearState;

/// Columns of history.csv.
#[derive(Default)]
pub(super) struct History {
    rows: Vec<[f64; COLUMNS.len()]>,
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
    /// Adds a state.
    pub(super) fn push(&mut self, state: &WearState) {
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
            state.interval as f64,
        ]);
    }

    /// Names and values of the columns.
    pub(super) fn columns(&self) -> Vec<(String, Vec<f64>)> {
        let column = |k: usize| self.rows.iter().map(|row| row[k]).collect();
        COLUMNS.iter().enumerate().map(|(k, name)| (name.to_string(), column(k))).collect()
    }
}
