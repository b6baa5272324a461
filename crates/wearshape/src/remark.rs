//! A remark on a scene or on what it came to.

use serde::Serialize;

/// A remark: the scene is legal, and something about it is worth knowing.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Remark {
    /// Hyphenated word.
    pub code: &'static str,
    /// One or two sentences.
    pub message: String,
}
