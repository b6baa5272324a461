//! `wearshape man`: the manual pages.

use std::path::Path;

use clap::CommandFactory;
use clap_mangen::Man;
use scene::{Fault, Place};

use crate::args::Cli;
use crate::exit::Exit;
use crate::print::print_out;

/// How a call ends.
const EXIT_STATUS: [(&str, &str); 5] = [
    ("0", "Done."),
    ("1", "Computed, but the goal is not met: accuracy missed, not converged, no answer, or a sweep with such rows."),
    (
        "2",
        "Wrong command or scene, or a file or stream that cannot be read or written: the message names the place and what to write instead. A pipe that \
         nobody reads any more is no error.",
    ),
    ("101", "A fault of wearshape itself: two lines on stderr say what to report, and where."),
    ("130", "Interrupted by Ctrl-C, SIGTERM or SIGHUP: what is finished is kept where --resume can go on with it."),
];

/// What commands that compute read and write.
const FILES: [(&str, &str); 9] = [
    ("SCENE.toml", "A scene; files that it names are looked for beside it."),
    ("out/SCENE/", "The folder of a run, or the one after -o: written as out/SCENE.partial, and renamed when it is complete."),
    ("out/SCENE.failed/", "A run without an answer, where out/SCENE holds one that has an answer."),
    ("summary.json", "Status, verdict and every number."),
    ("contact.csv", "One row a contact point: pressure, gap, wear rate, displacements."),
    ("history.csv, run.mcap", "A run in time; run.mcap is what --resume goes on from."),
    ("report.html", "The page, without a network."),
    ("scene.resolved.toml", "The scene with every default filled in."),
    ("timing.json", "Seconds of every stage."),
];

/// Prints the page of the program, or writes those of all commands into a folder.
pub(crate) fn run(folder: Option<&Path>) -> Result<Exit, Fault> {
    let unwritable = |error: std::io::Error| {
        let shown = folder.unwrap_or(Path::new("-")).display().to_string();
        Fault {
            place: Some(Place::Flag(shown.clone())),
            ..Fault::new(
                "unwritable",
                format!("cannot write manual pages to {shown}: {error}"),
                "give a folder that can be written",
            )
        }
    };
    let mut command = Cli::command().disable_help_subcommand(true);
    command.build();
    let Some(folder) = folder else {
        let (_, page) = page(command).map_err(unwritable)?;
        print_out(&String::from_utf8_lossy(&page));
        return Ok(Exit::Done);
    };
    std::fs::create_dir_all(folder).map_err(unwritable)?;
    let each = command.get_subcommands().cloned().collect::<Vec<_>>();
    for command in each.into_iter().chain([command]) {
        let (name, page) = page(command).map_err(unwritable)?;
        std::fs::write(folder.join(name), page).map_err(unwritable)?;
    }
    Ok(Exit::Done)
}

/// The name and the text of a page.
fn page(command: clap::Command) -> std::io::Result<(String, Vec<u8>)> {
    let computes = matches!(command.get_name(), "wearshape" | "run" | "sweep" | "study");
    let man = Man::new(command);
    let mut text = Vec::new();
    man.render(&mut text)?;
    text.extend(section("EXIT STATUS", &EXIT_STATUS).bytes());
    if computes {
        text.extend(section("FILES", &FILES).bytes());
    }
    Ok((man.get_filename(), text))
}

/// A section of terms, each with a sentence.
fn section(title: &str, terms: &[(&str, &str)]) -> String {
    let plain = |text: &str| text.replace('-', "\\-");
    let mut out = format!(".SH \"{title}\"\n");
    for (term, sentence) in terms {
        out += &format!(".TP\n\\fB{}\\fR\n{}\n", plain(term), plain(sentence));
    }
    out
}
