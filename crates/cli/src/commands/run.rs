//! `wearshape run`: from scene to folder.

use std::path::PathBuf;
use std::time::Instant;

use scene::Fault;
use wearshape::{Bodies, Options, Problem, Status, Step};

use crate::again::again;
use crate::args::{Common, RunArgs};
use crate::describe::{describe, describe_with_sizes, plan_json};
use crate::exit::Exit;
use crate::folder::Folder;
use crate::live::Live;
use crate::options::{options, with_threads};
use crate::print::{print_json, print_out};
use crate::progress::Progress;
use crate::record::Tape;
use crate::write::write;
use crate::{interrupt, open};

/// Computes a scene and writes its folder.
pub(crate) fn run(args: &RunArgs) -> Result<Exit, Fault> {
    let start = Instant::now();
    let common = &args.common;
    let (document, problem) = open::problem(&args.scene, &common.set)?;
    let options = options(common)?;
    let target = common.output.clone().unwrap_or_else(|| PathBuf::from("out").join(problem.name()));
    if common.dry_run {
        if common.json {
            print_json(&plan_json(&problem));
        } else {
            print_out(&format!("{}\nwould write {}\n", describe_with_sizes(&problem), target.display()));
        }
        return Ok(Exit::Done);
    }
    problem.available().map_err(|fault| document.locate(fault))?;
    interrupt::listen();
    let resolved = problem.resolved();
    let folder = Folder::begin(&target, common.resume)?;
    if common.resume {
        folder.same_scene(&resolved)?;
    }
    let ready = start.elapsed().as_secs_f64();
    folder.write("scene.resolved.toml", &resolved)?;
    for (name, bytes) in problem.files() {
        folder.write_bytes(&name, &bytes)?;
    }
    if common.verbose && !common.quiet {
        eprint!("{}", describe(&problem));
    }
    let mut live = Live::new(tape(&folder, &problem, &resolved, common), Progress::new(common));
    let resume = live.tape.as_ref().and_then(Tape::resume);
    let options = Options { resume: resume.as_ref(), ..options };
    let solved = with_threads(common, || live.solve(&problem, &options, &Bodies::default()))?;
    live.progress.end();
    let solution = match solved {
        Ok(solution) => solution,
        Err(fault) => {
            // What was recorded before the disk was full is worth going on from.
            if fault.code != "unwritable" {
                folder.discard();
            }
            return Err(document.locate(fault));
        }
    };
    if solution.status == Status::Interrupted {
        let kept = live.tape.as_ref().map(|_| "every finished step");
        eprintln!("interrupted; {}", again(&["run", &args.scene], common, kept));
        return Ok(Exit::Interrupted);
    }
    let seconds = [ready, start.elapsed().as_secs_f64()];
    let summary = write(&folder, &problem, &solution, live.tape, seconds)?;
    folder.finish()?;
    if common.json {
        print_json(&summary);
    } else if !common.quiet {
        print_out(&report::first_screen(&problem, &solution, &target));
    }
    Ok(Exit::of(solution.status))
}

/// The recording of a run in time; a sentence says from where it goes on.
fn tape(folder: &Folder, problem: &Problem, resolved: &str, common: &Common) -> Option<Tape> {
    if !problem.plan().runs(Step::Evolution) {
        if common.resume && !common.quiet {
            eprintln!("only runs in time can be continued; this one begins at its start");
        }
        return None;
    }
    let (tape, word) = Tape::new(folder.path(), resolved, common.resume);
    if let Some(word) = word.filter(|_| !common.quiet) {
        eprintln!("{word}");
    }
    Some(tape)
}
