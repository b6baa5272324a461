//! Which pressure is wanted, in keys of the scene.

use serde::{Deserialize, Serialize};

use crate::units::Pressure;

/// Which pressure is wanted.
#[derive(Debug, Clone, PartialEq, Default, Deserialize, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct Optimum {
    /// Default "steady".
    #[serde(skip_serializing_if = "Option::is_none")]
    pub functional: Option<Functional>,
    /// Exponent of the generalised functionals. Default 1; any real number or inf.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub q: Option<f64>,
    /// Default "equilibrium".
    #[serde(skip_serializing_if = "Option::is_none")]
    pub balance: Option<Balance>,
    /// Default "kinematic".
    #[serde(skip_serializing_if = "Option::is_none")]
    pub modes: Option<Modes>,
    /// Cap of the pressure (MPa).
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "schema", schemars(extend("exclusiveMinimum" = 0)))]
    pub p_max: Option<Pressure>,
}

/// What is made stationary.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub enum Functional {
    /// The pressure of the steady state.
    #[default]
    Steady,
    /// Wear volume rate.
    WearVolume,
    /// Friction power.
    FrictionPower,
    /// Wear power.
    WearPower,
    /// Uniform pressure.
    Uniform,
}

/// Which balance the pressure fulfils.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub enum Balance {
    /// Force and moment balance with friction.
    #[default]
    Equilibrium,
    /// The paper's normalisation int p dS = F0.
    Paper,
}

/// Which modes weigh the pressure.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub enum Modes {
    /// Closing velocity of the rigid modes.
    #[default]
    Kinematic,
    /// The columns of the balance.
    Associated,
}
