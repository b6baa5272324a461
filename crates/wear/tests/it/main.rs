//! Integration tests of the wear crate.
#![allow(clippy::unwrap_used, missing_docs)]

mod benchmarks;
mod bounded;
mod caps;
mod engineering;
mod extreme;
mod multipliers;
mod near_the_border;
mod own_functional;
mod own_rule;
mod properties;
mod random;
mod reference;
mod reference_bodies;
mod refused;
mod sensitivity;
mod shell;
mod surfaces;
mod threshold;
