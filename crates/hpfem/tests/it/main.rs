//! Tests of the crate, one binary.
#![allow(clippy::unwrap_used, missing_docs)]

mod additions;
mod classics;
mod closed;
mod common;
mod continuity;
mod convergence;
mod curves;
mod cut;
mod estimate;
mod exact;
mod examples;
mod extremes;
mod gmsh;
mod input;
mod join;
mod large;
mod loads;
mod lshape;
mod modes;
mod orthotropic;
mod outline;
mod parts;
mod patch;
mod quadrature;
mod quadrature_table;
mod refused;
mod remesh;
mod search;
mod sharing;
mod singular;
mod sliding_edge;
mod supports;
mod triangles;
#[cfg(feature = "vtu")]
mod vtu;
