//! report.html: one self-contained page, without network, built from the files of the folder.

use std::path::Path;

use serde_json::{Value, json};

use crate::fault::{Fault, Place};
use crate::report::line_plot::{LinePlot, escaped, line_plot};

/// The plots as numbers, for the page and for other programs: plots/curves.json.
pub(crate) fn curves_json(plots: &[(&'static str, LinePlot)]) -> Value {
    let number = |value: f64| {
        if value.is_finite() { json!(value) } else { Value::Null }
    };
    let chart = |plot: &LinePlot| {
        let series = plot.series.iter().map(|series| {
            json!({
                "name": series.name,
                "dashed": series.dashed,
                "x": series.points.iter().map(|point| number(point.0)).collect::<Vec<_>>(),
                "y": series.points.iter().map(|point| number(point.1)).collect::<Vec<_>>(),
            })
        });
        json!({
            "title": plot.title,
            "x_label": plot.x_label,
            "y_label": plot.y_label,
            "from_zero": plot.from_zero,
            "series": series.collect::<Vec<_>>(),
        })
    };
    Value::Array(plots.iter().map(|(name, plot)| json!({ "file": name, "chart": chart(plot) })).collect())
}

/// The page of a run: its summary, the plots with their pictures, the resolved scene.
pub(crate) fn page(summary: &Value, curves: &Value, pictures: &[String], resolved: &str) -> String {
    let text = |key: &str| escaped(summary[key].as_str().unwrap_or(""));
    let title = resolved
        .lines()
        .find_map(|line| line.strip_prefix("title = "))
        .map_or_else(|| text("scene"), |title| escaped(title.trim_matches('"')));
    let mut out = format!(
        "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <link rel=\"icon\" href=\"data:,\">\n<title>{title}</title>\n<style>\n{}</style>\n</head>\n<body>\n",
        include_str!("page.css")
    );
    out += &format!(
        "<h1>{title}</h1>\n<p class=\"soft\">{} &middot; wearshape {} &middot; status: {}</p>\n<p class=\"verdict\">{}</p>\n",
        text("scene"),
        text("version"),
        text("status"),
        text("verdict")
    );
    for lint in summary["lints"].as_array().into_iter().flatten() {
        let message = escaped(lint["message"].as_str().unwrap_or(""));
        out += &format!("<p class=\"note\"><b>{}</b>: {message}</p>\n", escaped(lint["code"].as_str().unwrap_or("")));
    }
    let charts: Vec<&Value> = curves.as_array().into_iter().flatten().map(|entry| &entry["chart"]).collect();
    for (number, chart) in charts.iter().enumerate() {
        let caption = escaped(chart["title"].as_str().unwrap_or(""));
        let picture = pictures.get(number).map_or("", String::as_str);
        out += &format!(
            "<figure data-chart=\"{number}\"><figcaption>{caption} <span>move to read, scroll to zoom, double click to reset</span></figcaption>\n{picture}</figure>\n"
        );
    }
    for part in ["shape", "pressure", "contact", "wear", "energy", "reactions", "error", "counters"] {
        out += &table(part, &summary[part]);
        if part == "shape" {
            out += &super::tolerance::tolerance(&summary["shape"]["tolerance"]);
        }
    }
    out += "<h2>Stages</h2>\n<table>\n<tr><th>stage</th><th>done</th><th>because</th></tr>\n";
    for stage in summary["stages"].as_array().into_iter().flatten() {
        out += &format!(
            "<tr><td>{}</td><td>{}</td><td>{}</td></tr>\n",
            escaped(stage["name"].as_str().unwrap_or("")),
            if stage["ran"].as_bool() == Some(true) { "yes" } else { "left out" },
            escaped(stage["because"].as_str().unwrap_or(""))
        );
    }
    out += "</table>\n<h2>Limits</h2>\n<p>Linear elastic bodies, small displacements. No heat, no lubricant, no 3-D edge effects: \
            a plane or axisymmetric section stands for the whole. The wear rule and its factors are taken as given.</p>\n";
    let unused: Vec<&str> = summary["unused_keys"].as_array().into_iter().flatten().filter_map(Value::as_str).collect();
    if !unused.is_empty() {
        out += &format!("<p>Keys of the scene that were not used: {}</p>\n", escaped(&unused.join(", ")));
    }
    out += &format!(
        "<h2>Scene</h2>\n<details><summary>scene.resolved.toml, SHA-256 {}</summary>\n<pre>{}</pre></details>\n",
        text("scene_sha256"),
        escaped(resolved)
    );
    // `<` cannot end the element early: it is written as an escape.
    let data = serde_json::to_string(&charts).unwrap_or_default().replace('<', "\\u003c");
    out += &format!("<script type=\"application/json\" id=\"charts\">{data}</script>\n");
    out + "<script>\n" + include_str!("page.js") + "</script>\n</body>\n</html>\n"
}

fn table(name: &str, part: &Value) -> String {
    if !part.is_object() {
        return String::new();
    }
    let mut heading = name.to_string();
    if let Some(first) = heading.get_mut(0..1) {
        first.make_ascii_uppercase();
    }
    let mut out = format!("<h2>{heading}</h2>\n<table>\n");
    for (key, value) in super::summary::numbers(part) {
        let shown = match &value {
            Value::Number(number) if number.is_f64() => super::short(number.as_f64().unwrap_or(f64::NAN)),
            Value::String(text) => text.clone(),
            other => other.to_string(),
        };
        out += &format!("<tr><td>{}</td><td class=\"number\">{}</td></tr>\n", escaped(&key), escaped(&shown));
    }
    let lists = part.as_object().into_iter().flatten().filter(|(_, value)| value.is_array());
    for (key, value) in lists.filter(|(key, _)| *key != "tolerance") {
        if value.as_array().is_some_and(|items| !items.is_empty()) {
            out += &format!("<tr><td>{}</td><td>{}</td></tr>\n", escaped(key), escaped(&value.to_string()));
        }
    }
    out + "</table>\n"
}

/// The page of a folder that was written before; the same bytes as the run wrote.
pub(crate) fn page_of_folder(folder: &Path) -> Result<String, Fault> {
    let read = |name: &str| {
        let path = folder.join(name);
        std::fs::read_to_string(&path).map_err(|error| Fault {
            place: Some(Place::Flag(folder.display().to_string())),
            ..Fault::new("unreadable", format!("cannot read {}: {error}", path.display()), "give the folder of a finished run")
        })
    };
    let parse = |name: &str, text: &str| {
        serde_json::from_str::<Value>(text).map_err(|error| Fault {
            place: Some(Place::Flag(folder.join(name).display().to_string())),
            ..Fault::new("unreadable", format!("{name} is damaged: {error}"), "run the scene again")
        })
    };
    let summary = parse("summary.json", &read("summary.json")?)?;
    let curves = parse("plots/curves.json", &read("plots/curves.json")?)?;
    let mut pictures = Vec::new();
    for name in curves.as_array().into_iter().flatten().filter_map(|entry| entry["file"].as_str()) {
        pictures.push(read(&format!("plots/{name}.svg"))?);
    }
    Ok(page(&summary, &curves, &pictures, &read("scene.resolved.toml")?))
}

/// Draws every plot.
pub(crate) fn pictures(plots: &[(&'static str, LinePlot)]) -> Vec<String> {
    plots.iter().map(|(_, plot)| line_plot(plot)).collect()
}
