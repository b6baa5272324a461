//! `wearshape run`: from scene to folder.

use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::Instant;

use scene::Fault;
use wearshape::{Bodies, Options, Problem, Solution, Status, Step};

use crate::again::again;
use crate::args::{Common, Points, RunArgs};
use crate::describe::{describe, plan_json, sizes};
use crate::exit::Exit;
use crate::folder::Folder;
use crate::live::Live;
use crate::options::{options, threads};
use crate::print::{print_json, print_out, talk};
use crate::progress::Progress;
use crate::record::{RUN_MCAP, Tape};
use crate::write::write;
use crate::{interrupt, open};

/// Computes a scene and writes its folder.
pub(crate) fn run(args: &RunArgs) -> Result<Exit, Fault> {
    let start = Instant::now();
    let (common, points) = (&args.common, &args.points);
    let progress = Arc::new(Progress::new(common));
    progress.say("reading the scene");
    let (document, problem) = open::problem(&args.scene, &common.set)?;
    let options = options(points)?;
    let target = common.output.clone().unwrap_or_else(|| PathBuf::from("out").join(problem.name()));
    progress.say("meshing");
    let bodies = Bodies::default();
    problem.available_on(&bodies).map_err(|fault| document.locate(fault))?;
    if common.dry_run {
        dry_run(common, (&problem, &bodies), &target, &progress);
        return Ok(Exit::Done);
    }
    let threads = threads(common.threads)?;
    interrupt::listen();
    let resolved = problem.resolved();
    let wanted = target;
    let folder = Folder::begin(&wanted, &resolved, points.resume)?;
    let ready = start.elapsed().as_secs_f64();
    folder.write_files_of_scene(problem.files())?;
    if common.verbose && !common.quiet {
        progress.beside(|| talk(describe(&problem).trim_end()));
    }
    progress.run(&problem);
    let tape = progress.beside(|| tape(&folder, &problem, &resolved, (common, points)))?;
    let mut live = Live::new(tape, progress);
    let resume = live.tape.as_ref().and_then(Tape::resume);
    let options = Options { resume: resume.as_ref(), ..options };
    let solved = threads.install(|| live.solve(&problem, &options, &bodies));
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
        let kept = live.tape.as_ref().filter(|tape| tape.holds_steps()).map(|_| "every finished step");
        live.progress.end();
        talk(&format!("interrupted; {}", again(&["run", &args.scene], (common, points), kept)));
        return Ok(Exit::Interrupted);
    }
    Finished { common, problem: &problem, wanted: &wanted, begun: [ready, start.elapsed().as_secs_f64()] }
        .keep(folder, &solution, live)
}

/// A run that has come to its end.
struct Finished<'a> {
    common: &'a Common,
    problem: &'a Problem,
    wanted: &'a Path,
    /// Seconds until the solve, and to its end.
    begun: [f64; 2],
}

impl Finished<'_> {
    /// Writes the folder and says what came of it.
    fn keep(&self, folder: Folder, solution: &Solution, live: Live) -> Result<Exit, Fault> {
        let Finished { common, problem, wanted, begun } = *self;
        live.progress.part(Step::Page);
        let summary = write(&folder, problem, solution, live.tape, begun)?;
        let unanswered = matches!(solution.status, Status::Refused | Status::NotConverged);
        let (summary, beside) = if unanswered { folder.finish_beside_good(&summary)? } else { (folder.finish(&summary)?, None) };
        live.progress.end();
        if beside.is_some() && !common.quiet {
            talk(&format!("{} keeps the run of before", wanted.display()));
        }
        let target = beside.as_deref().unwrap_or(wanted);
        if common.json {
            print_json(&summary);
        } else if !common.quiet {
            print_out(&report::first_screen(problem, solution, target, common.verbose));
        }
        Ok(Exit::of(solution.status))
    }
}

/// Says what would be done.
fn dry_run(common: &Common, (problem, bodies): (&Problem, &Bodies), target: &Path, progress: &Progress) {
    if common.json {
        print_json(&plan_json(problem, bodies, progress));
        return;
    }
    progress.beside(|| print_out(&describe(problem)));
    let sizes = sizes(problem, bodies, progress);
    progress.end();
    print_out(&format!("{sizes}\nwould write {}\n", target.display()));
}

/// The recording of a run in time; a sentence says from where it goes on.
fn tape(folder: &Folder, problem: &Problem, resolved: &str, (common, points): (&Common, &Points)) -> Result<Option<Tape>, Fault> {
    if !problem.plan().runs(Step::Evolution) {
        if points.resume && !common.quiet {
            talk("only runs in time can be continued; this one begins at its start");
        }
        return Ok(None);
    }
    let (tape, word) = Tape::new(&folder.own(RUN_MCAP)?, resolved, points.resume)?;
    if let Some(word) = word.filter(|_| !common.quiet) {
        talk(&word);
    }
    Ok(Some(tape))
}
