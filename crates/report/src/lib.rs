//! Writes what was computed: the files of the output folder and the words on the screen.

mod curves;
mod dxf;
mod field_picture;
mod folder;
pub(crate) mod isobands;
pub(crate) mod line_plot;
mod machined;
mod page;
mod run_in;
pub(crate) mod section_plot;
mod summary;
mod terminal;
mod tolerance;
mod vtu;

use scene::{Fault, scene_text};

use wearshape::Step;
use crate::record::{LAYOUT, Points, RUN_MCAP, Recorder, Tape};
use wearshape::Problem;
use wearshape::Solution;

pub(crate) use curves::abscissa;
pub(crate) use folder::Folder;
pub(crate) use page::page_of_folder;
pub(crate) use summary::numbers;
pub(crate) use terminal::first_screen;

/// Version of the summary's keys.
pub(crate) const SCHEMA_VERSION: u32 = 1;

/// Text of scene.resolved.toml: the scene with every default, in base units.
pub(crate) fn resolved(problem: &Problem) -> Result<String, Fault> {
    let head = "# Every default filled in; units N, mm, MPa, s, rad. Running this file gives the same result.\n";
    Ok(format!("{head}{}", scene_text(&problem.scene())?))
}

/// The mesh files that the resolved scene names, to stand beside it.
pub(crate) fn mesh_files(scene: &scene::Scene) -> Vec<(String, &[u8])> {
    let bodies = [&scene.body1, &scene.body2].into_iter().flatten();
    let files = bodies.filter_map(|body| match &body.geometry {
        scene::Geometry::Mesh(file) => file.content.as_deref().map(|bytes| (file.file.clone(), bytes)),
        _ => None,
    });
    files.collect()
}

/// The summary of a run that writes no folder.
pub(crate) fn summary_of(problem: &Problem, solution: &Solution) -> Result<serde_json::Value, Fault> {
    Ok(summary::summary(problem, solution, &resolved(problem)?))
}

/// Writes all files of a finished run into its partial folder. Returns the summary.
pub(crate) fn write(
    folder: &Folder,
    problem: &Problem,
    solution: &Solution,
    resolved: &str,
    tape: Option<Tape>,
    seconds: [f64; 2],
) -> Result<serde_json::Value, Fault> {
    let summary = summary::summary(problem, solution, resolved);
    if let Some(profile) = &solution.profile {
        folder.write("contact.csv", &profile.csv())?;
    }
    if !solution.history.is_empty() {
        folder.write("history.csv", &columns_csv(&solution.history))?;
    }
    if let Some(surface) = &solution.machined {
        for (name, text) in machined::machined_files(surface, &title(problem)) {
            folder.write(name, &text)?;
        }
    }
    for (name, text) in vtu::field_files(&solution.fields) {
        folder.write(&name, &text)?;
    }
    if let Some(frame) = solution.fields.first() {
        let picture = field_picture::field_picture(frame, &format!("{}: von Mises stress", title(problem)));
        folder.write(page::FIELD_PICTURE, &picture)?;
    }
    let plots = curves::line_plots(problem, solution);
    let pictures = page::pictures(&plots);
    for ((name, _), svg) in plots.iter().zip(&pictures) {
        folder.write(&format!("plots/{name}.svg"), svg)?;
    }
    let curves = page::curves_json(&plots);
    folder.write("plots/curves.json", &format!("{curves}\n"))?;
    folder.write("timing.json", &timing(solution, seconds[0], seconds[1]))?;
    let text = pretty(&summary);
    folder.write("summary.json", &text)?;
    let verdict = summary["verdict"].as_str().unwrap_or("");
    // A run in time has been recorded as it went; anything else is one picture.
    if let Some(tape) = tape {
        tape.finish(verdict, &text)?;
    } else if let Some(profile) = solution.profile.as_ref().filter(|_| problem.plan().runs(Step::Recording)) {
        let mut recorder = Recorder::create(&folder.path().join(RUN_MCAP), resolved, None)?;
        recorder.log(verdict)?;
        recorder.picture(&Points::new(0, 0.0, profile))?;
        recorder.finish(&text)?;
    }
    if problem.plan().runs(Step::Recording) {
        folder.write(LAYOUT[0], LAYOUT[1])?;
    }
    if problem.plan().runs(Step::Page) {
        folder.write("report.html", &page_of_folder(folder.path())?)?;
    }
    Ok(summary)
}

/// Title of a scene, or its name.
pub(crate) fn title(problem: &Problem) -> String {
    problem.scene().title.clone().unwrap_or_else(|| problem.name().clone())
}

/// Named columns as CSV.
pub(crate) fn columns_csv(columns: &[(String, Vec<f64>)]) -> String {
    let names: Vec<&str> = columns.iter().map(|(name, _)| name.as_str()).collect();
    let mut out = names.join(",") + "\n";
    for row in 0..columns.iter().map(|(_, values)| values.len()).min().unwrap_or(0) {
        let cells: Vec<String> = columns.iter().map(|(_, values)| scene::number_text(values[row])).collect();
        out += &(cells.join(",") + "\n");
    }
    out
}

fn timing(solution: &Solution, ready: f64, seconds: f64) -> String {
    let setup = serde_json::json!({ "name": "setup", "seconds": ready });
    let steps = solution.effort.seconds.iter();
    let steps = steps.map(|(step, seconds)| serde_json::json!({ "name": step, "seconds": seconds }));
    let stages: Vec<serde_json::Value> = std::iter::once(setup).chain(steps).collect();
    pretty(&serde_json::json!({ "seconds_total": seconds, "stages": stages }))
}

/// JSON for a file.
pub(crate) fn pretty(value: &serde_json::Value) -> String {
    serde_json::to_string_pretty(value).unwrap_or_default() + "\n"
}
