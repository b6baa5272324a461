//! What is written.

use serde::{Deserialize, Serialize};

/// Which of the larger files are written.
#[derive(Debug, Clone, PartialEq, Default, Deserialize, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct Output {
    /// Displacement and stress fields as VTU. Default false.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub fields: Option<bool>,
    /// The recording run.mcap. Default false; a wear run always keeps one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub recording: Option<bool>,
    /// The page report.html. Default true.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub report: Option<bool>,
}
