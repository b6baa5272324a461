//! wearshape: see the library.

use std::process::ExitCode;

fn main() -> ExitCode {
    cli::tell_panics();
    cli::run(std::env::args_os()).into()
}
