//! How long what may wear off lasts.

use serde::Serialize;

/// `summary.pressure.life`: until the thickness that may wear off body 1 is gone at its thinnest, by the steady wear.
#[derive(Debug, Clone, Default, PartialEq, Serialize)]
pub struct LifeResult {
    /// Time of sliding.
    #[serde(rename = "time_h")]
    pub hours: f64,
    /// Mean sliding distance.
    #[serde(rename = "distance_km")]
    pub distance: f64,
    /// Turns of body 2, where it turns.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub revolutions: Option<f64>,
    /// Cycles of a motion to and fro.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub cycles: Option<f64>,
    /// Work of friction.
    #[serde(rename = "friction_work_MJ")]
    pub friction_work: f64,
    /// Shortest and longest time, by the spread of the wear factor.
    #[serde(rename = "time_between_h", skip_serializing_if = "Option::is_none")]
    pub hours_between: Option<[f64; 2]>,
}

/// `summary.wear.life`: until the thickness that may wear off body 1 is gone at its thinnest, from the start of the run, its running-in counted.
#[derive(Debug, Clone, Default, PartialEq, Serialize)]
pub struct RunLifeResult {
    /// Time of sliding.
    #[serde(rename = "time_h")]
    pub hours: f64,
    /// Mean sliding distance.
    #[serde(rename = "distance_km")]
    pub distance: f64,
    /// Turns of body 2, where it turns.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub revolutions: Option<f64>,
    /// Cycles of a motion to and fro.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub cycles: Option<f64>,
    /// Shortest and longest time, by the spread of the wear factor.
    #[serde(rename = "time_between_h", skip_serializing_if = "Option::is_none")]
    pub hours_between: Option<[f64; 2]>,
}
