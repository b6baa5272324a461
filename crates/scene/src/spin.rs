//! A body that spins.

use serde::{Deserialize, Serialize};

use crate::units::{AngularSpeed, Length};

/// A body that spins in balance: its centrifugal force strains it. Its materials need a density.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct Spin {
    /// Angular speed (rad/s), of either sense.
    pub omega: AngularSpeed,
    /// The point [x, z] that a plane body spins about: its centre of mass. Default that of a ring, else [0, 0]; axisymmetric bodies spin about their axis.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub centre: Option<[Length; 2]>,
}
