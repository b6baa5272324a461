//! report.html of a sweep: the curves of its points over each other, and their main figures.

use serde_json::{Value, json};

use crate::curves::{Picture, curves_json};
use crate::escape::escaped;
use crate::labels::{title_with_signs, with_signs};
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
    /// Why points among the rows have no answer, a sentence each.
    pub reasons: &'a [String],
    /// scene.resolved.toml.
    pub resolved: &'a str,
}

/// The page of a sweep, self-contained; the same parts give the same bytes.
pub fn sweep_page(page: &SweepPage<'_>) -> String {
    let text = |key: &str| escaped(page.summary[key].as_str().unwrap_or(""));
    let plots: Vec<LinePlot> = page.plots.iter().map(with_signs_of_units).collect();
    let plain = |plot: &LinePlot| Picture { file: String::new(), plot: plot.clone(), zones: Vec::new() };
    let charts = curves_json(&plots.iter().map(plain).collect::<Vec<Picture>>());
    let mut charts: Vec<Value> = charts.as_array().into_iter().flatten().map(|entry| entry["chart"].clone()).collect();
    let above = names_above(&plots);
    for chart in charts.iter_mut().filter(|_| above) {
        chart["names_above"] = json!(true);
    }
    let charts: Vec<&Value> = charts.iter().collect();
    let pictures: Vec<String> = plots.iter().map(line_plot).collect();
    let title = escaped(&title_with_signs(page.title));
    let mut out = begin(&format!("{title}: sweep"));
    out += &format!(
        "<h1>{title}: sweep</h1>\n<p class=\"soft\">{} &middot; wearshape {} &middot; status: {}</p>\n<p class=\"verdict\">{}</p>\n",
        text("scene"),
        text("version"),
        text("status"),
        with_signs(&text("verdict"))
    );
    if above {
        out += &legend(&plots);
    }
    out += &figures(&charts, &pictures);
    let points = page.summary["points"].as_u64().unwrap_or(0) as usize;
    out += &points_table(page, points);
    if !page.reasons.is_empty() {
        let reasons = page.reasons.iter().map(|reason| format!("<li>{}</li>\n", with_signs(&escaped(reason))));
        out += &format!("<h3>Without an answer</h3>\n<ul>\n{}</ul>\n", reasons.collect::<String>());
    }
    out += &format!(
        "<h2>Files</h2>\n<p><a href=\"sweep.csv\">sweep.csv</a>: all numbers of all points; \
         <a href=\"curves.csv\">curves.csv</a>: the curves.</p>\n<h2>Scene</h2>\n<details><summary>scene.resolved.toml of the first point, \
         headed by what was swept</summary>\n<pre>{}</pre></details>\n",
        escaped(page.resolved)
    );
    out + &end(&json!({ "charts": charts, "run_in": null }))
}

/// A plot whose title and whose names, values of axes as they were typed, have the signs of units.
fn with_signs_of_units(plot: &LinePlot) -> LinePlot {
    let mut plot = plot.clone();
    plot.title = title_with_signs(&plot.title);
    plot.series.iter_mut().for_each(|series| series.name = title_with_signs(&series.name));
    plot
}

/// Names that find room inside a chart, and letters of the longest of them: a third of its width.
const NAMES_INSIDE: usize = 6;
const LETTERS_INSIDE: usize = 20;
/// The colours of the charts, in their order.
const COLOURS: [&str; 7] = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#56b4e9", "#e69f00", "#888888"];

/// Whether the names of curves stand above the charts: many, or long ones, would cover the curves.
fn names_above(plots: &[LinePlot]) -> bool {
    let long = |plot: &LinePlot| plot.series.iter().any(|series| series.name.chars().count() > LETTERS_INSIDE);
    plots.iter().any(|plot| plot.series.len() > NAMES_INSIDE || long(plot))
}

/// The names of curves, above the charts.
fn legend(plots: &[LinePlot]) -> String {
    let Some(plot) = plots.iter().max_by_key(|plot| plot.series.len()) else { return String::new() };
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
    out.extend(page.names.iter().map(|name| format!("<th>{}</th>", with_signs(&escaped(name)))));
    out += "</tr>\n";
    for row in page.rows {
        out += "<tr>";
        out.extend(row.iter().map(|cell| format!("<td class=\"number\">{}</td>", title_with_signs(&escaped(cell)))));
        out += "</tr>\n";
    }
    out += "</table></div>\n";
    if points > page.rows.len() {
        out += &format!("<p class=\"soft\">The first {} of {points} points; all are in sweep.csv.</p>\n", page.rows.len());
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::line_plot::{Axis, Series};

    fn page_of(names: &[&str]) -> String {
        let points = vec![(0.0, 1.0), (1.0, 2.0)];
        let series =
            names.iter().map(|name| Series { name: (*name).into(), points: points.clone(), marks: false, dashed: false });
        let plot = LinePlot {
            title: "pressure".into(),
            x_label: "s (mm)".into(),
            y_label: "pressure (MPa)".into(),
            axes: [Axis::Linear; 2],
            from_zero: true,
            series: series.collect(),
        };
        let summary = json!({ "points": names.len(), "status": "ok" });
        let reasons = ["5: the force is <0".to_string()];
        sweep_page(&SweepPage {
            title: "t",
            summary: &summary,
            plots: &[plot],
            names: &[],
            rows: &[],
            reasons: &reasons,
            resolved: "",
        })
    }

    #[test]
    fn names_stand_inside_a_chart_while_they_are_few_and_short() {
        let above = |names: &[&str]| {
            let page = page_of(names);
            assert_eq!(page.contains("\"names_above\":true"), page.contains("<path d=\"M0 5h26\""));
            page.contains("\"names_above\":true")
        };
        assert!(!above(&["5 kN, .25", "10 kN, .25"]) && above(&["1"; 7]));
        assert!(above(&["{young=\"5 GPa\",poisson=0.3}", "steel"]));
    }

    #[test]
    fn points_without_an_answer_have_their_reason() {
        assert!(page_of(&["1"]).contains("<li>5: the force is &lt;0</li>"));
    }
}
