//! A scene that was checked.

use std::sync::Arc;

use pyo3::prelude::*;
use serde_json::json;
use wearshape::Options;

use crate::fault::raised;
use crate::pool::within;
use crate::solution::{Solution, Solved};
use crate::solve::{Run, seconds, solve};

/// Everything that is computed from, with every default filled in.
#[pyclass(frozen, module = "wearshape._core")]
pub(crate) struct Problem {
    pub(crate) posed: Arc<wearshape::Problem>,
    pub(crate) document: Arc<scene::Document>,
}

#[pymethods]
impl Problem {
    /// Title of the scene, or its name.
    #[getter]
    fn title(&self) -> &str {
        self.posed.title()
    }

    /// The scene with every default filled in, in base units, as TOML.
    fn resolved(&self) -> String {
        self.posed.resolved()
    }

    /// Stages, lints and unused keys, as JSON.
    fn findings(&self) -> String {
        let Problem { posed, .. } = self;
        json!({ "stages": posed.plan().stages, "lints": posed.remarks(), "unused_keys": posed.unused_keys() }).to_string()
    }

    /// Refuses what is not built, or cannot be meshed, held or loaded.
    fn available(&self, py: Python<'_>) -> PyResult<()> {
        py.detach(|| within(None, || self.posed.available())).map_err(|fault| raised(py, self.document.locate(fault)))
    }

    /// The levels of a run with sizes and seconds, about, as JSON.
    fn forecast(&self, py: Python<'_>) -> PyResult<String> {
        let options = Options { clock: seconds, ..Options::default() };
        let levels = py.detach(|| within(None, || self.posed.forecast(&options)));
        Ok(json!(levels.map_err(|fault| raised(py, self.document.locate(fault)))?).to_string())
    }

    /// The scene as a drawing (SVG).
    fn drawing(&self) -> String {
        report::drawing(&self.posed)
    }

    /// Solves it, watched by `run`.
    fn solve(&self, py: Python<'_>, run: Run) -> PyResult<Solution> {
        let solution = solve(py, &self.posed, run)?.map_err(|fault| raised(py, self.document.locate(fault)))?;
        Ok(Solution::new(Solved { problem: Arc::clone(&self.posed), solution }))
    }
}
