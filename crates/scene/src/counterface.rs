//! How the counter-face meets body 1.

use serde::{Deserialize, Serialize};

/// How the counter-face meets body 1.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub enum Counterface {
    /// Always unworn: body 2 drops out of the gap rate.
    Fresh,
    /// Always the same points meet: the rates add.
    Congruent,
    /// Body 2 turns under body 1: its wear is averaged along the closed track, or along the stroke of a ball that goes to and fro.
    Revolving,
}
