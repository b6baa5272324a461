//! All files that a solution has to say.

use wearshape::{Problem, Solution, Step};

use crate::drawing::drawing;
use crate::json::pretty;
use crate::labels::shown_title;
use crate::line_plot::zoned_plot;
use crate::table::{columns_csv, profile_csv};
use crate::touch::Touch;
use crate::{curves, field_picture, heat_picture, machined, map_picture, page, path_csv, summary, vtu};

/// The files of a folder, by name and bytes; the same problem gives the same bytes. What takes a clock or goes on while a problem is solved
/// (timing.json, run.mcap) is not among them.
pub fn files(problem: &Problem, solution: &Solution) -> Vec<(String, Vec<u8>)> {
    let resolved = problem.resolved();
    let summary = summary::summary(problem, solution);
    let mut files: Vec<(String, Vec<u8>)> = Vec::new();
    let mut put = |name: &str, text: String| files.push((name.to_string(), text.into_bytes()));
    if let Some(profile) = &solution.profile {
        put("contact.csv", profile_csv(profile));
    }
    if !solution.history.is_empty() {
        put("history.csv", columns_csv(&with_numbers(&solution.history)));
    }
    if !solution.groove.is_empty() {
        put("groove.csv", columns_csv(&solution.groove));
    }
    if let Some(surface) = &solution.machined {
        machined::machined_files(surface, problem.title()).into_iter().for_each(|(name, text)| put(name, text));
    }
    path_csv::path_files(solution).into_iter().for_each(|(name, text)| put(&name, text));
    vtu::field_files(solution).into_iter().for_each(|(name, text)| put(&name, text));
    pictures(problem, solution, &mut put);
    put("summary.json", pretty(&summary));
    put("scene.resolved.toml", resolved);
    if problem.plan().runs(Step::Page) {
        let text = |name: &str| files.iter().find(|file| file.0 == name).and_then(|file| String::from_utf8(file.1.clone()).ok());
        // Files that were made a moment ago are whole.
        if let Ok(page) = page::built(&text, solution.running_in.as_ref()) {
            files.insert(0, ("report.html".into(), page.into_bytes()));
        }
    }
    files.extend(problem.files());
    files
}

/// The drawing, the plots with their numbers, the map and the stress.
fn pictures(problem: &Problem, solution: &Solution, put: &mut dyn FnMut(&str, String)) {
    let title = shown_title(problem);
    put(page::SCENE_PICTURE, drawing(problem));
    if let Some(frame) = solution.fields.first() {
        let touch = solution.profile.as_ref().and_then(|profile| Touch::new(problem, profile));
        let stress = format!("{title}: von Mises stress");
        put(page::FIELD_PICTURE, field_picture::field_picture(frame, touch.as_ref(), &stress));
        let warm = heat_picture::heat_picture(frame, &format!("{title}: temperature"));
        warm.into_iter().for_each(|picture| put(page::HEAT_PICTURE, picture));
    }
    if let (Some(map), Some(pressure)) = (&solution.map, &solution.pressure) {
        put(page::MAP_PICTURE, map_picture::map_picture(map, pressure, &format!("{title}: contact pressure")));
    }
    let plots = curves::line_plots(problem, solution);
    for picture in &plots {
        put(&format!("plots/{}.svg", picture.file), zoned_plot(&picture.plot, &picture.zones));
    }
    put("plots/curves.json", format!("{}\n", curves::curves_json(&plots)));
}

/// The columns that hold a number.
fn with_numbers(columns: &[(String, Vec<f64>)]) -> Vec<(String, Vec<f64>)> {
    columns.iter().filter(|(_, values)| values.iter().any(|value| !value.is_nan())).cloned().collect()
}
