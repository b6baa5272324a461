//! What was computed: plain data, one struct a stage, the profile at the contact points, counters and times.

mod contact;
mod wear;

pub use self::contact::{ContactResult, InterfaceResult, TwistResult, UniquenessResult};
pub use self::wear::{RunningIn, RunningInStep, Settled, WearResult};
use serde::Serialize;

use crate::body_field::FieldFrame;
use crate::effort::Effort;
use crate::machined::Machined;
use crate::profile::Profile;
use crate::remark::Remark;
use crate::watch::Resume;

/// How a run ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Status {
    /// Everything asked for was computed.
    #[default]
    Ok,
    /// Computed, with an estimated error above the accuracy asked for.
    AccuracyMissed,
    /// An iteration did not arrive.
    NotConverged,
    /// The scene has no answer.
    Refused,
    /// The user asked to stop; the partial folder is kept.
    Interrupted,
}

/// Everything a run knows when it is done. A stage that did not run is `None`.
#[derive(Debug, Clone, Default)]
pub struct Solution {
    /// How it ended.
    pub status: Status,
    /// Why, when it did not end well: one sentence.
    pub reason: Option<String>,
    /// The optimal pressure.
    pub pressure: Option<PressureResult>,
    /// The contact of the bodies as given.
    pub contact: Option<ContactResult>,
    /// The shape.
    pub shape: Option<ShapeResult>,
    /// Wear in time.
    pub wear: Option<WearResult>,
    /// Strain energies.
    pub energy: Option<EnergyResult>,
    /// Reaction of each supported edge, by "body1.left".
    pub reactions: Vec<(String, Reaction)>,
    /// Estimated errors.
    pub error: Option<ErrorResult>,
    /// Condition of the system on the contact surface.
    pub interface: Option<InterfaceResult>,
    /// Columns at the contact points, of the last task.
    pub profile: Option<Profile>,
    /// The same at evenly spaced points of a surface known without a mesh, for pictures.
    pub curve: Option<Profile>,
    /// Columns of history.csv: name and values.
    pub history: Vec<(String, Vec<f64>)>,
    /// Pressure and gap of a run in time, step by step.
    pub running_in: Option<RunningIn>,
    /// The levels of the last task that has any.
    pub ladder: Vec<Rung>,
    /// The surface to machine, of a shape.
    pub machined: Option<Machined>,
    /// Displacement and stress inside the bodies, the reported moment first; empty unless an output asks for them.
    pub fields: Vec<FieldFrame>,
    /// Remarks that only the result could tell.
    pub remarks: Vec<Remark>,
    /// What it took.
    pub effort: Effort,
    /// An unfinished run in time that was stopped, to go on with.
    pub resume: Option<Resume>,
}

/// One number for each role of a rigid mode.
#[derive(Debug, Clone, Default, PartialEq, Serialize)]
pub struct ByRole {
    /// Of the pressing force.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub force: Option<f64>,
    /// Of the moment.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub moment: Option<f64>,
    /// Of the second moment.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub moment_y: Option<f64>,
    /// Of the force along x.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub side_force: Option<f64>,
}

/// A concentrated force of a singular pressure.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct PointForce {
    /// Place.
    #[serde(rename = "x_mm")]
    pub x: f64,
    /// Place.
    #[serde(rename = "y_mm")]
    pub y: f64,
    /// Place.
    #[serde(rename = "z_mm")]
    pub z: f64,
    /// Normal force there; for lines and circles of the whole line.
    #[serde(rename = "force_N")]
    pub force: f64,
}

/// `summary.pressure`.
#[derive(Debug, Clone, Default, PartialEq, Serialize)]
pub struct PressureResult {
    /// Functional in the scene's word.
    pub functional: String,
    /// Its q; only the three functionals of the paper use it.
    pub q: Option<f64>,
    /// equilibrium or paper.
    pub balance: String,
    /// kinematic or associated.
    pub modes: String,
    /// Exponent s.
    pub s: Option<f64>,
    /// Exponent k = 1/(s - 1).
    pub k: Option<f64>,
    /// minimum, maximum, indifferent, stationary.
    pub character: String,
    /// regular, near-singular, singular, partial-contact, infeasible, several.
    pub regime: String,
    /// Forces of a singular pressure.
    pub limit_measure: Vec<PointForce>,
    /// Multiplier of each resultant.
    pub multipliers: ByRole,
    /// Rigid velocity of wear.
    pub feed: Option<ByRole>,
    /// Smallest pressure.
    #[serde(rename = "p_min_MPa")]
    pub p_min: Option<f64>,
    /// Largest pressure.
    #[serde(rename = "p_max_MPa")]
    pub p_max: Option<f64>,
    /// Mean pressure.
    #[serde(rename = "p_mean_MPa")]
    pub p_mean: Option<f64>,
    /// Carried pressing force.
    #[serde(rename = "force_N")]
    pub force: Option<f64>,
    /// Carried moment.
    #[serde(rename = "moment_Nmm")]
    pub moment: Option<f64>,
    /// int p dS.
    #[serde(rename = "normal_force_N")]
    pub normal_force: Option<f64>,
    /// Wear volume a second of both bodies.
    #[serde(rename = "wear_volume_rate_mm3_per_s")]
    pub wear_volume_rate: Option<f64>,
    /// Friction power.
    #[serde(rename = "friction_power_mW")]
    pub friction_power: Option<f64>,
    /// Wear power.
    #[serde(rename = "wear_power_mW")]
    pub wear_power: Option<f64>,
    /// Friction torque.
    #[serde(rename = "torque_Nmm")]
    pub torque: Option<f64>,
    /// Torque over mu times force.
    #[serde(rename = "effective_radius_mm")]
    pub effective_radius: Option<f64>,
    /// How far the wear is from a rigid motion.
    pub steadiness_residual: Option<f64>,
    /// How far the wear of both bodies is from proportional.
    pub congruence_residual: Option<f64>,
}

