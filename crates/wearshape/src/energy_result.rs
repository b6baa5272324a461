//! Strain energies in the words of the summary.

use serde::Serialize;

/// `summary.energy`: 1/2 int sigma : (eps - eps_th) dV (N mm).
#[derive(Debug, Clone, Default, PartialEq, Serialize)]
pub struct EnergyResult {
    /// Of body 1, of its displacement in the plane.
    #[serde(rename = "body1_Nmm")]
    pub body1: Option<f64>,
    /// The same of body 2.
    #[serde(rename = "body2_Nmm")]
    pub body2: Option<f64>,
    /// What the twist about the axis of revolution, half the work of the shear on the contact, adds to it.
    #[serde(rename = "body1_twist_Nmm", skip_serializing_if = "Option::is_none")]
    pub twist1: Option<f64>,
    /// The same of body 2.
    #[serde(rename = "body2_twist_Nmm", skip_serializing_if = "Option::is_none")]
    pub twist2: Option<f64>,
}

impl EnergyResult {
    /// Of both bodies, without twist (N mm).
    pub fn total(&self) -> f64 {
        self.body1.unwrap_or(0.0) + self.body2.unwrap_or(0.0)
    }
}
