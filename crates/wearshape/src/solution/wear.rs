//! What wear in time came to.

use serde::Serialize;

/// `summary.wear`.
#[derive(Debug, Clone, Default, PartialEq, Serialize)]
pub struct WearResult {
    /// Status of the integration.
    pub status: String,
    /// Accepted steps.
    pub steps: usize,
    /// Rejected steps.
    pub rejected_steps: usize,
    /// Time reached.
    #[serde(rename = "time_s")]
    pub time: Option<f64>,
    /// Sliding distance.
    #[serde(rename = "distance_mm")]
    pub distance: Option<f64>,
    /// Whether it is steady.
    pub steady: bool,
    /// Depth.
    #[serde(rename = "depth_um")]
    pub depth: Option<f64>,
    /// Volume.
    #[serde(rename = "volume_mm3")]
    pub volume: Option<f64>,
    /// Largest stable explicit step.
    #[serde(rename = "explicit_step_limit_s")]
    pub explicit_step_limit: Option<f64>,
    /// Run-in distance of the slowest modes.
    #[serde(rename = "run_in_distance_mm")]
    pub run_in_distance: Vec<f64>,
    /// Largest relative growth of the Lyapunov function in a step; without shear on the bodies it never grows.
    pub lyapunov_increase: Option<f64>,
    /// What it took until the pressure stayed within 1 % of the steady one (relative L2).
    pub to_1_percent: Option<Settled>,
}

/// `summary.wear.to_1_percent`.
#[derive(Debug, Clone, Default, PartialEq, Serialize)]
pub struct Settled {
    /// Time.
    #[serde(rename = "time_s")]
    pub time: f64,
    /// Sliding distance.
    #[serde(rename = "distance_mm")]
    pub distance: f64,
    /// Largest depth worn off body 1.
    #[serde(rename = "depth_um")]
    pub depth: f64,
    /// Volume worn off both bodies.
    #[serde(rename = "volume_mm3")]
    pub volume: f64,
}

/// Pressure and gap of a run in time at the contact points.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct RunningIn {
    /// Surface coordinate of the points (mm).
    pub s: Vec<f64>,
    /// The steps.
    pub steps: Vec<RunningInStep>,
}

/// One step of a run in time.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct RunningInStep {
    /// Number of the step.
    pub step: usize,
    /// Time (s).
    pub time: f64,
    /// Pressure at the points (MPa).
    pub pressure: Vec<f64>,
    /// Unloaded gap at the points (um).
    pub gap: Vec<f64>,
}