/// `summary.shape`.
#[derive(Debug, Clone, Default, PartialEq, Serialize)]
pub struct ShapeResult {
    /// Passes of the gap iteration.
    pub iterations: usize,
    /// Largest gap.
    #[serde(rename = "gap_max_um")]
    pub gap_max: Option<f64>,
    /// Where it is.
    #[serde(rename = "gap_where_mm")]
    pub gap_where: Option<f64>,
    /// Crown height: the largest gap; above the lowest one where the rigid part is prescribed.
    #[serde(rename = "crown_um")]
    pub crown: Option<f64>,
    /// Rigid part taken out.
    #[serde(rename = "rigid_mm")]
    pub rigid: Option<f64>,
    /// Round trip on the same operators.
    pub roundtrip_same: Option<f64>,
    /// Round trip on another discretisation.
    pub roundtrip_independent: Option<f64>,
    /// What errors of the shape do.
    pub tolerance: Vec<ToleranceResult>,
}

/// One entry of `summary.shape.tolerance`: an error of the shape in proportion to its amplitude.
#[derive(Debug, Clone, Default, PartialEq, Serialize)]
pub struct ToleranceResult {
    /// What kind of error; L is the length of the surface.
    pub error: String,
    /// Amplitude of the error.
    #[serde(rename = "amplitude_um")]
    pub amplitude: f64,
    /// Largest change of the pressure over the inner 95 % of the surface, over the mean pressure.
    pub pressure_change_relative: f64,
    /// Root mean square of the change over the whole surface, over the mean pressure.
    pub pressure_change_rms: f64,
    /// Amplitude that changes the pressure by 10 % of its mean.
    #[serde(rename = "within_10_percent_um")]
    pub within_10_percent: f64,
    /// Sliding distance in which wear takes the change down to 1/e.
    #[serde(rename = "run_in_distance_mm")]
    pub run_in_distance: Option<f64>,
}

/// `summary.energy`.
#[derive(Debug, Clone, Default, PartialEq, Serialize)]
pub struct EnergyResult {
    /// Strain energy of body 1.
    #[serde(rename = "body1_Nmm")]
    pub body1: Option<f64>,
    /// Strain energy of body 2.
    #[serde(rename = "body2_Nmm")]
    pub body2: Option<f64>,
}

impl EnergyResult {
    /// Of both bodies.
    pub fn total(&self) -> f64 {
        self.body1.unwrap_or(0.0) + self.body2.unwrap_or(0.0)
    }
}

/// One entry of `summary.reactions`.
#[derive(Debug, Clone, Default, PartialEq, Serialize)]
pub struct Reaction {
    /// Along x.
    #[serde(rename = "x_N")]
    pub x: Option<f64>,
    /// Along z.
    #[serde(rename = "z_N")]
    pub z: Option<f64>,
    /// Moment.
    #[serde(rename = "moment_Nmm")]
    pub moment: Option<f64>,
}

/// What a level of the ladder says about the error.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Rung {
    /// What is compared: gap or pressure.
    pub quantity: &'static str,
    /// Degree of the level.
    pub degree: usize,
    /// Relative difference from the level before.
    pub change: Option<f64>,
    /// Estimated relative error, from this level and the two before it.
    pub estimate: Option<f64>,
}

/// `summary.error`: estimated relative errors.
#[derive(Debug, Clone, Default, PartialEq, Serialize)]
pub struct ErrorResult {
    /// Of the gap.
    pub gap_relative: Option<f64>,
    /// Of the pressure.
    pub pressure_relative: Option<f64>,
    /// Of the energy.
    pub energy_relative: Option<f64>,
    /// Of the torque of a twist, or of its angle where the torque is given.
    pub twist_relative: Option<f64>,
    /// How they were estimated.
    pub how: String,
}
