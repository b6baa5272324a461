//! `summary.reversing`: both senses of a motion that reverses.

use serde::Serialize;

use crate::brake::BrakeResult;

/// Both senses of a reversing motion on its steady shape; `summary.pressure` is that of their mean over the time.
#[derive(Debug, Clone, Default, PartialEq, Serialize)]
pub struct ReversingResult {
    /// Share of the time that slides forward.
    pub share: f64,
    /// Forward: as `sliding` says.
    pub forward: SenseResult,
    /// Backward.
    pub back: SenseResult,
    /// Places along the surface between which one sense alone touches, or none.
    #[serde(rename = "ends_mm", skip_serializing_if = "Vec::is_empty")]
    pub ends: Vec<f64>,
    /// Newton steps on the reported level.
    pub newton_steps: usize,
}

/// One sense of a reversing motion.
#[derive(Debug, Clone, Default, PartialEq, Serialize)]
pub struct SenseResult {
    /// Largest pressure at a contact point.
    #[serde(rename = "p_max_MPa")]
    pub p_max: f64,
    /// Where it is, along the surface.
    #[serde(rename = "p_max_where_mm")]
    pub p_max_where: f64,
    /// Smallest pressure at a contact point: 0 where part of the surface opens.
    #[serde(rename = "p_min_MPa")]
    pub p_min: f64,
    /// int p dS.
    #[serde(rename = "normal_force_N")]
    pub normal_force: f64,
    /// Friction power while it slides so.
    #[serde(rename = "friction_power_mW")]
    pub friction_power: f64,
    /// Part of the area that carries no pressure.
    pub open_share: f64,
    /// Body 1 as a brake while it slides so, where a pin or a roller guides it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub brake: Option<BrakeResult>,
}
