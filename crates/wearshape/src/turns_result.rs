//! What is said of reversals in time.

use serde::Serialize;

/// `summary.wear.turns`: reversals that repeat, resolved one by one or averaged.
#[derive(Debug, Clone, Default, PartialEq, Serialize)]
pub struct TurnsResult {
    /// Whether the run averages over the cycles.
    pub averaged: bool,
    /// Why, or why not.
    pub because: String,
    /// Number of cycles.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub cycles: Option<f64>,
    /// How many of them were resolved, where all others are like one of these.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub resolved: Option<f64>,
    /// How long a cycle lasts.
    #[serde(rename = "period_s", skip_serializing_if = "Option::is_none")]
    pub period: Option<f64>,
    /// How far the gap strays from its mean within a cycle, over the largest gap, without its rigid part.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub ripple: Option<f64>,
    /// Shares of the time of the loads that act by turns, of an averaged run.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub shares: Vec<f64>,
}
