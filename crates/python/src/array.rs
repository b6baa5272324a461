//! Numbers of Rust that numpy looks at without copying them: an object with `__array_interface__`, which keeps alive what they are part of.

use std::any::Any;
use std::sync::Arc;

use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList, PyTuple};

use crate::record::{F64, Records};

/// A read-only view of numbers that belong to something else.
#[pyclass(frozen, module = "wearshape._core")]
pub(crate) struct Array {
    /// What the numbers are part of; it never changes.
    _owner: Arc<dyn Any + Send + Sync>,
    address: usize,
    shape: Vec<usize>,
    /// Bytes between neighbours along each axis; none where they stand close by rows.
    strides: Option<Vec<usize>>,
    /// Name and type of each field of a record; empty for plain numbers.
    fields: Vec<(String, String)>,
    /// Bytes of one item.
    size: usize,
}

impl Array {
    /// A part of `owner` as an array of one dimension.
    pub(crate) fn line<T: Any + Send + Sync>(owner: &Arc<T>, part: impl FnOnce(&T) -> &[f64]) -> Array {
        let numbers = part(owner);
        Array::new(owner, numbers, vec![numbers.len()])
    }

    /// A part of `owner`, groups of `N` numbers, as an array of two dimensions.
    pub(crate) fn rows<T: Any + Send + Sync, const N: usize>(owner: &Arc<T>, part: impl FnOnce(&T) -> &[[f64; N]]) -> Array {
        let rows = part(owner);
        Array::new(owner, rows.as_flattened(), vec![rows.len(), N])
    }

    /// A matrix that `owner` holds by columns.
    pub(crate) fn matrix<T: Any + Send + Sync>(owner: &Arc<T>, part: impl FnOnce(&T) -> hpfem::faer::MatRef<'_, f64>) -> Array {
        let matrix = part(owner);
        let bytes = |stride: isize| stride.unsigned_abs() * size_of::<f64>();
        Array {
            _owner: owner.clone(),
            address: matrix.as_ptr() as usize,
            shape: vec![matrix.nrows(), matrix.ncols()],
            strides: Some(vec![bytes(matrix.row_stride()), bytes(matrix.col_stride())]),
            fields: Vec::new(),
            size: size_of::<f64>(),
        }
    }

    /// A table of records.
    pub(crate) fn records(records: Records) -> Array {
        let Records { words, fields, size, count } = records;
        let words = Arc::new(words);
        let address = words.as_ptr() as usize;
        Array { _owner: words, address, shape: vec![count], strides: None, fields, size }
    }

    fn new<T: Any + Send + Sync>(owner: &Arc<T>, numbers: &[f64], shape: Vec<usize>) -> Array {
        let address = numbers.as_ptr() as usize;
        Array { _owner: owner.clone(), address, shape, strides: None, fields: Vec::new(), size: size_of::<f64>() }
    }
}

#[pymethods]
impl Array {
    /// What numpy asks for.
    #[getter]
    fn __array_interface__<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let interface = PyDict::new(py);
        interface.set_item("version", 3)?;
        interface.set_item("shape", PyTuple::new(py, &self.shape)?)?;
        // The second says that it is for reading alone.
        interface.set_item("data", (self.address, true))?;
        if let Some(strides) = &self.strides {
            interface.set_item("strides", PyTuple::new(py, strides)?)?;
        }
        if self.fields.is_empty() {
            interface.set_item("typestr", F64)?;
        } else {
            interface.set_item("typestr", format!("|V{}", self.size))?;
            interface.set_item("descr", PyList::new(py, &self.fields)?)?;
        }
        Ok(interface)
    }
}
