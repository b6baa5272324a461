//! `/state`: one accepted step of a run in time, with everything the library needs to go on from it bit for bit.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use shapeopt::WearState;

/// The fields of [`WearState`] with their units; numbers are written so that they read back to the same bits.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[allow(non_snake_case)]
pub(crate) struct State {
    /// Steps taken.
    pub(crate) step: u64,
    /// Simulated time.
    pub(crate) time_s: f64,
    /// Sliding distance.
    pub(crate) distance_mm: f64,
    /// Largest depth worn off body 1.
    pub(crate) depth_mm: f64,
    /// Volumes worn off body 1 and body 2.
    pub(crate) volume_mm3: [f64; 2],
    /// Depth by which a revolving counter-face has receded.
    pub(crate) recession_mm: f64,
    /// How far the wear is from a rigid motion.
    pub(crate) steady_residual: f64,
    /// Wear power of the bodies that open the gap: the Lyapunov function.
    pub(crate) lyapunov: f64,
    /// Its largest relative growth in a step so far.
    pub(crate) lyapunov_increase: f64,
    /// Length of the last step.
    pub(crate) step_s: f64,
    /// Length of the next step to try.
    pub(crate) next_step_s: f64,
    /// Estimated error of the last step.
    pub(crate) error: f64,
    /// Steps rejected so far.
    pub(crate) rejected: u64,
    /// Linear systems solved so far.
    pub(crate) linear_solves: u64,
    /// Number of the piece of the schedule that acts, from 0.
    pub(crate) piece: u64,
    /// Time at which that piece began.
    pub(crate) piece_start_s: f64,
    /// Rigid coordinates of the free motions.
    pub(crate) coordinates: Vec<f64>,
    /// Their change since the start.
    pub(crate) approach: Vec<f64>,
    /// Unloaded gap at the contact points.
    pub(crate) gap_mm: Vec<f64>,
    /// Pressure.
    pub(crate) pressure_MPa: Vec<f64>,
    /// Gap under load.
    pub(crate) opening_mm: Vec<f64>,
    /// Rate of the gap.
    pub(crate) gap_rate_mm_per_s: Vec<f64>,
    /// Depth worn off body 1.
    pub(crate) worn_mm: Vec<f64>,
}

impl From<&WearState> for State {
    fn from(state: &WearState) -> State {
        State {
            step: state.step as u64,
            time_s: state.time,
            distance_mm: state.distance,
            depth_mm: state.depth,
            volume_mm3: state.volume,
            recession_mm: state.recession,
            steady_residual: state.steady_residual,
            lyapunov: state.lyapunov,
            lyapunov_increase: state.lyapunov_increase,
            step_s: state.step_size,
            next_step_s: state.next_step,
            error: state.error,
            rejected: state.rejected as u64,
            linear_solves: state.newton_iterations as u64,
            piece: state.interval as u64,
            piece_start_s: state.interval_start,
            coordinates: state.coordinates.clone(),
            approach: state.approach.clone(),
            gap_mm: state.gap.clone(),
            pressure_MPa: state.pressure.clone(),
            opening_mm: state.opening.clone(),
            gap_rate_mm_per_s: state.gap_rate.clone(),
            worn_mm: state.worn.clone(),
        }
    }
}

impl From<State> for WearState {
    fn from(state: State) -> WearState {
        WearState {
            step: state.step as usize,
            time: state.time_s,
            distance: state.distance_mm,
            gap: state.gap_mm,
            pressure: state.pressure_MPa,
            opening: state.opening_mm,
            coordinates: state.coordinates,
            approach: state.approach,
            gap_rate: state.gap_rate_mm_per_s,
            worn: state.worn_mm,
            depth: state.depth_mm,
            recession: state.recession_mm,
            volume: state.volume_mm3,
            steady_residual: state.steady_residual,
            lyapunov: state.lyapunov,
            lyapunov_increase: state.lyapunov_increase,
            step_size: state.step_s,
            next_step: state.next_step_s,
            error: state.error,
            rejected: state.rejected as usize,
            newton_iterations: state.linear_solves as usize,
            interval: state.piece as usize,
            interval_start: state.piece_start_s,
        }
    }
}
