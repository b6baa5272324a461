//! The keys `sliding.reversing` and `sliding.cycle`.

use serde::{Deserialize, Serialize};

use crate::units::{Frequency, Length};

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

/// A motion to and fro along a straight line, once each way in every cycle; its mean speed is twice the stroke times the frequency.
#[derive(Debug, Clone, PartialEq, Default, Deserialize, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct Cycle {
    /// Way from one end to the other (mm).
    #[serde(skip_serializing_if = "Option::is_none")]
    pub stroke: Option<Length>,
    /// Cycles a second, each there and back.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub frequency: Option<Frequency>,
}
