//! Wear rules by a function of the pressure.

use serde::{Deserialize, Serialize};

use crate::units::{Pressure, WearFactor};

/// Wear of body 1 as a function of the pressure with a few numbers, w' = W(p) v.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub enum WearFunction {
    /// Mild up to a pressure and severe above it: W = mild p, and mild above + severe (p - above).
    Severe {
        /// Wear factor k of mild wear (mm^2/N).
        #[cfg_attr(feature = "schema", schemars(extend("exclusiveMinimum" = 0)))]
        mild: WearFactor,
        /// Pressure at which wear turns severe (MPa).
        #[cfg_attr(feature = "schema", schemars(extend("exclusiveMinimum" = 0)))]
        above: Pressure,
        /// Wear factor of the pressure beyond it (mm^2/N).
        #[cfg_attr(feature = "schema", schemars(extend("exclusiveMinimum" = 0)))]
        severe: WearFactor,
    },
    /// A factor that falls with the pressure: W = k p / (1 + p / half).
    Saturating {
        /// Wear factor k of small pressures (mm^2/N).
        #[cfg_attr(feature = "schema", schemars(extend("exclusiveMinimum" = 0)))]
        k: WearFactor,
        /// Pressure at which the factor is half of that (MPa).
        #[cfg_attr(feature = "schema", schemars(extend("exclusiveMinimum" = 0)))]
        half: Pressure,
    },
}
