//! The program `wearshape`: arguments, folders, the terminal, Ctrl-C, progress, the recording, and the figures of the paper.
//!
//! What is computed and what it looks like are not here. The data goes one way:
//!
//! ```text
//!  file --open--> Document --Problem::new--> Problem --solve--> Solution --report::files--> names and bytes --write--> folder
//!       scene               wearshape                wearshape            report
//! ```
//!
//! This is the only crate of the workspace that reads files, writes files, prints, has a clock, builds pools of threads and listens for signals. All of
//! that is around [`wearshape::solve`]: `live` watches a solve, and so records it, shows its progress, and ends it after Ctrl-C. A command is one
//! function from its arguments to an [`Exit`]; what several commands use stands in modules below them. `reproduce` computes through the same
//! public functions as any other program could.

// A macro of these panics where the stream is full or closed: `print` has what does not.
#![deny(clippy::print_stdout, clippy::print_stderr)]

mod again;
mod args;
mod bounded;
mod clock;
mod commands;
mod describe;
mod diff;
mod draw;
mod exit;
mod folder;
mod grid;
mod interrupt;
mod live;
mod memory;
mod open;
mod options;
mod panics;
mod print;
mod progress;
mod record;
mod reproduce;
mod sweep;
mod write;

pub use exit::Exit;
pub use panics::tell_panics;

/// Runs the program with the given arguments, the first of which is the program's name; prints to stdout and stderr.
pub fn run(args: impl IntoIterator<Item = impl Into<std::ffi::OsString> + Clone>) -> Exit {
    memory::keep_what_is_freed();
    commands::run(args)
}
