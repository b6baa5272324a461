//! The key `sliding.reversing`.

use serde::{Deserialize, Serialize};

/// A motion that slides forward, as `sliding` says, part of the time, and backward as fast the rest of it.
#[derive(Debug, Clone, PartialEq, Default, Deserialize, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct Reversing {
    /// Share of the sliding time that goes forward, from 0 to 1. Default 0.5.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "schema", schemars(extend("minimum" = 0, "maximum" = 1)))]
    pub share: Option<f64>,
}
