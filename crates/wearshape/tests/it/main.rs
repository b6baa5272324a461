//! The library as another program uses it: by its public names alone.
#![allow(clippy::unwrap_used)]

mod bodies;
mod bush_wear;
mod campaign;
mod coarse_cells;
mod common;
mod cut_alike;
mod depth;
mod effort;
mod estimates;
mod examples;
mod files;
mod forecast;
mod gravity;
mod guided;
mod heat;
mod heat_wear;
mod hot_energy;
mod hot_lasting;
mod hot_shape;
mod jumps;
mod load;
mod orthotropic;
mod own_rule;
mod paths;
mod pinned;
mod plain;
mod refused;
mod round_wear;
mod sensitivity;
mod short_wear;
mod spin;
mod threshold;
mod watch;
mod wear_law;
mod wear_table;
