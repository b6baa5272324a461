//! The results of the steps in the words of the summary: one struct a step; its keys carry the units.

use scene::{Balance, Functional, Modes};
use serde::Serialize;

pub use crate::energy_result::EnergyResult;
pub use crate::error_result::ErrorResult;

use crate::life_result::LifeResult;
use crate::turns_result::TurnsResult;
use crate::words::{Character, ContactStatus, Regime, TwistStatus, Uniqueness, WearStatus};

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
    pub functional: Functional,
    /// Its q; only the three functionals of the paper use it.
    pub q: Option<f64>,
    /// equilibrium or paper.
    pub balance: Balance,
    /// kinematic or associated.
    pub modes: Modes,
    /// Exponent s.
    pub s: Option<f64>,
    /// Exponent k = 1/(s - 1).
    pub k: Option<f64>,
    /// minimum, maximum, indifferent, stationary.
    pub character: Option<Character>,
    /// regular, near-singular, singular, partial-contact, infeasible, several.
    pub regime: Option<Regime>,
    /// Says so where the wear rule is no power of the pressure: with a threshold, or given as a function in place of the scene's.
    pub wear_rule: Option<&'static str>,
    /// Forces of a singular pressure.
    pub limit_measure: Vec<PointForce>,
    /// Multiplier of each resultant.
    pub multipliers: ByRole,
    /// Rigid velocity of wear.
    pub feed: Option<ByRole>,
    /// Smallest pressure; of a reversing motion that of the mean of both senses.
    #[serde(rename = "p_min_MPa")]
    pub p_min: Option<f64>,
    /// Largest pressure; of a reversing motion that of the mean of both senses, whose own are in [`ReversingResult`](crate::ReversingResult).
    #[serde(rename = "p_max_MPa")]
    pub p_max: Option<f64>,
    /// Place (x, y, z) of the largest pressure.
    #[serde(rename = "p_max_at_mm", skip_serializing_if = "Option::is_none")]
    pub p_max_at: Option<[f64; 3]>,
    /// Mean pressure.
    #[serde(rename = "p_mean_MPa")]
    pub p_mean: Option<f64>,
    /// Carried pressing force.
    #[serde(rename = "force_N")]
    pub force: Option<f64>,
    /// Carried moment of the pressure, with the sign of [`ContactResult::moment`].
    #[serde(rename = "moment_Nmm")]
    pub moment: Option<f64>,
    /// int p dS.
    #[serde(rename = "normal_force_N")]
    pub normal_force: Option<f64>,
    /// Wear volume a second of both bodies.
    #[serde(rename = "wear_volume_rate_mm3_per_s")]
    pub wear_volume_rate: Option<f64>,
    /// Mean depth worn off both bodies over the surface in an hour.
    #[serde(rename = "wear_depth_um_per_h", skip_serializing_if = "Option::is_none")]
    pub wear_depth_per_hour: Option<f64>,
    /// The same by the mean sliding distance.
    #[serde(rename = "wear_depth_mm_per_1000_km", skip_serializing_if = "Option::is_none")]
    pub wear_depth_per_1000_km: Option<f64>,
    /// How long the thickness that may wear off body 1 lasts.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub life: Option<LifeResult>,
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
    /// What 1 % more of each given number does; empty where the pressure has no derivative, or carries the force of a prescribed approach.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub sensitivity: Vec<SensitivityResult>,
}

/// One entry of `summary.pressure.sensitivity`: what 1 % more of a given number does to first order, in per cent.
#[derive(Debug, Clone, Default, PartialEq, Serialize)]
pub struct SensitivityResult {
    /// Key of the number in the scene: "load.force", "contact.friction", "wear.beta.0"; without an index where both bodies have the same one.
    pub given: String,
    /// Of the mean wear rate of the gap; none where nothing wears.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub wear_rate_percent: Option<f64>,
    /// Of the friction torque, or of the friction force where body 2 translates; none without friction.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub torque_percent: Option<f64>,
    /// Of the largest pressure.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub p_max_percent: Option<f64>,
}

/// `summary.contact`.
#[derive(Debug, Clone, Default, PartialEq, Serialize)]
pub struct ContactResult {
    /// Status of the solve.
    pub status: ContactStatus,
    /// Contact force.
    #[serde(rename = "force_N")]
    pub force: Option<f64>,
    /// Moment of the contact pressure on body 1, `int (x - about_x) p n_z dS` about `load.about`: positive where it presses harder at the side of greater
    /// x.
    #[serde(rename = "moment_Nmm")]
    pub moment: Option<f64>,
    /// Closing of body 1.
    #[serde(rename = "approach_mm")]
    pub approach: Option<f64>,
    /// Rotation of body 1.
    #[serde(rename = "tilt_rad")]
    pub tilt: Option<f64>,
    /// Ends of contact.
    #[serde(rename = "ends_mm")]
    pub ends: Vec<f64>,
    /// Largest pressure.
    #[serde(rename = "p_max_MPa")]
    pub p_max: Option<f64>,
    /// Exponents of the pressure at sharp ends.
    pub edge_exponents: Vec<f64>,
    /// Ends of the sticking zone.
    #[serde(rename = "stick_ends_mm")]
    pub stick_ends: Vec<f64>,
    /// Largest shear.
    #[serde(rename = "q_max_MPa")]
    pub q_max: Option<f64>,
    /// Body 1 turned about the axis.
    pub twist: Option<TwistResult>,
    /// Other solutions under friction.
    pub uniqueness: Option<UniquenessResult>,
    /// Residual of p g = 0.
    pub complementarity: Option<f64>,
    /// Iterations.
    pub iterations: Option<usize>,
}

