//! What was computed.

use std::sync::Arc;

use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyDict};
use wear::Shape;

use crate::array::Array;
use crate::fault::raised;
use crate::pool::within;
use crate::record::Records;

/// A problem with its solution; both never change again.
pub(crate) struct Solved {
    pub(crate) problem: Arc<wearshape::Problem>,
    pub(crate) solution: wearshape::Solution,
}

/// Everything a run knows when it is done.
#[pyclass(frozen, module = "wearshape._core")]
pub(crate) struct Solution {
    pub(crate) solved: Arc<Solved>,
}

impl Solution {
    pub(crate) fn new(solved: Solved) -> Solution {
        Solution { solved: Arc::new(solved) }
    }

    /// A column of the profile as numpy sees it in Rust's memory.
    fn view(&self, column: fn(&wearshape::Profile) -> &[f64]) -> Option<Array> {
        self.solved.solution.profile.as_ref()?;
        Some(Array::line(&self.solved, |solved| solved.solution.profile.as_ref().map_or(&[], column)))
    }
}

#[pymethods]
impl Solution {
    /// How it ended, in one word.
    #[getter]
    fn status(&self) -> String {
        wearshape::word(&self.solved.solution.status)
    }

    /// Whether a run in time was stopped and can be gone on with.
    #[getter]
    fn resumable(&self) -> bool {
        self.solved.solution.resume.is_some()
    }

    /// summary.json.
    fn summary(&self) -> String {
        let Solved { problem, solution } = &*self.solved;
        report::summary(problem, solution).to_string()
    }

    /// Seconds of each stage.
    fn seconds(&self) -> Vec<(String, f64)> {
        self.solved.solution.effort.seconds.iter().map(|(step, seconds)| (step.name(), *seconds)).collect()
    }

    /// Arc length from the middle, or r (mm).
    #[getter]
    fn s(&self) -> Option<Array> {
        self.view(|profile| &profile.s)
    }

    /// Pressure of the last task (MPa).
    #[getter]
    fn pressure(&self) -> Option<Array> {
        self.view(|profile| &profile.pressure)
    }

    /// Unloaded gap (um).
    #[getter]
    fn gap(&self) -> Option<Array> {
        self.view(|profile| &profile.gap)
    }

    /// Area weight (mm^2).
    #[getter]
    fn weight(&self) -> Option<Array> {
        self.view(|profile| &profile.weight)
    }

    /// Wear rate of both bodies (um/s).
    #[getter]
    fn wear_rate(&self) -> Option<Array> {
        self.view(|profile| &profile.wear_rate)
    }

    /// Position (mm), points x 3.
    #[getter]
    fn position(&self) -> Option<Array> {
        self.solved.solution.profile.as_ref()?;
        Some(Array::rows(&self.solved, |solved| solved.solution.profile.as_ref().map_or(&[], |profile| &profile.position)))
    }

    /// The columns of contact.csv as records.
    fn profile(&self, py: Python<'_>) -> Option<Array> {
        let profile = self.solved.solution.profile.as_ref()?;
        Some(Array::records(py.detach(|| Records::of_profile(profile))))
    }

    /// The columns of history.csv as records.
    fn history(&self) -> Array {
        Array::records(Records::of_columns(&self.solved.solution.history))
    }

    /// Whether the surface has two dimensions, whose points are in no order along it.
    #[getter]
    fn is_map(&self) -> bool {
        matches!(
            self.solved.problem.contact_shape(),
            Some(Shape::Rectangle { .. } | Shape::Ellipse { .. } | Shape::Sector { .. })
        )
    }

    /// x, y (mm) and pressure (MPa) on a grid over a surface of two dimensions, row by row of a square.
    fn map(&self) -> Option<Array> {
        let map = self.solved.solution.map.as_ref()?;
        let points = map.position.iter().zip(&map.pressure).map(|([x, y], pressure)| [*x, *y, *pressure]);
        Some(Array::rows(&Arc::new(points.collect::<Vec<_>>()), |points| points))
    }

    /// Abscissa of pictures and its name with its unit.
    fn abscissa(&self) -> Option<(Vec<f64>, &'static str)> {
        let Solved { problem, solution } = &*self.solved;
        solution.profile.as_ref().map(|profile| report::abscissa(problem, profile))
    }

    /// The files of a folder by name.
    fn files<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let Solved { problem, solution } = &*self.solved;
        let files = py.detach(|| within(None, || Ok(report::files(problem, solution)))).map_err(|fault| raised(py, fault))?;
        let named = PyDict::new(py);
        for (name, bytes) in files {
            named.set_item(name, PyBytes::new(py, &bytes))?;
        }
        Ok(named)
    }
}
