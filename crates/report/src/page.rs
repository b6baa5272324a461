//! report.html: one self-contained page, without network, built from the files of the folder.

use scene::{Document, Fault, Kinematics};
use serde_json::{Value, json};
use wearshape::RunningIn;

use crate::escape::escaped;
use crate::harmless::is_harmless;
use crate::labels::{title_with_signs, with_signs};
use crate::page_frame::{begin, end};
use crate::page_tables::{glance_html, stages, tables};
use crate::run_in::run_in;

/// The drawing of the scene, the stress on the deformed bodies, the temperature in them, and the pressure over a surface of two dimensions.
pub(crate) const SCENE_PICTURE: &str = "plots/scene.svg";
pub(crate) const FIELD_PICTURE: &str = "plots/field.svg";
pub(crate) const HEAT_PICTURE: &str = "plots/temperature-field.svg";
pub(crate) const MAP_PICTURE: &str = "plots/map.svg";

/// Files that a folder may hold, with what is in them.
const FILES: [(&str, &str); 13] = [
    ("summary.json", "every result with its unit"),
    ("contact.csv", "one row a contact point"),
    ("history.csv", "the steps of the run in time"),
    ("groove.csv", "profile of the groove in body 2"),
    ("profile.csv", "the finished surface as points"),
    ("profile-spline.csv", "the finished surface as cubic pieces"),
    ("profile.dxf", "the finished surface as a drawing"),
    ("fields/body1.vtu", "stress in body 1, for ParaView"),
    ("fields/body2.vtu", "stress in body 2, for ParaView"),
    ("fields/fields.pvd", "both bodies, for ParaView"),
    (SCENE_PICTURE, "the drawing above"),
    ("plots/curves.json", "the curves above as numbers"),
    ("scene.resolved.toml", "the scene with every default"),
];

/// What the page is built from: files of the folder.
struct Parts<'a> {
    /// summary.json.
    summary: Value,
    /// plots/curves.json.
    curves: Value,
    /// The static picture of each chart.
    pictures: Vec<String>,
    /// The drawing of the scene, the stress, the temperature, the map.
    scene: Option<String>,
    field: Option<String>,
    heat: Option<String>,
    map: Option<String>,
    /// Steps of a run in time.
    running_in: Option<&'a RunningIn>,
    /// scene.resolved.toml.
    resolved: String,
    /// Names of pictures that are none of ours.
    left_out: Vec<String>,
    /// Names of the files that are there.
    there: Vec<&'static str>,
}

/// The page; the same parts give the same bytes.
fn html(parts: &Parts<'_>) -> String {
    let Parts { summary, curves, resolved, .. } = parts;
    let charts: Vec<&Value> = curves.as_array().into_iter().flatten().map(|entry| &entry["chart"]).collect();
    let scene = Document::read("scene.resolved.toml", resolved, &[]).ok().map(|document| document.scene);
    let revolved = scene.as_ref().is_some_and(|scene| scene.kinematics == Some(Kinematics::Axisymmetric));
    let run_in = parts.running_in.and_then(|run| run_in(run, revolved));
    let mut out = head(summary, scene.and_then(|scene| scene.title));
    if !parts.left_out.is_empty() {
        let names = escaped(&parts.left_out.join(", "));
        out += &format!("<p class=\"note\">Left out, for they are no pictures as wearshape draws them: {names}</p>\n");
    }
    if let Some(picture) = &parts.scene {
        out += &format!("<figure class=\"drawn scene\">\n{picture}</figure>\n");
    }
    out += &glance_html(summary);
    if let Some(picture) = &parts.map {
        out += &format!("<figure class=\"drawn map\"><figcaption>pressure over the surface</figcaption>\n{picture}</figure>\n");
    }
    out += &figures(&charts, &parts.pictures);
    out += run_in.as_ref().map_or("", |_| RUN_IN);
    out += &parts.field.as_deref().map(|picture| inside(picture, parts.heat.as_deref())).unwrap_or_default();
    out += &links(parts);
    out += &tables(summary, revolved);
    out += &stages(summary);
    out += &limits(summary);
    out += &source(summary, resolved);
    out + &end(&json!({ "charts": charts, "run_in": run_in }))
}

