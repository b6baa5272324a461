//! All files that a solution has to say.

use wearshape::{Problem, Solution, Step};

use crate::json::pretty;
use crate::line_plot::line_plot;
use crate::table::{columns_csv, profile_csv};
use crate::{curves, field_picture, machined, page, summary, vtu};

/// The files of a folder, by name and bytes; the same problem gives the same bytes. What takes a clock or goes on while a problem is solved
/// (timing.json, run.mcap) is not among them.
pub fn files(problem: &Problem, solution: &Solution) -> Vec<(String, Vec<u8>)> {
    let resolved = problem.resolved();
    let summary = summary::summary(problem, solution);
    let plots = curves::line_plots(problem, solution);
    let curves = curves::curves_json(&plots);
    let pictures: Vec<String> = plots.iter().map(|(_, plot)| line_plot(plot)).collect();
    let title = format!("{}: von Mises stress", problem.title());
    let field = solution.fields.first().map(|frame| field_picture::field_picture(frame, &title));
    let mut files: Vec<(String, Vec<u8>)> = Vec::new();
    let mut put = |name: &str, text: String| files.push((name.to_string(), text.into_bytes()));
    if problem.plan().runs(Step::Page) {
        let (field, running_in) = (field.as_deref(), solution.running_in.as_ref());
        let (summary, curves, pictures, resolved) = (&summary, &curves, &pictures, &resolved);
        put("report.html", page::html(&page::Parts { summary, curves, pictures, field, running_in, resolved }));
    }
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
    if let Some(picture) = field {
        put(page::FIELD_PICTURE, picture);
    }
    for ((name, _), picture) in plots.iter().zip(pictures) {
        put(&format!("plots/{name}.svg"), picture);
    }
    put("plots/curves.json", format!("{curves}\n"));
    put("summary.json", pretty(&summary));
    put("scene.resolved.toml", resolved);
    files.extend(problem.files());
    files
}
