//! The tables of the page: the parts of the summary, and the stages.

use serde_json::Value;

use crate::brief::brief;
use crate::escape::escaped;
use crate::labels::{by_radius, label, label_of_mean, with_signs, word_explained};
use crate::one_percent::one_percent;
use crate::round_off::without_round_off;
use crate::summary::numbers;
use crate::tolerance::tolerance;

/// Lists of the summary with a table of their own.
const OWN_TABLES: [&str; 2] = ["tolerance", "sensitivity"];

/// Headings of the parts.
const HEADINGS: [(&str, &str); 12] = [
    ("machining", "As it is now against as machined"),
    ("reversing", "Forward and backward"),
    ("shape", "Shape"),
    ("pressure", "Wanted pressure"),
    ("contact", "Contact"),
    ("wear", "Wear in time"),
    ("heat", "Heat of friction"),
    ("brake", "As a brake"),
    ("energy", "Energy"),
    ("reactions", "Forces on the supports"),
    ("error", "Estimated errors"),
    ("counters", "What it took"),
];

/// A table for each part of the summary, as HTML in which every text is escaped; of bodies of revolution (`revolved`) x is the radius.
pub fn tables(summary: &Value, revolved: bool) -> String {
    let summary = &without_round_off(summary);
    let mut out = String::new();
    for part in [
        "machining",
        "shape",
        "pressure",
        "reversing",
        "contact",
        "wear",
        "heat",
        "brake",
        "energy",
        "reactions",
        "error",
        "counters",
    ] {
        let of_mean = part == "pressure" && !summary["reversing"].is_null();
        out += &table(part, &summary[part], &|key| {
            let (words, unit) = if of_mean { label_of_mean(key) } else { label(key) };
            (if revolved { by_radius(&words) } else { words }, unit)
        });
        match part {
            "shape" => out += &tolerance(&summary["shape"]["tolerance"]),
            "pressure" => out += &one_percent(&summary["pressure"]),
            _ => {}
        }
    }
    out
}

/// What was done, and why.
pub(crate) fn stages(summary: &Value) -> String {
    let mut out =
        "<h2>What was done</h2>\n<div class=\"wide\"><table>\n<tr><th>stage</th><th>done</th><th>because</th></tr>\n".to_string();
    for stage in summary["stages"].as_array().into_iter().flatten() {
        out += &format!(
            "<tr><td>{}</td><td>{}</td><td>{}</td></tr>\n",
            escaped(stage["name"].as_str().unwrap_or("")),
            if stage["ran"].as_bool() == Some(true) { "yes" } else { "left out" },
            with_signs(&escaped(stage["because"].as_str().unwrap_or("")))
        );
    }
    out + "</table></div>\n"
}

/// The first numbers of a summary in the units of an engineer: words, number, unit.
pub fn glance(summary: &Value) -> Vec<(&'static str, f64, &'static str)> {
    let number = |part: &str, key: &str| summary[part][key].as_f64().filter(|value| value.is_finite());
    let mut rows = Vec::new();
    let mut put = |words: &'static str, value: Option<f64>, factor: f64, unit: &'static str| {
        rows.extend(value.map(|value| (words, factor * value, unit)));
    };
    let pressures = if summary["pressure"]["p_max_MPa"].is_null() { "contact" } else { "pressure" };
    let sense = |sense: &str| summary["reversing"][sense]["p_max_MPa"].as_f64();
    put("largest pressure forward", sense("forward"), 1.0, "MPa");
    put("largest pressure backward", sense("back"), 1.0, "MPa");
    let largest = if summary["reversing"].is_null() { "largest pressure" } else { "largest mean pressure" };
    put(largest, number(pressures, "p_max_MPa"), 1.0, "MPa");
    put("largest pressure as it is now", number("machining", "p_max_now_MPa"), 1.0, "MPa");
    put("in contact as it is now", number("machining", "contact_share_now"), 100.0, "% of the surface");
    put("in contact as machined", number("machining", "contact_share_then"), 100.0, "% of the surface");
    let smallest = if summary["reversing"].is_null() { "smallest pressure" } else { "smallest mean pressure" };
    put(smallest, number(pressures, "p_min_MPa"), 1.0, "MPa");
    put("mean pressure", number(pressures, "p_mean_MPa"), 1.0, "MPa");
    put("largest shear", number("contact", "q_max_MPa"), 1.0, "MPa");
    // Of a scene that asks for its contact alone; a contact of several parts has more ends than a glance.
    let ends = summary["contact"]["ends_mm"].as_array().filter(|ends| pressures == "contact" && ends.len() == 2);
    put("contact begins at", ends.and_then(|ends| ends[0].as_f64()), 1.0, "mm");
    put("contact ends at", ends.and_then(|ends| ends[1].as_f64()), 1.0, "mm");
    put("closing of body 1", number("contact", "approach_mm").filter(|_| pressures == "contact"), 1e3, "\u{b5}m");
    put("most taken off", number("shape", "gap_max_um"), 1.0, "\u{b5}m");
    put("mean wear of both bodies", number("pressure", "wear_depth_um_per_h"), 1.0, "\u{b5}m an hour");
    put("the same by distance", number("pressure", "wear_depth_mm_per_1000_km"), 1.0, "mm in 1000 km");
    put("wear volume", number("pressure", "wear_volume_rate_mm3_per_s"), 1.0, "mm\u{b3}/s");
    put("friction power", number("pressure", "friction_power_mW"), 1e-3, "W");
    put("friction torque", number("pressure", "torque_Nmm"), 1e-3, "N m");
    put("highest temperature of body 1", number("heat", "T_max1_degC"), 1.0, "\u{b0}C");
    put("highest temperature of body 2", number("heat", "T_max2_degC"), 1.0, "\u{b0}C");
    put("depth worn off body 1", number("wear", "depth_um"), 1.0, "\u{b5}m");
    put("volume worn off both bodies", number("wear", "volume_mm3"), 1.0, "mm\u{b3}");
    put("scar", number("wear", "scar_mm"), 1.0, "mm");
    put("groove in body 2", summary["wear"]["groove"]["depth_um"].as_f64(), 1.0, "\u{b5}m deep");
    put("after", number("wear", "time_s"), 1.0, "s");
    let per =
        |of: &str| number("wear", "depth_um").zip(number("wear", of)).filter(|(_, by)| *by > 0.0).map(|(depth, by)| depth / by);
    put("wear on average", per("time_s"), 3600.0, "\u{b5}m an hour");
    put("the same by distance", per("distance_mm"), 1e6, "mm in 1000 km");
    rows
}