/// Before the files of a shape that is no answer.
const REFUSED: &str = "<p class=\"note\">The shape is refused and must not be machined: there is no finished surface among the files, \
                       and no tolerance. Its gap is drawn and listed to see why.</p>\n";

/// The files of the folder, by relative links.
fn links(parts: &Parts<'_>) -> String {
    let recorded = |stage: &&Value| stage["name"] == "run.mcap" && stage["ran"] == true;
    let recording = parts.summary["stages"].as_array().into_iter().flatten().any(|stage| recorded(&stage));
    let known = FILES.iter().filter(|(name, _)| parts.there.contains(name)).copied();
    let all = known.chain(recording.then_some(("run.mcap", "the recording, for Foxglove or Lichtblick")));
    let rows: String = all.map(|(name, words)| format!("<li><a href=\"{name}\">{name}</a> {words}</li>\n")).collect();
    let shape = !parts.summary["shape"].is_null() && !parts.there.contains(&"profile.csv");
    let refused = if shape && parts.summary["status"] == "refused" { REFUSED } else { "" };
    format!("<h2>Files</h2>\n{refused}<ul class=\"files\">\n{rows}</ul>\n")
}

/// A text of the summary.
fn text(summary: &Value, key: &str) -> String {
    escaped(summary[key].as_str().unwrap_or(""))
}

/// Up to the verdict and the remarks, below the title that the scene gives.
fn head(summary: &Value, given: Option<String>) -> String {
    let text = |key: &str| text(summary, key);
    let title = given.map_or_else(|| text("scene"), |title| escaped(&title_with_signs(&title)));
    let mut out = begin(&title);
    out += &format!(
        "<h1>{title}</h1>\n<p class=\"verdict\">{}</p>\n<p class=\"soft\">{} &middot; wearshape {} &middot; status: {}</p>\n",
        with_signs(&text("verdict")),
        text("scene"),
        text("version"),
        text("status")
    );
    for lint in summary["lints"].as_array().into_iter().flatten() {
        let message = with_signs(&escaped(lint["message"].as_str().unwrap_or("")));
        out += &format!("<p class=\"note\"><b>{}</b>: {message}</p>\n", escaped(lint["code"].as_str().unwrap_or("")));
    }
    out
}

