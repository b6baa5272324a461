//! report.html: one self-contained page, without network, built from the files of the folder.

use scene::Fault;
use serde_json::{Value, json};
use wearshape::RunningIn;

use crate::line_plot::{Axis, LinePlot, escaped, line_plot};
use crate::run_in::run_in;

/// The stress on the deformed bodies.
pub const FIELD_PICTURE: &str = "plots/field.svg";

/// The plots as numbers, for the page and for other programs: plots/curves.json.
pub fn curves_json(plots: &[(&'static str, LinePlot)]) -> Value {
    let number = |value: f64| {
        if value.is_finite() { json!(value) } else { Value::Null }
    };
    let chart = |plot: &LinePlot| {
        let series = plot.series.iter().map(|series| {
            json!({
                "name": series.name,
                "dashed": series.dashed,
                "marks": series.marks,
                "x": series.points.iter().map(|point| number(point.0)).collect::<Vec<_>>(),
                "y": series.points.iter().map(|point| number(point.1)).collect::<Vec<_>>(),
            })
        });
        json!({
            "title": plot.title,
            "x_label": plot.x_label,
            "y_label": plot.y_label,
            "from_zero": plot.from_zero,
            "log_y": plot.axes[1] == Axis::Logarithmic,
            "series": series.collect::<Vec<_>>(),
        })
    };
    Value::Array(plots.iter().map(|(name, plot)| json!({ "file": name, "chart": chart(plot) })).collect())
}

/// What the page is built from: files of the folder.
struct Parts {
    summary: Value,
    /// plots/curves.json.
    curves: Value,
    /// The static picture of each chart.
    pictures: Vec<String>,
    /// plots/field.svg.
    field: Option<String>,
    /// Steps of a run in time.
    run_in: Option<Value>,
    /// scene.resolved.toml.
    resolved: String,
}

fn html(parts: &Parts) -> String {
    let Parts { summary, curves, pictures, field, run_in, resolved } = parts;
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
            "<figure data-chart=\"{number}\"><figcaption>{caption} <span>point to read, drag to zoom, double click to reset</span></figcaption>\n{picture}</figure>\n"
        );
    }
    if run_in.is_some() {
        out += "<h2>Running in</h2>\n<p class=\"soft\">Pressure and gap at the recorded steps; the start stays dashed.</p>\n\
                <p class=\"slider\"><input type=\"range\" id=\"step\" min=\"0\" value=\"0\" aria-label=\"step of the run\"> \
                <output id=\"moment\" for=\"step\"></output></p>\n\
                <figure id=\"run-in-pressure\"><figcaption>contact pressure</figcaption></figure>\n\
                <figure id=\"run-in-gap\"><figcaption>gap above its lowest point</figcaption></figure>\n";
    }
    if let Some(field) = field {
        out += "<h2>Inside the bodies</h2>\n<figure class=\"field\"><figcaption>von Mises stress</figcaption>\n";
        out += field;
        out += "</figure>\n<p class=\"soft\">Colours are clipped to 2 to 98 % of the area: at sharp corners and at sharp ends of contact the \
                stress of linear elasticity grows without bound, and the largest number there says more about the mesh than about the body. \
                All numbers are in fields/*.vtu. Body 1 is drawn without its free rigid motion, \
                which may part the bodies in the picture.</p>\n";
    }
    for part in ["shape", "pressure", "contact", "wear", "energy", "reactions", "error", "counters"] {
        out += &table(part, &summary[part]);
        if part == "shape" {
            out += &super::tolerance::tolerance(&summary["shape"]["tolerance"]);
        }
    }
    out += "<h2>Stages</h2>\n<div class=\"wide\"><table>\n<tr><th>stage</th><th>done</th><th>because</th></tr>\n";
    for stage in summary["stages"].as_array().into_iter().flatten() {
        out += &format!(
            "<tr><td>{}</td><td>{}</td><td>{}</td></tr>\n",
            escaped(stage["name"].as_str().unwrap_or("")),
            if stage["ran"].as_bool() == Some(true) { "yes" } else { "left out" },
            escaped(stage["because"].as_str().unwrap_or(""))
        );
    }
    out += "</table></div>\n<h2>Limits</h2>\n<p>Linear elastic bodies, small displacements. No heat, no lubricant, no 3-D edge effects: \
            a plane or axisymmetric section stands for the whole. The wear rule and its factors are taken as given.</p>\n";
    let unused: Vec<&str> = summary["unused_keys"].as_array().into_iter().flatten().filter_map(Value::as_str).collect();
    if !unused.is_empty() {
        out += &format!("<p>Keys of the scene that were not used: {}</p>\n", escaped(&unused.join(", ")));
    }
    out += &format!(
        "<h2>Scene</h2>\n<details><summary>scene.resolved.toml, SHA-256 <span class=\"hash\">{}</span></summary>\n<pre>{}</pre></details>\n",
        text("scene_sha256"),
        escaped(resolved)
    );
    // `<` cannot end the element early: it is written as an escape.
    let data = json!({ "charts": charts, "run_in": run_in }).to_string().replace('<', "\\u003c");
    out += &format!("<script type=\"application/json\" id=\"data\">{data}</script>\n");
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
    let mut out = format!("<h2>{heading}</h2>\n<div class=\"wide\"><table>\n");
    for (key, value) in super::summary::numbers(part) {
        let class = if value.is_number() { " class=\"number\"" } else { "" };
        out += &format!("<tr><td>{}</td><td{class}>{}</td></tr>\n", breakable(&key), escaped(&shown(&value)));
    }
    let lists = part.as_object().into_iter().flatten().filter(|(_, value)| value.is_array());
    for (key, value) in lists.filter(|(key, _)| *key != "tolerance") {
        let items: Vec<String> = value.as_array().into_iter().flatten().map(shown).collect();
        if !items.is_empty() {
            out += &format!("<tr><td>{}</td><td>{}</td></tr>\n", breakable(key), escaped(&items.join(", ")));
        }
    }
    out + "</table></div>\n"
}

