//! Integration tests.
#![allow(clippy::unwrap_used, missing_docs)]

mod bodies;
mod closed_form;
mod decay;
mod order;
mod schedule;
mod stability;
mod steady;
mod two_bodies;
