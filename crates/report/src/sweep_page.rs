//! report.html of a sweep: the curves of its points over each other, and their main figures.

use serde_json::{Value, json};

use crate::curves::{Picture, curves_json};
use crate::escape::escaped;
use crate::labels::with_signs;
use crate::line_plot::{LinePlot, line_plot};
use crate::page::figures;
use crate::page_frame::{begin, end};

/// What the page of a sweep shows.
#[derive(Debug, Clone, Copy)]
pub struct SweepPage<'a> {
    /// Title of the scene.
    pub title: &'a str,
    /// summary.json.
    pub summary: &'a Value,
    /// The curves of the points, overlaid.
    pub plots: &'a [LinePlot],
    /// Columns of the table.
    pub names: &'a [String],
    /// Its rows, each as long as the columns; it may be the first ones of many.
    pub rows: &'a [Vec<String>],
    /// scene.resolved.toml.
    pub resolved: &'a str,
}

/// The page of a sweep, self-contained; the same parts give the same bytes.
pub fn sweep_page(page: &SweepPage<'_>) -> String {
    let text = |key: &str| escaped(page.summary[key].as_str().unwrap_or(""));
    let plain = |plot: &LinePlot| Picture { file: String::new(), plot: plot.clone(), zones: Vec::new() };
    let charts = curves_json(&page.plots.iter().map(plain).collect::<Vec<Picture>>());
    let charts: Vec<&Value> = charts.as_array().into_iter().flatten().map(|entry| &entry["chart"]).collect();
    let pictures: Vec<String> = page.plots.iter().map(line_plot).collect();
    let title = escaped(page.title);
    let mut out = begin(&format!("{title}: sweep"));
    out += &format!(
        "<h1>{title}: sweep</h1>\n<p class=\"soft\">{} &middot; wearshape {} &middot; status: {}</p>\n<p class=\"verdict\">{}</p>\n",
        text("scene"),
        text("version"),
        text("status"),
        with_signs(&text("verdict"))
    );
    out += &legend(page.plots);
    out += &figures(&charts, &pictures);
    let points = page.summary["points"].as_u64().unwrap_or(0) as usize;
    out += &points_table(page, points);
    out += &format!(
        "<h2>Files</h2>\n<p><a href=\"sweep.csv\">sweep.csv</a>: all numbers of all points; \
         <a href=\"curves.csv\">curves.csv</a>: the curves.</p>\n<h2>Scene</h2>\n<details><summary>scene.resolved.toml of the first point, \
         headed by what was swept</summary>\n<pre>{}</pre></details>\n",
        escaped(page.resolved)
    );
    out + &end(&json!({ "charts": charts, "run_in": null }))
}

/// Names that find room inside a chart.
const NAMES_INSIDE: usize = 6;
/// The colours of the charts, in their order.
const COLOURS: [&str; 7] = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#56b4e9", "#e69f00", "#888888"];

/// The names of many curves, above the charts.
fn legend(plots: &[LinePlot]) -> String {
    let Some(plot) = plots.iter().max_by_key(|plot| plot.series.len()).filter(|plot| plot.series.len() > NAMES_INSIDE) else {
        return String::new();
    };
    let mut out = String::from("<p>");
    for (series, colour) in plot.series.iter().zip(COLOURS.iter().cycle()) {
        let dash = if series.dashed { " stroke-dasharray=\"7 5\"" } else { "" };
        out += &format!(
            "<span style=\"display:inline-block;margin-right:1.2em\"><svg width=\"26\" height=\"10\" aria-hidden=\"true\">\
             <path d=\"M0 5h26\" stroke=\"{colour}\" stroke-width=\"2\"{dash}/></svg> {}</span>\n",
            escaped(&series.name)
        );
    }
    out + "</p>\n"
}

/// The points with their main figures.
fn points_table(page: &SweepPage<'_>, points: usize) -> String {
    let mut out = String::from("<h2>Points</h2>\n<div class=\"wide\"><table>\n<tr>");
    out.extend(page.names.iter().map(|name| format!("<th>{}</th>", escaped(name))));
    out += "</tr>\n";
    for row in page.rows {
        out += "<tr>";
        out.extend(row.iter().map(|cell| format!("<td class=\"number\">{}</td>", escaped(cell))));
        out += "</tr>\n";
    }
    out += "</table></div>\n";
    if points > page.rows.len() {
        out += &format!("<p class=\"soft\">The first {} of {points} points; all are in sweep.csv.</p>\n", page.rows.len());
    }
    out
}