/// A value of the summary as text.
fn shown(value: &Value) -> String {
    match value {
        Value::Number(number) if number.is_f64() => scene::short(number.as_f64().unwrap_or(f64::NAN)),
        Value::String(text) => text.clone(),
        other => other.to_string(),
    }
}

/// A key that a narrow column may break between its words.
fn breakable(key: &str) -> String {
    escaped(key).replace('_', "_<wbr>").replace('.', ".<wbr>")
}

/// The page of a folder, from its other files and the steps of a run in time: the same bytes whenever it is built.
///
/// # Errors
/// A file that is missing or damaged, by name.
pub fn page(files: &dyn Fn(&str) -> Option<Vec<u8>>, running_in: Option<&RunningIn>) -> Result<String, Fault> {
    let missing = |name: &str| Fault::new("unreadable", format!("{name} is missing"), "give the folder of a finished run");
    let damaged = |name: &str, error: &dyn std::fmt::Display| {
        Fault::new("unreadable", format!("{name} is damaged: {error}"), "run the scene again")
    };
    let read = |name: &str| {
        let bytes = files(name).ok_or_else(|| missing(name))?;
        String::from_utf8(bytes).map_err(|error| damaged(name, &error))
    };
    let parse = |name: &str| serde_json::from_str::<Value>(&read(name)?).map_err(|error| damaged(name, &error));
    let summary = parse("summary.json")?;
    let curves = parse("plots/curves.json")?;
    let mut pictures = Vec::new();
    for name in curves.as_array().into_iter().flatten().filter_map(|entry| entry["file"].as_str()) {
        pictures.push(read(&format!("plots/{name}.svg"))?);
    }
    let field = if files(FIELD_PICTURE).is_some() { Some(read(FIELD_PICTURE)?) } else { None };
    let run_in = running_in.and_then(run_in);
    Ok(html(&Parts { summary, curves, pictures, field, run_in, resolved: read("scene.resolved.toml")? }))
}

/// Draws every plot.
pub fn pictures(plots: &[(&'static str, LinePlot)]) -> Vec<String> {
    plots.iter().map(|(_, plot)| line_plot(plot)).collect()
}
