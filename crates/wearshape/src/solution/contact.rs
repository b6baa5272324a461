//! What a contact came to.

use serde::Serialize;

/// `summary.contact`.
#[derive(Debug, Clone, Default, PartialEq, Serialize)]
pub struct ContactResult {
    /// Status of the solve.
    pub status: String,
    /// Contact force.
    #[serde(rename = "force_N")]
    pub force: Option<f64>,
    /// Contact moment.
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
    pub status: String,
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
    pub verdict: String,
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
