//! The library as another program uses it: by its public names alone.
#![allow(clippy::unwrap_used)]

mod bodies;
mod common;
mod effort;
mod estimates;
mod examples;
mod files;
mod guided;
mod load;
mod own_rule;
mod plain;
mod refused;
mod sensitivity;
mod watch;
