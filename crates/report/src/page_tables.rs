//! The tables of the page: the parts of the summary, and the stages.

use serde_json::Value;

use crate::escape::{breakable, escaped};
use crate::one_percent::one_percent;
use crate::summary::numbers;
use crate::tolerance::tolerance;

/// Lists of the summary with a table of their own.
const OWN_TABLES: [&str; 2] = ["tolerance", "sensitivity"];

/// A table for each part of the summary.
pub(crate) fn tables(summary: &Value) -> String {
    let mut out = String::new();
    for part in ["shape", "pressure", "contact", "wear", "energy", "reactions", "error", "counters"] {
        out += &table(part, &summary[part]);
        match part {
            "shape" => out += &tolerance(&summary["shape"]["tolerance"]),
            "pressure" => out += &one_percent(&summary["pressure"]["sensitivity"]),
            _ => {}
        }
    }
    out
}

/// What was done, and why.
pub(crate) fn stages(summary: &Value) -> String {
    let mut out =
        "<h2>Stages</h2>\n<div class=\"wide\"><table>\n<tr><th>stage</th><th>done</th><th>because</th></tr>\n".to_string();
    for stage in summary["stages"].as_array().into_iter().flatten() {
        out += &format!(
            "<tr><td>{}</td><td>{}</td><td>{}</td></tr>\n",
            escaped(stage["name"].as_str().unwrap_or("")),
            if stage["ran"].as_bool() == Some(true) { "yes" } else { "left out" },
            escaped(stage["because"].as_str().unwrap_or(""))
        );
    }
    out + "</table></div>\n"
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
    for (key, value) in numbers(part) {
        let class = if value.is_number() { " class=\"number\"" } else { "" };
        out += &format!("<tr><td>{}</td><td{class}>{}</td></tr>\n", breakable(&key), escaped(&shown(&value)));
    }
    let lists = part.as_object().into_iter().flatten().filter(|(_, value)| value.is_array());
    for (key, value) in lists.filter(|(key, _)| !OWN_TABLES.contains(&key.as_str())) {
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
