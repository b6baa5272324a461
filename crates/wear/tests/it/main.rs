//! Integration tests of the wear crate.
#![allow(clippy::unwrap_used, missing_docs)]

mod benchmarks;
mod reference;
mod surfaces;
