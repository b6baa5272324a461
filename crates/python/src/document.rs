//! A scene as it is written.

use std::sync::Arc;

use pyo3::prelude::*;
use pyo3::types::PyBytes;

use crate::fault::raised;
use crate::problem::Problem;

/// A scene with its text, its changes, and where each key stands.
#[pyclass(frozen, module = "wearshape._core")]
pub(crate) struct Document {
    read: scene::Document,
}

#[pymethods]
impl Document {
    /// Reads the text of a scene; `file` is its name in messages, `settings` are changes as `key=value`.
    #[new]
    fn new(py: Python<'_>, file: &str, text: &str, settings: Vec<String>) -> PyResult<Document> {
        let read = scene::Document::read(file, text, &settings).map_err(|fault| raised(py, fault))?;
        Ok(Document { read })
    }

    /// Short name of the scene.
    #[getter]
    fn name(&self) -> &str {
        &self.read.name
    }

    /// The problem that the scene poses; `beside` gives the bytes of a file that it names.
    fn pose(&self, py: Python<'_>, beside: &Bound<'_, PyAny>) -> PyResult<Problem> {
        let files = |path: &str| -> Result<Vec<u8>, String> {
            let bytes = beside.call1((path,)).map_err(|error| error.value(py).to_string())?;
            bytes.cast::<PyBytes>().map(|bytes| bytes.as_bytes().to_vec()).map_err(|error| error.to_string())
        };
        let posed = wearshape::Problem::new(&self.read, &files).map_err(|fault| raised(py, self.read.locate(fault)))?;
        Ok(Problem { posed: Arc::new(posed), document: Arc::new(self.read.clone()) })
    }
}

/// Names and titles of the built-in scenes.
#[pyfunction]
pub(crate) fn scenes() -> Vec<&'static str> {
    scene::SCENES.iter().map(|scene| scene.name).collect()
}

/// File name and text of a built-in scene.
#[pyfunction]
pub(crate) fn builtin(name: &str) -> Option<(String, &'static str)> {
    scene::builtin(name).map(|scene| (scene.file(), scene.text))
}
