//! `wearshape run`: from scene to folder.

use std::path::PathBuf;
use std::time::Instant;

use scene::{Fault, Place};

use crate::args::{Common, RunArgs};
use crate::commands::check::{describe, describe_with_sizes, plan_json};
use crate::commands::{print_json, print_out};
use crate::exit::Exit;
use crate::live::Live;
use crate::open::open;
use crate::progress::Progress;
use crate::record::Tape;
use crate::report::{self, Folder};
use crate::setup::setup;
use crate::solution::Status;
use crate::solve::{Options, Sampling, solve_live};

/// Computes a scene and writes its folder.
pub(crate) fn run(args: &RunArgs) -> Result<Exit, Fault> {
    let start = Instant::now();
    let common = &args.common;
    let (document, folder) = open(&args.scene, &common.set)?;
    let problem = setup(&document, &folder)?;
    let options = options(common)?;
    let target = common.output.clone().unwrap_or_else(|| PathBuf::from("out").join(&problem.name));
    if common.dry_run {
        if common.json {
            print_json(&plan_json(&problem));
        } else {
            print_out(&format!("{}\nwould write {}\n", describe_with_sizes(&problem), target.display()));
        }
        return Ok(Exit::Done);
    }
    if problem.plan.runs("mesh") {
        crate::fe::available(&problem).map_err(|fault| document.locate(fault))?;
    }
    crate::interrupt::listen();
    let resolved = report::resolved(&problem)?;
    let folder = Folder::begin(&target, common.resume)?;
    if common.resume {
        folder.same_scene(&resolved)?;
    }
    let ready = start.elapsed().as_secs_f64();
    folder.write("scene.resolved.toml", &resolved)?;
    for (name, bytes) in report::mesh_files(&problem.scene) {
        folder.write_bytes(&name, bytes)?;
    }
    if common.verbose && !common.quiet {
        eprint!("{}", describe(&problem));
    }
    let mut live = Live { tape: None, progress: Progress::new(common) };
    if problem.plan.runs("evolution") {
        let (tape, word) = Tape::new(folder.path(), &resolved, common.resume);
        if let Some(word) = word.filter(|_| !common.quiet) {
            eprintln!("{word}");
        }
        live.tape = Some(tape);
    } else if common.resume && !common.quiet {
        eprintln!("only runs in time can be continued; this one begins at its start");
    }
    let solved = with_threads(common, || solve_live(&problem, options, &mut live))?;
    live.progress.end();
    let mut solution = match solved {
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
        eprintln!("interrupted; {}", again(args, live.tape.is_some()));
        return Ok(Exit::Interrupted);
    }
    solution.times.insert(0, ("setup".into(), ready));
    let summary = report::write(&folder, &problem, &solution, &resolved, live.tape, start.elapsed().as_secs_f64())?;
    folder.finish()?;
    if common.json {
        print_json(&summary);
    } else if !common.quiet {
        print_out(&report::first_screen(&problem, &solution, &target));
    }
    Ok(exit_of(solution.status))
}

/// How an interrupted run goes on.
fn again(args: &RunArgs, in_time: bool) -> String {
    let quoted = |text: &str| if text.contains([' ', '"', '{', '[', '*', ';']) { format!("'{text}'") } else { text.to_string() };
    let mut call = format!("wearshape run {}", quoted(&args.scene));
    if let Some(folder) = &args.common.output {
        call += &format!(" -o {}", quoted(&folder.display().to_string()));
    }
    for set in &args.common.set {
        call += &format!(" --set {}", quoted(set));
    }
    let what = if in_time { "every finished step is kept; continue with" } else { "begin it again with" };
    let end = if in_time { " --resume" } else { "" };
    format!("{what}: {call}{end}")
}

/// The exit of a status.
pub(crate) fn exit_of(status: Status) -> Exit {
    match status {
        Status::Ok => Exit::Done,
        Status::AccuracyMissed | Status::NotConverged | Status::Refused => Exit::GoalMissed,
        Status::Interrupted => Exit::Interrupted,
    }
}

/// The options that reach the solver.
pub(crate) fn options(common: &Common) -> Result<Options<'_>, Fault> {
    if let Some(sample) = common.sample.filter(|sample| !(2..=10_000_000).contains(sample)) {
        return Err(Fault {
            place: Some(Place::Flag(format!("--sample {sample}"))),
            ..Fault::new("wrong-flag", format!("--sample {sample} is out of range"), "ask for 2 to 10000000 points")
        });
    }
    Ok(Options { sample: common.sample.map(Sampling::Even), alone: false, machining: true })
}

/// Does the work on the number of threads asked for.
pub(crate) fn with_threads<T: Send>(common: &Common, work: impl FnOnce() -> T + Send) -> Result<T, Fault> {
    let Some(threads) = common.threads else {
        return Ok(work());
    };
    let wrong = |message: String| Fault {
        place: Some(Place::Flag(format!("--threads {threads}"))),
        ..Fault::new("wrong-flag", message, "give a number of threads from 1 to 1024")
    };
    if !(1..=1024).contains(&threads) {
        return Err(wrong(format!("--threads {threads} is out of range")));
    }
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
    Ok(pool.map_err(|error| wrong(format!("cannot start {threads} threads: {error}")))?.install(work))
}
