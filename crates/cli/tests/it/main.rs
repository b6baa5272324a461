//! Process tests of the program `wearshape`: exit codes, what is said, what is written.
#![allow(clippy::unwrap_used, missing_docs)]

mod approach;
mod broken;
mod broken_cells;
mod call;
mod cells;
mod commands;
mod counterfaces;
mod expected;
mod fields;
mod folder;
mod free_ends;
mod hertz;
mod internal_shoe;
mod json;
mod machined;
mod pressure;
mod reproduce;
mod resolved;
mod resume;
mod schedule;
mod set;
mod study;
mod sweep;
mod templates;
mod twist;
