//! A case beside its result.

use super::case::Case;
use super::check::Result;

/// A case and what it came to.
pub(crate) struct Row {
    pub(crate) case: Case,
    pub(crate) result: Result,
    pub(crate) seconds: f64,
}
