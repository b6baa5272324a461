//! What is written.

use serde::{Deserialize, Serialize};

use crate::units::Length;

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
    /// Displacement and stress along lines through the bodies, a file path-NAME.csv each: tables with `name`, `body` (1 or 2), the two ends
    /// `from` and `to` as [x, z], the `centre` of an arc, and the number of `points` (101 unless given).
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub paths: Vec<FieldPath>,
}

/// A straight line or an arc through a body, along which displacement and stress are written.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct FieldPath {
    /// Goes into the name of the file: letters, digits and hyphens.
    pub name: String,
    /// Which body, 1 or 2.
    #[cfg_attr(feature = "schema", schemars(extend("minimum" = 1, "maximum" = 2)))]
    pub body: usize,
    /// Where it begins: [x, z] (mm), as the body is drawn.
    pub from: [Length; 2],
    /// Where it ends: [x, z] (mm).
    pub to: [Length; 2],
    /// Centre [x, z] (mm) of an arc that the path follows anti-clockwise from `from` to `to`, all around where they are one point. Default none: a
    /// straight line.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub centre: Option<[Length; 2]>,
    /// Number of points, both ends counted. Default 101.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "schema", schemars(extend("minimum" = 2, "maximum" = 100000)))]
    pub points: Option<usize>,
}
