//! The folder of a finished run: the files of the report, the seconds, the recording.

use report::pretty;
use scene::Fault;
use serde_json::{Value, json};
use wearshape::{Problem, Solution, Step};

use crate::folder::Folder;
use crate::record::{LAYOUT, Points, RUN_MCAP, Recorder, Tape};

/// Writes all files of a finished run into its partial folder; `seconds` until the solve and in all. Returns the summary.
pub(crate) fn write(
    folder: &Folder,
    problem: &Problem,
    solution: &Solution,
    tape: Option<Tape>,
    [ready, all]: [f64; 2],
) -> Result<Value, Fault> {
    let summary = report::summary(problem, solution);
    for (name, bytes) in report::files(problem, solution).into_iter().filter(|(name, _)| name != "summary.json") {
        folder.write_bytes(&name, &bytes)?;
    }
    folder.write("timing.json", &timing(solution, ready, all))?;
    if problem.plan().runs(Step::Recording) {
        folder.write(LAYOUT[0], LAYOUT[1])?;
    }
    let verdict = summary["verdict"].as_str().unwrap_or("");
    // A run in time has been recorded as it went; anything else is one picture. What is attached names the recording among the files.
    if let Some(tape) = tape {
        tape.finish(verdict, &pretty(&folder.listed(&summary)))?;
    } else if let Some(profile) = solution.profile.as_ref().filter(|_| problem.plan().runs(Step::Recording)) {
        let mut recorder = Recorder::create(&folder.own(RUN_MCAP)?, &problem.resolved(), None)?;
        recorder.log(verdict)?;
        recorder.picture(&Points::new(0, 0.0, profile))?;
        recorder.finish(&pretty(&folder.listed(&summary)))?;
    }
    Ok(summary)
}

fn timing(solution: &Solution, ready: f64, all: f64) -> String {
    let setup = json!({ "name": "setup", "seconds": ready });
    let steps = solution.effort.seconds.iter().map(|(step, seconds)| json!({ "name": step, "seconds": seconds }));
    let stages: Vec<Value> = std::iter::once(setup).chain(steps).collect();
    pretty(&json!({ "seconds_total": all, "stages": stages }))
}
