//! Estimated errors in the words of the summary.

use serde::Serialize;

/// `summary.error`: estimated errors.
#[derive(Debug, Clone, Default, PartialEq, Serialize)]
pub struct ErrorResult {
    /// Of the gap.
    pub gap_relative: Option<f64>,
    /// Of the pressure.
    pub pressure_relative: Option<f64>,
    /// Of the energies of both bodies: the sum of their errors over the sum of the energies.
    pub energy_relative: Option<f64>,
    /// Of the torque of a twist, or of its angle where the torque is given.
    pub twist_relative: Option<f64>,
    /// Of the largest pressure of a contact: how far that of the level before is from it, or of the level beside a fixed one. Where the pressure has a peak its
    /// largest value is known less well than the whole.
    pub p_max_relative: Option<f64>,
    /// Largest of the ends of contact inside the surface; they may be off by more than the pressure is, where it falls slowly towards them.
    #[serde(rename = "ends_mm")]
    pub ends: Option<f64>,
    /// Largest of the ends of the sticking zone.
    #[serde(rename = "stick_ends_mm")]
    pub stick_ends: Option<f64>,
    /// How they were estimated.
    pub how: String,
}
