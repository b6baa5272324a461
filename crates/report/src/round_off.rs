//! Round-off of a summary, which keeps its bits, and is shown as the 0 that it stands for.

use serde_json::{Map, Value, json};

use crate::summary::numbers;

/// Share of the largest force, or of a force over a length, below which a number is round-off.
const NOTHING: f64 = 1e-9;
/// The same of the coordinates of a place: that of a smooth extremum is found to half of the digits.
const NOWHERE: f64 = 1e-7;

/// The sizes that numbers are measured by: the largest force (N), and the largest coordinate of a place (mm), 1 mm where there is none.
struct Sizes {
    force: f64,
    length: f64,
}

/// A summary as it is shown: without the digits of what is nothing, and without the place of a largest pressure that is everywhere.
pub(crate) fn without_round_off(summary: &Value) -> Value {
    let forces = numbers(summary).into_iter().filter(|(key, _)| key.ends_with("_N")).filter_map(|(_, force)| force.as_f64());
    let mut places = Vec::new();
    add_places(summary, &mut places);
    let most = |values: &mut dyn Iterator<Item = f64>| values.map(f64::abs).fold(0.0, f64::max);
    let length = most(&mut places.into_iter());
    let sizes = Sizes { force: most(&mut forces.into_iter()), length: if length > 0.0 { length } else { 1.0 } };
    let mut shown = summary.clone();
    if let Some(parts) = shown.as_object_mut() {
        cleared(parts, &sizes);
    }
    let number = |key: &str| summary["pressure"][key].as_f64();
    let even = number("p_max_MPa").zip(number("p_min_MPa")).is_some_and(|(most, least)| most - least <= NOTHING * most);
    if let Some(pressure) = shown.get_mut("pressure").and_then(Value::as_object_mut).filter(|_| even) {
        pressure.remove("p_max_at_mm");
    }
    shown
}

/// A place as it is shown, without the digits of coordinates that are nothing.
pub(crate) fn shown_place(place: [f64; 3]) -> [f64; 3] {
    let far = place.into_iter().map(f64::abs).fold(0.0, f64::max);
    place.map(|x| if x.abs() < NOWHERE * far { 0.0 } else { x })
}

/// Whether a key is that of places.
fn is_place(key: &str) -> bool {
    ["_at_mm", "_where_mm", "ends_mm"].iter().any(|end| key.ends_with(end))
}

/// Adds the coordinates of the places in a part of a summary; its errors are none.
fn add_places(part: &Value, places: &mut Vec<f64>) {
    for (key, value) in part.as_object().into_iter().flatten().filter(|(key, _)| *key != "error") {
        match value {
            Value::Array(items) if is_place(key) => places.extend(items.iter().filter_map(Value::as_f64)),
            Value::Number(number) if is_place(key) => places.extend(number.as_f64()),
            Value::Object(_) => add_places(value, places),
            Value::Null | Value::Bool(_) | Value::Number(_) | Value::String(_) | Value::Array(_) => {}
        }
    }
}

/// Keys of the coordinates of a place that has a part of its own.
const COORDINATES: [&str; 3] = ["x_mm", "y_mm", "z_mm"];

/// Puts 0 for what is nothing against its size.
fn cleared(part: &mut Map<String, Value>, sizes: &Sizes) {
    let far = COORDINATES.iter().filter_map(|key| part.get(*key)?.as_f64()).map(f64::abs).fold(0.0, f64::max);
    for (key, value) in part.iter_mut() {
        if COORDINATES.contains(&key.as_str()) {
            clear(value, NOWHERE * far);
        } else if let Some(fields) = value.as_object_mut() {
            match key.as_str() {
                "feed" | "multipliers" => clear_motion(fields, sizes.length),
                _ => cleared(fields, sizes),
            }
        } else if let Some(items) = value.as_array_mut() {
            let far = items.iter().filter_map(Value::as_f64).map(f64::abs).fold(0.0, f64::max);
            let least = if key.ends_with("_at_mm") { NOWHERE * far } else { 0.0 };
            items.iter_mut().for_each(|item| clear(item, least));
            items.iter_mut().filter_map(Value::as_object_mut).for_each(|item| cleared(item, sizes));
        } else if key.ends_with("_N") {
            clear(value, NOTHING * sizes.force);
        } else if key.ends_with("_Nmm") && (key.contains("moment") || key.contains("torque")) {
            // What else has this unit is an energy.
            clear(value, NOTHING * sizes.force * sizes.length);
        }
    }
}

