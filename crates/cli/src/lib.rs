//! The program `wearshape`: reads a scene, computes what it asks for, writes the report.
//!
//! The data goes one way: `Scene -> Problem -> Solution -> Report` by `setup`, `solve`, `report`. This is the only crate of the
//! workspace that reads files, writes files and prints.

mod args;
mod body_field;
mod cell_grid;
mod clock;
mod commands;
mod couple;
mod draw;
mod effort;
mod exit;
mod fe;
mod freedom;
mod given;
mod interrupt;
mod ladder;
mod lints;
mod live;
mod machined;
mod open;
mod options;
mod plan;
mod problem;
mod profile;
mod profile_file;
mod progress;
mod record;
mod report;
mod reproduce;
mod setup;
mod solution;
mod solve;
mod spline;
mod study;
mod surface;
mod watch;

pub use exit::Exit;

/// Runs the program with the given arguments, the first of which is the program's name; prints to stdout and stderr.
pub fn run(args: impl IntoIterator<Item = impl Into<std::ffi::OsString> + Clone>) -> Exit {
    commands::run(args)
}