/// `summary.contact.twist`: one number a step of the history.
#[derive(Debug, Clone, Default, PartialEq, Serialize)]
pub struct TwistResult {
    /// sticks, slips-in-part, slips or turns-through, at the end of the last step.
    pub status: TwistStatus,
    /// Rotation of the edge on which body 1 is held.
    #[serde(rename = "angle_rad")]
    pub angle: Vec<f64>,
    /// Torque on body 1.
    #[serde(rename = "torque_Nmm")]
    pub torque: Vec<f64>,
    /// Torque at which the whole contact slips.
    #[serde(rename = "slip_torque_Nmm")]
    pub slip_torque: f64,
}

/// `summary.contact.uniqueness`: coefficients of friction up to that of the scene.
#[derive(Debug, Clone, Default, PartialEq, Serialize)]
pub struct UniquenessResult {
    /// guaranteed, not-guaranteed, singular, or several.
    pub verdict: Uniqueness,
    /// From where one solution is not guaranteed.
    pub not_guaranteed_from: Option<f64>,
    /// From where the determinant of the system has changed its sign.
    pub singular_from: Option<f64>,
    /// From where the solution followed from no friction is lost.
    pub lost_from: Option<f64>,
}

/// `summary.interface`: the scaled system of the points in contact that the last contact solve rests on.
#[derive(Debug, Clone, Default, PartialEq, Serialize)]
pub struct InterfaceResult {
    /// Largest over smallest singular value.
    pub condition: f64,
    /// The smallest; it vanishes where solutions branch.
    pub smallest_singular_value: f64,
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
    /// Abscissa of the smallest gap, where the shape is next to the counter-face (mm).
    #[serde(rename = "gap_least_where_mm")]
    pub gap_least_where: Option<f64>,
    /// Crown height: the largest gap; above the lowest one where the rigid part is prescribed.
    #[serde(rename = "crown_um")]
    pub crown: Option<f64>,
    /// Rigid part of the gap: motion of body 1 along its normal (where it may turn, at `load.about`), positive opening.
    #[serde(rename = "rigid_mm")]
    pub rigid: Option<f64>,
    /// Turn of it, of a body that may turn: positive where the side of larger x opens.
    #[serde(rename = "rigid_rad")]
    pub turned: Option<f64>,
    /// Round trip on the same operators.
    pub roundtrip_same: Option<f64>,
    /// Round trip on another discretisation.
    pub roundtrip_independent: Option<f64>,
    /// Whether a round trip misses by more than round-off and the estimated error of the gap allow; the status says so in words.
    #[serde(skip)]
    pub proof_failed: bool,
    /// Whether its gap is round-off.
    #[serde(skip)]
    pub flat: bool,
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

/// `summary.wear`.
#[derive(Debug, Clone, Default, PartialEq, Serialize)]
pub struct WearResult {
    /// Status of the integration.
    pub status: WearStatus,
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
    /// How far body 1 closes from where the gap stands, as of a contact (`approach_mm` there).
    #[serde(rename = "approach_mm")]
    pub approach: Option<f64>,
    /// How far it turns.
    #[serde(rename = "tilt_rad")]
    pub tilt: Option<f64>,
    /// Width of the scar of a round contact; of a ball its diameter.
    #[serde(rename = "scar_mm", skip_serializing_if = "Option::is_none")]
    pub scar: Option<f64>,
    /// Ends of the contact of two circles or of a cylinder on a flat, along the surface.
    #[serde(rename = "ends_mm", skip_serializing_if = "Option::is_none")]
    pub ends: Option<[f64; 2]>,
    /// Volumes of a round contact, body by body.
    #[serde(rename = "volumes_mm3", skip_serializing_if = "Option::is_none")]
    pub volumes: Option<[f64; 2]>,
    /// Groove in a revolving disc.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub groove: Option<GrooveResult>,
    /// How long what may wear off lasts from this start.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub life: Option<LifeResult>,
    /// Reversals that repeat.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub turns: Option<TurnsResult>,
    /// Largest stable explicit step.
    #[serde(rename = "explicit_step_limit_s")]
    pub explicit_step_limit: Option<f64>,
    /// Run-in distance of the slowest modes.
    #[serde(rename = "run_in_distance_mm")]
    pub run_in_distance: Vec<f64>,
    /// Largest relative growth of the Lyapunov function in a step; without shear on the bodies it never grows.
    pub lyapunov_increase: Option<f64>,
    /// Estimated relative error of the time, distance and depth of `to_1_percent`, or else of the depth at the end: what the steps in time and
    /// the levels of discretisation leave.
    pub run_in_error: Option<f64>,
    /// What it took until the pressure stayed within 1 % of the steady one (relative L2).
    pub to_1_percent: Option<Settled>,
}

/// `summary.wear.groove`: what a ball wears into a revolving disc; its profile stands in groove.csv.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct GrooveResult {
    /// Depth in the middle of the track.
    #[serde(rename = "depth_um")]
    pub depth: f64,
    /// Width.
    #[serde(rename = "width_mm")]
    pub width: f64,
    /// Volume.
    #[serde(rename = "volume_mm3")]
    pub volume: f64,
    /// Depth over the depth worn off the ball. The contact knows the groove by its mean around the axis of the ball; what that leaves out is of the
    /// order of the square of this.
    pub depth_ratio: f64,
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

/// One entry of `summary.reactions`.
#[derive(Debug, Clone, Default, PartialEq, Serialize)]
pub struct Reaction {
    /// Along x.
    #[serde(rename = "x_N")]
    pub x: Option<f64>,
    /// Along z.
    #[serde(rename = "z_N")]
    pub z: Option<f64>,
    /// Moment about the origin, `x F_z - z F_x`: positive from +x to +z, anti-clockwise in the drawing.
    #[serde(rename = "moment_Nmm")]
    pub moment: Option<f64>,
}
