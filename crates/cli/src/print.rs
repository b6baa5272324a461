//! What goes to the terminal: results on stdout, talk and faults on stderr. Everything that the program prints goes through here.
//!
//! A stream that nobody reads any more (a closed pipe) is no error. Any other failure, such as a full disk, is kept until the call ends, and then is an
//! error of its own: what was asked for has not arrived.

use std::io::{self, ErrorKind, IsTerminal, Write};
use std::sync::OnceLock;

use scene::{Fault, Place, visible};

use crate::draw;
use crate::exit::Exit;

/// The first thing that could not be printed: the stream and why.
static LOST: OnceLock<(&str, String)> = OnceLock::new();

/// Prints a fault: the picture on stderr, with `--json` the document on stdout.
pub(crate) fn complain(fault: &Fault, json: bool) -> Exit {
    if json {
        print_json(&draw::json(fault));
    } else {
        print_err(&draw::render(fault, colour_on_stderr()));
    }
    Exit::Wrong
}

/// Prints one JSON document on stdout.
pub(crate) fn print_json(document: &serde_json::Value) {
    if let Ok(text) = serde_json::to_string_pretty(document) {
        print_out(&(report::inert(text) + "\n"));
    }
}

/// Prints to stdout what texts of others say, but does nothing that they ask a terminal for.
pub(crate) fn print_out(text: &str) {
    put("stdout", &mut io::stdout().lock(), &visible(text));
}

/// Prints a line of talk to stderr.
pub(crate) fn talk(line: &str) {
    print_err(&format!("{}\n", visible(line)));
}

/// Prints to stderr.
pub(crate) fn print_err(text: &str) {
    put("stderr", &mut io::stderr().lock(), text);
}

/// Writes a text to a stream, all of it or with a word on why not.
fn put(name: &'static str, stream: &mut dyn Write, text: &str) {
    if let Err(error) = stream.write_all(text.as_bytes()).and_then(|()| stream.flush())
        && error.kind() != ErrorKind::BrokenPipe
    {
        LOST.get_or_init(|| (name, error.to_string()));
    }
}

/// How a call ends whose output may have been lost: wrong if it was, and said where there is still a stream for it. An interrupted call stays one.
pub(crate) fn ended(exit: Exit) -> Exit {
    let Some((stream, why)) = LOST.get() else { return exit };
    let message = format!("cannot write to {stream}: {why}");
    let remedy = "what was to be printed is lost; send it where there is room";
    let fault = Fault { place: Some(Place::Flag((*stream).into())), ..Fault::new("unwritable", message, remedy) };
    complain(&fault, false);
    if exit == Exit::Interrupted { exit } else { Exit::Wrong }
}

/// Whether what is said on stderr has colours.
pub(crate) fn colour_on_stderr() -> bool {
    io::stderr().is_terminal() && !no_colour()
}

/// Whether the user wants neither colour nor bars: <https://no-color.org>.
pub(crate) fn no_colour() -> bool {
    std::env::var_os("NO_COLOR").is_some_and(|value| !value.is_empty())
}
