//! `/state`: one accepted step of a run in time, with everything the library needs to go on from it bit for bit.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use shapeopt::{Entering, WearState};

/// The fields of [`WearState`] with their units; numbers are written so that they read back to the same bits.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
pub(crate) struct State {
    /// Steps taken.
    pub(crate) step: u64,
    /// Simulated time.
    #[serde(rename = "time_s")]
    pub(crate) time: f64,
    /// Sliding distance.
    #[serde(rename = "distance_mm")]
    pub(crate) distance: f64,
    /// Largest depth worn off body 1.
    #[serde(rename = "depth_mm")]
    pub(crate) depth: f64,
    /// Volumes worn off body 1 and body 2.
    #[serde(rename = "volume_mm3")]
    pub(crate) volume: [f64; 2],
    /// Depth by which a revolving counter-face has receded.
    #[serde(rename = "recession_mm")]
    pub(crate) recession: f64,
    /// How far the wear is from a rigid motion.
    pub(crate) steady_residual: f64,
    /// Wear power of the bodies that open the gap: the Lyapunov function.
    pub(crate) lyapunov: f64,
    /// Its largest relative growth in a step so far.
    pub(crate) lyapunov_increase: f64,
    /// Length of the last step.
    #[serde(rename = "step_s")]
    pub(crate) step_size: f64,
    /// Length of the next step to try.
    #[serde(rename = "next_step_s")]
    pub(crate) next_step: f64,
    /// Estimated error of the last step.
    pub(crate) error: f64,
    /// Steps rejected so far.
    pub(crate) rejected: u64,
    /// Linear systems solved so far.
    pub(crate) linear_solves: u64,
    /// Number of the piece of the schedule that acts, from 0.
    pub(crate) piece: u64,
    /// Time at which that piece began.
    #[serde(rename = "piece_start_s")]
    pub(crate) piece_start: f64,
    /// Rigid coordinates of the free motions.
    pub(crate) coordinates: Vec<f64>,
    /// Their change since the start.
    pub(crate) approach: Vec<f64>,
    /// Unloaded gap at the contact points.
    #[serde(rename = "gap_mm")]
    pub(crate) gap: Vec<f64>,
    /// Pressure.
    #[serde(rename = "pressure_MPa")]
    pub(crate) pressure: Vec<f64>,
    /// Gap under load.
    #[serde(rename = "opening_mm")]
    pub(crate) opening: Vec<f64>,
    /// Rate of the gap.
    #[serde(rename = "gap_rate_mm_per_s")]
    pub(crate) gap_rate: Vec<f64>,
    /// Depth worn off body 1.
    #[serde(rename = "worn_mm")]
    pub(crate) worn: Vec<f64>,
    /// Which points conduct frictional heat; left out where that changes nothing.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub(crate) conducting: Vec<bool>,
    /// Jumps of the contact by its frictional heat so far; left out where there is none.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub(crate) jumps: u64,
    /// Points that come into a contact that grows; left out where none does.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub(crate) entering: Option<Awaited>,
}

/// The fields of [`Entering`] with their units.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
pub(crate) struct Awaited {
    /// Whether a point has come in with the last step.
    pub(crate) entered: bool,
    /// Time until the next one is expected; zero where none is.
    #[serde(rename = "expected_s")]
    pub(crate) expected: f64,
    /// Length of the first step after the last one.
    #[serde(rename = "first_step_s")]
    pub(crate) first_step: f64,
}

/// Whether a count is left out.
#[allow(clippy::trivially_copy_pass_by_ref)]
fn is_zero(count: &u64) -> bool {
    *count == 0
}

impl From<&WearState> for State {
    fn from(state: &WearState) -> State {
        State {
            step: state.step as u64,
            time: state.time,
            distance: state.distance,
            depth: state.depth,
            volume: state.volume,
            recession: state.recession,
            steady_residual: state.steady_residual,
            lyapunov: state.lyapunov,
            lyapunov_increase: state.lyapunov_increase,
            step_size: state.step_size,
            next_step: state.next_step,
            error: state.error,
            rejected: state.rejected as u64,
            linear_solves: state.newton_iterations as u64,
            piece: state.interval as u64,
            piece_start: state.interval_start,
            coordinates: state.coordinates.clone(),
            approach: state.approach.clone(),
            gap: state.gap.clone(),
            pressure: state.pressure.clone(),
            opening: state.opening.clone(),
            gap_rate: state.gap_rate.clone(),
            worn: state.worn.clone(),
            conducting: state.conducting.clone(),
            jumps: state.jumps as u64,
            entering: awaited(state.entering),
        }
    }
}

fn awaited(entering: Entering) -> Option<Awaited> {
    let Entering { entered, expected, first_step } = entering;
    Some(Awaited { entered, expected, first_step }).filter(|_| entering != Entering::default())
}

impl From<State> for WearState {
    fn from(state: State) -> WearState {
        WearState {
            step: state.step as usize,
            time: state.time,
            distance: state.distance,
            gap: state.gap,
            pressure: state.pressure,
            opening: state.opening,
            coordinates: state.coordinates,
            approach: state.approach,
            gap_rate: state.gap_rate,
            worn: state.worn,
            conducting: state.conducting,
            jumps: state.jumps as usize,
            depth: state.depth,
            recession: state.recession,
            volume: state.volume,
            steady_residual: state.steady_residual,
            lyapunov: state.lyapunov,
            lyapunov_increase: state.lyapunov_increase,
            step_size: state.step_size,
            next_step: state.next_step,
            error: state.error,
            rejected: state.rejected as usize,
            newton_iterations: state.linear_solves as usize,
            interval: state.piece as usize,
            interval_start: state.piece_start,
            entering: state.entering.map_or_else(Entering::default, |Awaited { entered, expected, first_step }| Entering {
                entered,
                expected,
                first_step,
            }),
        }
    }
}
