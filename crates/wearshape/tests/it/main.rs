//! The library as another program uses it: by its public names alone.

mod bodies;
mod common;
mod effort;
mod examples;
mod files;
mod load;
mod plain;
mod refused;
mod watch;
