//! `wearshape._core`: the crates `wearshape` and `report` as Python sees them. It computes nothing of its own and opens no file; what is
//! friendly about the package stands in `python/wearshape`.

mod array;
mod bodies;
mod document;
mod fault;
mod finite_elements;
mod optimum;
mod pool;
mod problem;
mod record;
mod solution;
mod solve;

use pyo3::prelude::*;

/// The module.
#[pymodule]
mod _core {
    #[pymodule_export]
    use crate::array::Array;
    #[pymodule_export]
    use crate::bodies::Bodies;
    #[pymodule_export]
    use crate::document::{Document, builtin, scenes};
    #[pymodule_export]
    use crate::finite_elements::{Interface, Mesh};
    #[pymodule_export]
    use crate::optimum::{Optimum, optimal_pressure};
    #[pymodule_export]
    use crate::problem::Problem;
    #[pymodule_export]
    use crate::solution::Solution;
}
