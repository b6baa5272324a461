//! Tests of the crate, one binary.
#![allow(clippy::unwrap_used, missing_docs)]

mod breaks;
mod common;
mod faults;
mod outlines;
mod shapes;
