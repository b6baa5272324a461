//! The material of a body or of some of its cells.

use serde::{Deserialize, Serialize};

use crate::units::Pressure;

/// Linear isotropic elasticity.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct Material {
    /// Young's modulus (MPa).
    #[cfg_attr(feature = "schema", schemars(extend("exclusiveMinimum" = 0)))]
    pub young: Pressure,
    /// Poisson's ratio.
    #[cfg_attr(feature = "schema", schemars(extend("exclusiveMinimum" = -1, "exclusiveMaximum" = 0.5)))]
    pub poisson: f64,
}
