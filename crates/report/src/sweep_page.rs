//! report.html of a sweep: the curves of its points over each other, and their main figures.

use serde_json::{Value, json};

use crate::curves::curves_json;
use crate::escape::escaped;
use crate::line_plot::{LinePlot, line_plot};
use crate::page::figures;

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
    let named: Vec<(&'static str, LinePlot)> = page.plots.iter().map(|plot| ("", plot.clone())).collect();
    let charts = curves_json(&named);
    let charts: Vec<&Value> = charts.as_array().into_iter().flatten().map(|entry| &entry["chart"]).collect();
    let pictures: Vec<String> = page.plots.iter().map(line_plot).collect();
    let title = escaped(page.title);
    let mut out = format!(
        "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <link rel=\"icon\" href=\"data:,\">\n<title>{title}: sweep</title>\n<style>\n{}</style>\n</head>\n<body>\n\
         <h1>{title}: sweep</h1>\n<p class=\"soft\">{} &middot; wearshape {} &middot; status: {}</p>\n<p class=\"verdict\">{}</p>\n",
        include_str!("page.css"),
        text("scene"),
        text("version"),
        text("status"),
        text("verdict")
    );
    out += &figures(&charts, &pictures);
    let points = page.summary["points"].as_u64().unwrap_or(0) as usize;
    out += &points_table(page, points);
    out += &format!(
        "<h2>Files</h2>\n<p><a href=\"sweep.csv\">sweep.csv</a>: all numbers of all points; \
         <a href=\"curves.csv\">curves.csv</a>: the curves.</p>\n<h2>Scene</h2>\n<details><summary>scene.resolved.toml of the first point, \
         headed by what was swept</summary>\n<pre>{}</pre></details>\n",
        escaped(page.resolved)
    );
    // `<` cannot end the element early: it is written as an escape.
    let data = json!({ "charts": charts, "run_in": null }).to_string().replace('<', "\\u003c");
    out += &format!("<script type=\"application/json\" id=\"data\">{data}</script>\n");
    out + "<script>\n" + include_str!("page.js") + "</script>\n</body>\n</html>\n"
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
