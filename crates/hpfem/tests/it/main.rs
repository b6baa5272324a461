//! Tests of the crate, one binary.
#![allow(clippy::unwrap_used, missing_docs)]

mod additions;
mod classics;
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
mod large;
mod loads;
mod lshape;
mod patch;
mod quadrature;
mod quadrature_table;
mod remesh;
mod sharing;
mod singular;
mod sliding_edge;
mod supports;
mod triangles;
