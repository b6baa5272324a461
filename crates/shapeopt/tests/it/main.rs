//! Integration tests.
#![allow(clippy::unwrap_used, missing_docs, unreachable_pub)]

mod approach;
mod bodies;
mod closed_form;
mod decay;
mod examples;
mod laid;
mod order;
mod own_rule;
mod partial;
mod place;
mod refused;
mod reversing;
mod run_in_times;
mod schedule;
mod stability;
mod steady;
mod supports;
mod turns;
mod two_bodies;
