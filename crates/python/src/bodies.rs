//! Factorised bodies that several runs share.

use std::sync::Arc;

use pyo3::prelude::*;

/// What was factorised, kept for problems with the same bodies.
#[pyclass(frozen, module = "wearshape._core")]
#[derive(Default)]
pub(crate) struct Bodies {
    pub(crate) shared: Arc<wearshape::Bodies>,
}

#[pymethods]
impl Bodies {
    #[new]
    fn new() -> Bodies {
        Bodies::default()
    }

    /// Bodies that were factorised.
    #[getter]
    fn factorisations(&self) -> usize {
        self.shared.factorisations()
    }

    /// Bodies that were asked for and already there.
    #[getter]
    fn reused(&self) -> usize {
        self.shared.reused()
    }
}
