//! What goes to the terminal: results on stdout, talk and faults on stderr.

use std::io::{IsTerminal, Write};

use scene::Fault;

use crate::draw;
use crate::exit::Exit;

/// Prints a fault: the picture on stderr, with `--json` the document on stdout.
pub(crate) fn complain(fault: &Fault, json: bool) -> Exit {
    if json {
        print_json(&draw::json(fault));
    } else {
        eprint!("{}", draw::render(fault, std::io::stderr().is_terminal() && !no_colour()));
    }
    Exit::Wrong
}

/// Prints one JSON document on stdout.
pub(crate) fn print_json(document: &serde_json::Value) {
    if let Ok(text) = serde_json::to_string_pretty(document) {
        print_out(&(text + "\n"));
    }
}

/// Prints to stdout; a closed pipe is no error of ours.
pub(crate) fn print_out(text: &str) {
    let mut out = std::io::stdout().lock();
    let _ = out.write_all(text.as_bytes()).and_then(|()| out.flush());
}

/// Whether the user wants neither colour nor bars: <https://no-color.org>.
pub(crate) fn no_colour() -> bool {
    std::env::var_os("NO_COLOR").is_some_and(|value| !value.is_empty())
}
