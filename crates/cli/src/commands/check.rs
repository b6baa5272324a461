//! `wearshape check`: what a scene means, before anything is computed.

use std::path::PathBuf;

use scene::{Fault, Place};
use wearshape::Problem;

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
    problem.available().map_err(|fault| document.locate(fault))?;
    if args.json {
        print_json(&plan_json(&problem, &progress));
    } else if !args.quiet {
        progress.beside(|| print_out(&describe(&problem)));
        let sizes = sizes(&problem, &progress);
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
    std::fs::write(&path, report::drawing(problem)).map_err(|error| Fault {
        place: Some(Place::Flag(format!("-o {}", path.display()))),
        ..Fault::new("unwritable", format!("cannot write {}: {error}", path.display()), "give a file that can be written")
    })?;
    if !args.quiet {
        talk(&format!("drawing written to {}", path.display()));
    }
    Ok(())
}
