//! `summary.machining`: what machining brings.

use serde::Serialize;

/// `summary.machining`: the contact on the gap as given, and on the shape to machine.
#[derive(Debug, Clone, Default, PartialEq, Serialize)]
pub struct MachiningResult {
    /// Largest pressure as it is now; none where it grows without limit towards sharp edges.
    #[serde(rename = "p_max_now_MPa")]
    pub p_max_now: Option<f64>,
    /// Largest pressure as machined; of a reversing motion the larger one of both senses.
    #[serde(rename = "p_max_then_MPa")]
    pub p_max_then: Option<f64>,
    /// Part of the surface under pressure as it is now.
    pub contact_share_now: f64,
    /// Part of the surface under pressure as machined.
    pub contact_share_then: Option<f64>,
    /// Most taken off.
    #[serde(rename = "gap_max_um")]
    pub gap_max: Option<f64>,
    /// Most that lies between the surface as it is and the one as machined, once they touch.
    #[serde(rename = "differs_um")]
    pub differs: Option<f64>,
    /// Roughness given.
    #[serde(rename = "roughness_um")]
    pub roughness: Option<f64>,
    /// Whether the surface as it is and the one as machined differ by more than the roughness; none where no roughness is given.
    pub worth_machining: Option<bool>,
    /// Sliding distance until the pressure of the surface as it is now is within 1 % of the steady one; none unless a run in time has told it.
    #[serde(rename = "run_in_distance_saved_mm")]
    pub run_in_distance_saved: Option<f64>,
}
