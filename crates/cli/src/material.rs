//! The material of a body or of some of its cells.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::units::Pressure;

/// Linear isotropic elasticity.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize, Serialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct Material {
    /// Young's modulus (MPa).
    pub(crate) young: Pressure,
    /// Poisson's ratio.
    pub(crate) poisson: f64,
}
