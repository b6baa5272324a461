//! `wearshape check`: what a scene means, before more than its pressure is computed.

use std::io::Read;
use std::path::{Path, PathBuf};

use scene::{Fault, Place};
use wearshape::{Bodies, Problem};

use crate::args::{CheckArgs, Common};
use crate::describe::{describe, plan_json, sizes};
use crate::exit::Exit;
use crate::open;
use crate::print::{print_json, print_out, talk};
use crate::progress::Progress;

/// Prints the plan, the remarks and the unused keys of a scene.
pub(crate) fn run(args: &CheckArgs) -> Result<Exit, Fault> {
    let common = Common { json: args.json, quiet: args.quiet, no_progress: args.no_progress, ..Common::default() };
    let progress = Progress::new(&common);
    progress.say("reading the scene");
    let (document, problem) = open::problem(&args.scene, &args.set)?;
    // Whether the scene is sound is decided before a word goes to stdout; what the levels take is measured after it.
    progress.say("meshing");
    let bodies = Bodies::default();
    problem.available_on(&bodies).map_err(|fault| document.locate(fault))?;
    if args.json {
        print_json(&plan_json(&problem, &bodies, &progress));
    } else if !args.quiet {
        progress.beside(|| print_out(&describe(&problem)));
        let sizes = sizes(&problem, &bodies, &progress);
        progress.end();
        print_out(&format!("{sizes}\n"));
    }
    draw(args, &problem)?;
    Ok(Exit::Done)
}

/// Writes the drawing where it is asked for.
fn draw(args: &CheckArgs, problem: &Problem) -> Result<(), Fault> {
    let own = args.verbose.then(|| PathBuf::from(format!("{}.svg", problem.name())));
    let Some(path) = args.drawing.clone().or(own) else { return Ok(()) };
    let at = |fault| Fault { place: Some(Place::Flag(format!("-o {}", path.display()))), ..fault };
    if holds_something_else(&path) {
        let message = format!("{} exists already, is no drawing, and is left as it is", path.display());
        return Err(at(Fault::new("file-exists", message, "give another name, or remove the file first")));
    }
    std::fs::write(&path, report::drawing(problem)).map_err(|error| {
        at(Fault::new("unwritable", format!("cannot write {}: {error}", path.display()), "give a file that can be written"))
    })?;
    if !args.quiet {
        talk(&format!("drawing written to {}", path.display()));
    }
    Ok(())
}

/// Bytes by which a drawing is known.
const START: u64 = 256;

/// Whether a file is there that is no drawing: a drawing of before may be drawn anew.
fn holds_something_else(path: &Path) -> bool {
    if !path.is_file() {
        return false;
    }
    let mut start = Vec::new();
    let read = std::fs::File::open(path).and_then(|file| file.take(START).read_to_end(&mut start));
    read.is_ok() && !start.is_empty() && !start.windows(4).any(|bytes| bytes == b"<svg")
}
