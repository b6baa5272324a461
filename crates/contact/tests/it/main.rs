//! Integration tests.
#![allow(clippy::unwrap_used, missing_docs)]

mod axis;
mod cattaneo_mindlin;
mod closed;
mod common;
mod edges;
mod embedded;
mod examples;
mod full_contact;
mod hertz;
mod hot;
mod matrices;
mod patch;
mod penalty;
mod refused;
mod released;
mod sphere;
mod statuses;
mod trap;
mod twist;
mod uniqueness;
