//! Estimated errors in the words of the summary.

use serde::Serialize;

/// `summary.error`: estimated relative errors.
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
    /// How they were estimated.
    pub how: String,
}
