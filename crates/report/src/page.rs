//! report.html: one self-contained page, without network, built from the files of the folder.

use scene::Fault;
use serde_json::{Value, json};
use wearshape::RunningIn;

use crate::escape::escaped;
use crate::page_tables::{stages, tables};
use crate::run_in::run_in;

/// The stress on the deformed bodies.
pub(crate) const FIELD_PICTURE: &str = "plots/field.svg";

/// What the page is built from: files of the folder.
pub(crate) struct Parts<'a> {
    /// summary.json.
    pub(crate) summary: &'a Value,
    /// plots/curves.json.
    pub(crate) curves: &'a Value,
    /// The static picture of each chart.
    pub(crate) pictures: &'a [String],
    /// plots/field.svg.
    pub(crate) field: Option<&'a str>,
    /// Steps of a run in time.
    pub(crate) running_in: Option<&'a RunningIn>,
    /// scene.resolved.toml.
    pub(crate) resolved: &'a str,
}

/// The page; the same parts give the same bytes.
pub(crate) fn html(parts: &Parts<'_>) -> String {
    let Parts { summary, curves, resolved, .. } = parts;
    let charts: Vec<&Value> = curves.as_array().into_iter().flatten().map(|entry| &entry["chart"]).collect();
    let run_in = parts.running_in.and_then(run_in);
    let mut out = head(summary, resolved);
    out += &figures(&charts, parts.pictures);
    out += run_in.as_ref().map_or("", |_| RUN_IN);
    out += &parts.field.map(inside).unwrap_or_default();
    out += &tables(summary);
    out += &stages(summary);
    out += &limits(summary);
    out += &scene(summary, resolved);
    // `<` cannot end the element early: it is written as an escape.
    let data = json!({ "charts": charts, "run_in": run_in }).to_string().replace('<', "\\u003c");
    out += &format!("<script type=\"application/json\" id=\"data\">{data}</script>\n");
    out + "<script>\n" + include_str!("page.js") + "</script>\n</body>\n</html>\n"
}

/// A text of the summary.
fn text(summary: &Value, key: &str) -> String {
    escaped(summary[key].as_str().unwrap_or(""))
}

/// Up to the verdict and the remarks.
fn head(summary: &Value, resolved: &str) -> String {
    let text = |key: &str| text(summary, key);
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
    out
}

/// The charts with their static pictures.
fn figures(charts: &[&Value], pictures: &[String]) -> String {
    let mut out = String::new();
    for (number, chart) in charts.iter().enumerate() {
        let caption = escaped(chart["title"].as_str().unwrap_or(""));
        let picture = pictures.get(number).map_or("", String::as_str);
        out += &format!(
            "<figure data-chart=\"{number}\"><figcaption>{caption} <span>point to read, drag to zoom, double click to reset</span></figcaption>\n{picture}</figure>\n"
        );
    }
    out
}

/// Where the script draws the steps of a run in time.
const RUN_IN: &str = "<h2>Running in</h2>\n<p class=\"soft\">Pressure and gap at the recorded steps; the start stays dashed.</p>\n\
        <p class=\"slider\"><input type=\"range\" id=\"step\" min=\"0\" value=\"0\" aria-label=\"step of the run\"> \
        <output id=\"moment\" for=\"step\"></output></p>\n\
        <figure id=\"run-in-pressure\"><figcaption>contact pressure</figcaption></figure>\n\
        <figure id=\"run-in-gap\"><figcaption>gap above its lowest point</figcaption></figure>\n";

/// The stress on the deformed bodies.
fn inside(picture: &str) -> String {
    format!(
        "<h2>Inside the bodies</h2>\n<figure class=\"field\"><figcaption>von Mises stress</figcaption>\n{picture}</figure>\n\
         <p class=\"soft\">Colours are clipped to 2 to 98 % of the area: at sharp corners and at sharp ends of contact the \
        stress of linear elasticity grows without bound, and the largest number there says more about the mesh than about the body. \
        All numbers are in fields/*.vtu. Body 1 is drawn without its free rigid motion, \
        which may part the bodies in the picture.</p>\n"
    )
}

fn limits(summary: &Value) -> String {
    let mut out = "<h2>Limits</h2>\n<p>Linear elastic bodies, small displacements. No heat, no lubricant, no 3-D edge effects: \
            a plane or axisymmetric section stands for the whole. The wear rule and its factors are taken as given.</p>\n"
        .to_string();
    let unused: Vec<&str> = summary["unused_keys"].as_array().into_iter().flatten().filter_map(Value::as_str).collect();
    if !unused.is_empty() {
        out += &format!("<p>Keys of the scene that were not used: {}</p>\n", escaped(&unused.join(", ")));
    }
    out
}

fn scene(summary: &Value, resolved: &str) -> String {
    format!(
        "<h2>Scene</h2>\n<details><summary>scene.resolved.toml, SHA-256 <span class=\"hash\">{}</span></summary>\n<pre>{}</pre></details>\n",
        text(summary, "scene_sha256"),
        escaped(resolved)
    )
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
    let resolved = read("scene.resolved.toml")?;
    let (summary, curves, field) = (&summary, &curves, field.as_deref());
    Ok(html(&Parts { summary, curves, pictures: &pictures, field, running_in, resolved: &resolved }))
}