/// The charts with their static pictures.
pub(crate) fn figures(charts: &[&Value], pictures: &[String]) -> String {
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

/// The stress on the deformed bodies, and their temperature.
fn inside(picture: &str, heat: Option<&str>) -> String {
    let warm = heat
        .map(|picture| format!("<figure class=\"drawn field\"><figcaption>temperature</figcaption>\n{picture}</figure>\n"))
        .unwrap_or_default();
    format!(
        "<h2>Inside the bodies</h2>\n{warm}<figure class=\"drawn field\"><figcaption>von Mises stress</figcaption>\n{picture}</figure>\n\
         <p class=\"soft\">Colours are clipped to 2 to 98 % of the area: at sharp corners and at sharp ends of contact the \
        stress of linear elasticity grows without bound, and the largest number there says more about the mesh than about the body. \
        All numbers are in fields/*.vtu. Body 1 is drawn where it stands on body 2.</p>\n"
    )
}

/// What is taken of heat, before what is not there.
const HEAT: &str = "Heat is steady: the temperature is that of the present pressure, for heat spreads fast against wear; \
                    conductivity, expansion and stiffness do not depend on it. The shape is that of the cold bodies. No";

fn limits(summary: &Value) -> String {
    let heat = if summary["heat"].is_null() { "No heat, no" } else { HEAT };
    let mut out = format!(
        "<h2>Limits</h2>\n<p>Linear elastic bodies, small displacements. {heat} lubricant, no 3-D edge effects: \
            a plane or axisymmetric section stands for the whole. The wear rule and its factors are taken as given.</p>\n"
    );
    let unused: Vec<&str> = summary["unused_keys"].as_array().into_iter().flatten().filter_map(Value::as_str).collect();
    if !unused.is_empty() {
        out += &format!("<p>Keys of the scene that were not used: {}</p>\n", escaped(&unused.join(", ")));
    }
    out
}

/// The scene as it was read.
fn source(summary: &Value, resolved: &str) -> String {
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
    let text = |name: &str| {
        let bytes = files(name)?;
        Some(String::from_utf8(bytes).map_err(|error| damaged(name, &error)))
    };
    // Known first, so that a file which is no text is named.
    for name in ["summary.json", "plots/curves.json", "scene.resolved.toml"] {
        text(name).transpose()?.ok_or_else(|| missing(name))?;
    }
    // The page links to tables without showing them: one that was emptied would pass for a result.
    for name in ["contact.csv", "history.csv", "groove.csv"] {
        if text(name).transpose()?.is_some_and(|table| table.trim_end().lines().count() < 2) {
            return Err(damaged(name, &"it has no rows"));
        }
    }
    built(&|name| text(name).and_then(Result::ok), running_in)
}

/// The page from the texts of the other files.
pub(crate) fn built(text: &dyn Fn(&str) -> Option<String>, running_in: Option<&RunningIn>) -> Result<String, Fault> {
    let read = |name: &str| text(name).ok_or_else(|| missing(name));
    let parse = |name: &str| serde_json::from_str::<Value>(&read(name)?).map_err(|error| damaged(name, &error));
    let curves = parse("plots/curves.json")?;
    let mut pictures = Vec::new();
    let mut left_out = Vec::new();
    for name in curves.as_array().into_iter().flatten().filter_map(|entry| entry["file"].as_str()) {
        let file = format!("plots/{name}.svg");
        // A chart without its picture is drawn by the script.
        let picture = if is_plain(name) { read(&file)? } else { String::new() };
        pictures.push(checked(&file, picture, &mut left_out).unwrap_or_default());
    }
    let [scene, field, heat, map] = [SCENE_PICTURE, FIELD_PICTURE, HEAT_PICTURE, MAP_PICTURE]
        .map(|name| text(name).and_then(|picture| checked(name, picture, &mut left_out)));
    Ok(html(&Parts {
        summary: parse("summary.json")?,
        curves,
        pictures,
        scene,
        field,
        heat,
        map,
        left_out,
        running_in,
        resolved: read("scene.resolved.toml")?,
        there: FILES.iter().map(|(name, _)| *name).filter(|name| text(name).is_some()).collect(),
    }))
}

/// Whether a name is that of a plain file: letters, digits and hyphens.
fn is_plain(name: &str) -> bool {
    !name.is_empty() && name.chars().all(|c| c.is_ascii_alphanumeric() || c == '-')
}

/// A picture of ours; of any other the name is kept.
fn checked(name: &str, picture: String, left_out: &mut Vec<String>) -> Option<String> {
    let harmless = is_harmless(&picture);
    if !harmless {
        left_out.push(name.to_string());
    }
    harmless.then_some(picture)
}

fn missing(name: &str) -> Fault {
    Fault::new("unreadable", format!("{name} is missing"), "give the folder of a finished run")
}

fn damaged(name: &str, error: &dyn std::fmt::Display) -> Fault {
    Fault::new("unreadable", format!("{name} is damaged: {error}"), "run the scene again")
}

#[cfg(test)]
mod tests {
    use scene::Document;
    use serde_json::json;

    use super::head;

    #[test]
    fn a_title_is_what_the_scene_says_however_it_is_quoted() {
        let summary = json!({ "scene": "a-scene", "verdict": "", "version": "", "status": "ok", "lints": [] });
        let scene = scene::builtin("drum-brake-block").map_or("", |scene| scene.text);
        let rest: String = scene.lines().filter(|line| !line.starts_with("title")).map(|line| format!("{line}\n")).collect();
        for (title, shown) in [
            ("\"Brake 12 in\"", "Brake 12 in"),
            ("'Brake 12\" drum'", "Brake 12&quot; drum"),
            ("\"C:\\\\temp it's\"", "C:\\temp it's"),
            ("\"\"\"two\nlines\"\"\"", "two\nlines"),
        ] {
            let scene = Document::read("scene.resolved.toml", &format!("title = {title}\n{rest}"), &[]).map(|read| read.scene);
            let page = head(&summary, scene.ok().and_then(|scene| scene.title));
            assert!(page.contains(&format!("<h1>{shown}</h1>")), "{title}: {page}");
        }
        assert!(head(&summary, None).contains("<h1>a-scene</h1>"));
    }
}
