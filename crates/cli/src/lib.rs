//! The program `wearshape`: reads a scene, computes what it asks for, writes the report.
//!
//! The data goes one way: `Scene -> Problem -> Solution -> Report` by `setup`, `solve`, `report`. This is the only crate of the
//! workspace that reads files, writes files and prints.

mod again;
mod args;
mod clock;
mod commands;
mod describe;
mod draw;
mod exit;
mod folder;
mod grid;
mod interrupt;
mod live;
mod open;
mod options;
mod print;
mod progress;
mod record;
mod reproduce;
mod write;

pub use exit::Exit;

/// Runs the program with the given arguments, the first of which is the program's name; prints to stdout and stderr.
pub fn run(args: impl IntoIterator<Item = impl Into<std::ffi::OsString> + Clone>) -> Exit {
    commands::run(args)
}