/// Puts 0 for the parts of a rigid motion that move no point of the surface against the others, or of what belongs to them.
fn clear_motion(motion: &mut Map<String, Value>, length: f64) {
    let size = |key: &str| motion.get(key).and_then(Value::as_f64).map_or(0.0, f64::abs);
    let shift = size("force").max(size("side_force"));
    let fastest = shift.max(length * size("moment").max(size("moment_y")));
    for (key, value) in motion.iter_mut() {
        let arm = if key.starts_with("moment") { length } else { 1.0 };
        clear(value, NOTHING * fastest / arm);
    }
}

fn clear(number: &mut Value, least: f64) {
    if number.as_f64().is_some_and(|value| value != 0.0 && value.abs() < least) {
        *number = json!(0.0);
    }
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::without_round_off;

    #[test]
    fn what_is_nothing_against_the_forces_of_a_scene_is_0() {
        let summary = json!({
            "contact": { "force_N": 1000.0, "moment_Nmm": -6.144e-13, "ends_mm": [-0.081, 0.081], "approach_mm": 1e-12 },
            "reactions": { "body1.inner": { "x_N": -2.162e-11, "z_N": -1000.0, "moment_Nmm": 2e-6 } },
            "energy": { "body1_Nmm": 1e-12 },
            "pressure": {
                "p_max_MPa": 2.5, "p_min_MPa": 2.4, "p_max_at_mm": [150.0, 0.0, 2.697e-6],
                "limit_measure": [{ "x_mm": 3.0, "y_mm": 1e-15, "z_mm": 0.5, "force_N": 7.0 }],
                "feed": { "force": 1e-7, "side_force": 1e-20, "moment": -5.7e-24 },
            },
            "error": { "ends_mm": [1e-9] },
        });
        let shown = without_round_off(&summary);
        assert_eq!([&shown["contact"]["moment_Nmm"], &shown["reactions"]["body1.inner"]["x_N"]], [&json!(0.0), &json!(0.0)]);
        assert_eq!(shown["reactions"]["body1.inner"]["moment_Nmm"], 0.0, "1e-9 of 1000 N times 150 mm is more");
        assert_eq!(shown["pressure"]["p_max_at_mm"], json!([150.0, 0.0, 0.0]));
        assert_eq!(shown["pressure"]["limit_measure"][0], json!({ "x_mm": 3.0, "y_mm": 0.0, "z_mm": 0.5, "force_N": 7.0 }));
        assert_eq!(shown["pressure"]["feed"], json!({ "force": 1e-7, "side_force": 0.0, "moment": 0.0 }));
        for (part, key) in [("energy", "body1_Nmm"), ("contact", "approach_mm"), ("contact", "force_N"), ("error", "ends_mm")] {
            assert_eq!(shown[part][key], summary[part][key], "{part}.{key}");
        }
    }

    #[test]
    fn a_pressure_that_is_the_same_everywhere_has_no_largest_place() {
        let pressure =
            |least: f64| json!({ "pressure": { "p_max_MPa": 2.5, "p_min_MPa": least, "p_max_at_mm": [1.0, 0.0, 0.0] } });
        assert!(without_round_off(&pressure(2.499_999_999_999_8))["pressure"]["p_max_at_mm"].is_null());
        assert!(!without_round_off(&pressure(2.499))["pressure"]["p_max_at_mm"].is_null());
        assert_eq!(without_round_off(&json!(null)), json!(null));
    }
}