/// The first numbers, in four digits.
pub(crate) fn glance_html(summary: &Value) -> String {
    let rows = glance(&without_round_off(summary));
    if rows.is_empty() {
        return String::new();
    }
    let row = |(words, value, unit): &(&str, f64, &str)| {
        format!("<div><dt>{words}</dt><dd>{}</dd></div>\n", escaped(&format!("{} {unit}", brief(*value))))
    };
    let rows: String = rows.iter().map(row).collect();
    format!("<dl class=\"glance\">\n{rows}</dl>\n")
}

fn table(name: &str, part: &Value, label: &dyn Fn(&str) -> (String, &'static str)) -> String {
    // What needs no bodies took nothing.
    let nothing = name == "counters" && part.as_object().into_iter().flatten().all(|(_, count)| *count == 0);
    if !part.is_object() || nothing {
        return String::new();
    }
    let heading = HEADINGS.iter().find(|(known, _)| *known == name).map_or(name, |(_, heading)| heading);
    let mut rows = String::new();
    let mut row = |key: &str, value: &str, number: bool| {
        let (words, unit) = label(&format!("{name}.{key}"));
        let class = if number { " class=\"number\"" } else { "" };
        let space = if unit.is_empty() { "" } else { " " };
        rows += &format!(
            "<tr><td title=\"{}\">{}</td><td{class}>{}{space}{unit}</td></tr>\n",
            escaped(&format!("{name}.{key}")),
            escaped(&words),
            escaped(value)
        );
    };
    for (key, value) in numbers(part) {
        let explained = value
            .as_str()
            .filter(|_| key != "status")
            .and_then(word_explained)
            .map_or(String::new(), |words| format!(" ({words})"));
        row(&key, &format!("{}{explained}", shown(&value)), value.is_number());
    }
    let lists = part.as_object().into_iter().flatten().filter(|(_, value)| value.is_array());
    for (key, value) in lists.filter(|(key, _)| !OWN_TABLES.contains(&key.as_str())) {
        let items: Vec<String> = value.as_array().into_iter().flatten().map(shown).collect();
        if !items.is_empty() {
            row(key, &items.join(", "), false);
        }
    }
    // A part of which nothing was asked for has no heading.
    if rows.is_empty() {
        return rows;
    }
    format!("<h2>{heading}</h2>\n<div class=\"wide\"><table>\n{rows}</table></div>\n")
}

/// A value of the summary as text.
fn shown(value: &Value) -> String {
    match value {
        Value::Number(number) if number.is_f64() => scene::short(number.as_f64().unwrap_or(f64::NAN)),
        Value::String(text) => text.clone(),
        Value::Bool(yes) => if *yes { "yes" } else { "no" }.into(),
        Value::Object(entries) => {
            let entries: Vec<String> = entries
                .iter()
                .map(|(key, value)| {
                    let (words, unit) = label(key);
                    format!("{words} {} {unit}", shown(value)).trim_end().to_string()
                })
                .collect();
            entries.join(", ")
        }
        other => other.to_string(),
    }
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::tables;

    #[test]
    fn a_part_without_numbers_has_no_heading() {
        let page = tables(&json!({ "energy": {}, "contact": { "force_N": 2.0 } }), false);
        assert!(page.contains("<h2>Contact</h2>") && !page.contains("Energy"), "{page}");
    }

    #[test]
    fn places_of_bodies_of_revolution_are_told_by_their_radius() {
        let summary = json!({ "heat": { "T_max1_at_mm": [81.0, 12.0], "T_max2_at_mm": [80.0, 12.0] } });
        let words = |revolved: bool| tables(&summary, revolved);
        assert!(words(true).contains(">place of the highest temperature of body 2 (r, z)<"), "{}", words(true));
        assert!(words(false).contains(">place of the highest temperature of body 1 (x, z)<"), "{}", words(false));
    }
}
