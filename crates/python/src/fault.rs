//! A fault as an exception: `wearshape.Error`, which Python defines.

use pyo3::prelude::*;
use pyo3::types::PyTuple;
use scene::{Fault, Place};

/// The exception of a fault: message, code, key, remedy, place.
pub(crate) fn raised(py: Python<'_>, fault: Fault) -> PyErr {
    let Fault { code, message, key, place, remedy } = fault;
    let place = match place {
        None => Ok(None),
        Some(Place::Flag(flag)) => {
            let setting = flag.strip_prefix("--set ").unwrap_or(&flag);
            ("set()", None::<usize>, None::<usize>, setting).into_pyobject(py).map(Some)
        }
        Some(Place::File(spot)) => {
            (spot.file.as_str(), Some(spot.line), Some(spot.column), spot.text.as_str()).into_pyobject(py).map(Some)
        }
    };
    let made = || -> PyResult<Bound<'_, PyAny>> {
        let place: Option<Bound<'_, PyTuple>> = place?;
        py.import("wearshape._error")?.getattr("Error")?.call1((message, code, key, remedy, place))
    };
    match made() {
        Ok(exception) => PyErr::from_value(exception),
        Err(error) => error,
    }
}

/// The exception of what a building block refuses.
pub(crate) fn refused(py: Python<'_>, code: &'static str, error: impl std::fmt::Display, remedy: &str) -> PyErr {
    raised(py, Fault::new(code, error.to_string(), remedy))
}
