//! How long what may wear off lasts.

use serde::Serialize;

/// How long until the thickness that may wear off body 1 is gone where it is thinnest: `summary.pressure.life` by the steady wear, `summary.wear.life` from
/// the start of a run in time, its running-in counted.
#[derive(Debug, Clone, Default, PartialEq, Serialize)]
pub struct LifeResult {
    /// Time of sliding (h).
    #[serde(rename = "time_h")]
    pub hours: f64,
    /// Mean sliding distance (km).
    #[serde(rename = "distance_km")]
    pub distance: f64,
    /// Turns of body 2, where it turns.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub revolutions: Option<f64>,
    /// Cycles of a motion to and fro.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub cycles: Option<f64>,
    /// Work of friction under steady wear (MJ); none of a run in time.
    #[serde(rename = "friction_work_MJ", skip_serializing_if = "Option::is_none")]
    pub friction_work: Option<f64>,
    /// Shortest and longest time (h), by the spread of the wear factor.
    #[serde(rename = "time_between_h", skip_serializing_if = "Option::is_none")]
    pub hours_between: Option<[f64; 2]>,
}
