//! Frictional heat as the scene writes it: how it is shared between the bodies, and what carries it away.

use serde::{Deserialize, Serialize};

use crate::counterface::Counterface;
use crate::units::{Conductance, HeatFlux, HeatTransfer, Temperature};

/// Frictional heat: how the two bodies share it, and from which temperature they expand.
#[derive(Debug, Clone, PartialEq, Default, Deserialize, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct Heat {
    /// Share of the frictional heat that goes into body 1, from 0 to 1.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "schema", schemars(extend("minimum" = 0, "maximum" = 1)))]
    pub share: Option<f64>,
    /// Conductance of the contact (mW/(mm^2 K)), from which the share follows; "inf" for equal temperatures of both surfaces.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub conductance: Option<Conductance>,
    /// Temperature at which the bodies have their cold shape (degC). Default 20.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub reference: Option<Temperature>,
    /// How body 2 meets the heat of body 1. Default that of wear.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub counterface: Option<Counterface>,
}

/// What carries heat through an edge: { temperature }, { convection, ambient } or { flux }.
#[derive(Debug, Clone, Copy, PartialEq, Default, Deserialize, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct EdgeHeat {
    /// Temperature at which the edge is held (degC).
    #[serde(skip_serializing_if = "Option::is_none")]
    pub temperature: Option<Temperature>,
    /// Coefficient of heat transfer to the surroundings (mW/(mm^2 K)); on an edge with contact it acts outside of it.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "schema", schemars(extend("minimum" = 0)))]
    pub convection: Option<HeatTransfer>,
    /// Temperature of the surroundings (degC).
    #[serde(skip_serializing_if = "Option::is_none")]
    pub ambient: Option<Temperature>,
    /// Heat that flows into the body (mW/mm^2).
    #[serde(skip_serializing_if = "Option::is_none")]
    pub flux: Option<HeatFlux>,
}
