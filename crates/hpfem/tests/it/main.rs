//! Tests of the crate, one binary.
#![allow(clippy::unwrap_used, missing_docs)]

mod common;
mod continuity;
mod convergence;
mod exact;
mod patch;
mod quadrature;
mod quadrature_table;
