//! All files that a solution has to say.

use scene::Fault;
use wearshape::{Problem, Solution, Step};

use crate::json::pretty;
use crate::table::{columns_csv, profile_csv};
use crate::{curves, field_picture, machined, page, summary, vtu};

/// The files of a folder, by name and bytes; the same problem gives the same bytes. What takes a clock or goes on while a problem is solved
/// (timing.json, run.mcap) is not among them.
///
/// # Errors
/// A scene that cannot be written, which is a fault of ours.
pub fn files(problem: &Problem, solution: &Solution) -> Result<Vec<(String, Vec<u8>)>, Fault> {
    let resolved = problem.resolved()?;
    let mut files: Vec<(String, Vec<u8>)> = Vec::new();
    let mut put = |name: &str, text: String| files.push((name.to_string(), text.into_bytes()));
    if let Some(profile) = &solution.profile {
        put("contact.csv", profile_csv(profile));
    }
    if !solution.history.is_empty() {
        put("history.csv", columns_csv(&solution.history));
    }
    if let Some(surface) = &solution.machined {
        machined::machined_files(surface, problem.title()).into_iter().for_each(|(name, text)| put(name, text));
    }
    vtu::field_files(&solution.fields).into_iter().for_each(|(name, text)| put(&name, text));
    if let Some(frame) = solution.fields.first() {
        put(page::FIELD_PICTURE, field_picture::field_picture(frame, &format!("{}: von Mises stress", problem.title())));
    }
    let plots = curves::line_plots(problem, solution);
    for ((name, _), svg) in plots.iter().zip(page::pictures(&plots)) {
        put(&format!("plots/{name}.svg"), svg);
    }
    put("plots/curves.json", format!("{}\n", page::curves_json(&plots)));
    put("summary.json", pretty(&summary::summary(problem, solution)?));
    put("scene.resolved.toml", resolved);
    files.extend(problem.files());
    if problem.plan().runs(Step::Page) {
        let known = |name: &str| files.iter().find(|(known, _)| known == name).map(|(_, bytes)| bytes.clone());
        let page = page::page(&known, solution.running_in.as_ref())?;
        files.push(("report.html".into(), page.into_bytes()));
    }
    Ok(files)
}
