//! The numbers and words of two summaries, key by key.

use std::collections::BTreeMap;

use serde_json::Value;

/// Values smaller than this part of their like are round-off.
const ROUND_OFF: f64 = 1e-9;

/// Parts of keys that tell how a result was found and how well, and not what it is.
const HOW: [&str; 17] = [
    "counters.",
    "error.",
    "iterations",
    "roundtrip",
    "complementarity",
    "residual",
    "lyapunov",
    "steps",
    "step_limit",
    "where",
    "_at_mm",
    "heat.balance",
    "interface.",
    "run_in_error",
    "because",
    "schema_version",
    "scene_sha256",
];
/// Keys that say in words what others say in numbers, or who says it.
const NAMES: [&str; 3] = ["verdict", "version", "scene"];

/// One key of both summaries.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Entry {
    /// Dotted key.
    pub(crate) key: String,
    /// Its value in both; none where it is absent.
    pub(crate) values: [Option<Value>; 2],
    /// Difference of two numbers, relative to the larger; to the largest of their like where both are round-off.
    pub(crate) relative: Option<f64>,
    /// Whether it is a result, and counts.
    pub(crate) result: bool,
}

impl Entry {
    /// Whether the values are not the same.
    pub(crate) fn differs(&self) -> bool {
        self.values[0] != self.values[1]
    }

    /// Whether a result differs by more than a tolerance.
    pub(crate) fn counts(&self, tolerance: f64) -> bool {
        self.result && self.differs() && self.relative.is_none_or(|relative| relative > tolerance)
    }
}

/// All keys of two summaries, those of the first in its order, then those of the second alone.
pub(crate) fn compare(summaries: [&Value; 2]) -> Vec<Entry> {
    let both = summaries.map(|summary| {
        let mut found = Vec::new();
        flatten("", summary, &mut found);
        found
    });
    let maps = both.each_ref().map(|found| found.iter().cloned().collect::<BTreeMap<String, Value>>());
    let mut keys: Vec<&String> = both[0].iter().map(|(key, _)| key).collect();
    keys.extend(both[1].iter().map(|(key, _)| key).filter(|key| !maps[0].contains_key(*key)));
    let entry = |key: &String| {
        let values = maps.each_ref().map(|map| map.get(key).cloned());
        let numbers = values.each_ref().map(|value| value.as_ref().and_then(Value::as_f64));
        let relative = numbers[0].zip(numbers[1]).map(|(a, b)| relative(a, b, like(key, &both)));
        let result = !HOW.iter().any(|part| key.contains(part)) && !NAMES.contains(&key.as_str());
        Entry { key: key.clone(), values, relative, result }
    };
    keys.into_iter().map(entry).collect()
}

fn relative(a: f64, b: f64, like: f64) -> f64 {
    let size = a.abs().max(b.abs());
    let size = if size < ROUND_OFF * like { like } else { size };
    if a == b { 0.0 } else { (a - b).abs() / size }
}

/// The largest number of the same part and unit, in either summary; of a moment also the largest force times one mm.
fn like(key: &str, both: &[Vec<(String, Value)>; 2]) -> f64 {
    let part = |key: &str| key.split('.').next().unwrap_or("").to_string();
    let unit =
        |key: &str| key.trim_end_matches(|c: char| c == '.' || c.is_ascii_digit()).rsplit('_').next().unwrap_or("").to_string();
    let alike = |other: &str| part(other) == part(key) && (unit(other) == unit(key) || unit(key) == "Nmm" && unit(other) == "N");
    let all = both.iter().flatten().filter(|(other, _)| alike(other));
    all.filter_map(|(_, value)| value.as_f64()).fold(0.0, |largest, value| largest.max(value.abs()))
}

/// Numbers and words under dotted keys, and lists of numbers, item by item.
fn flatten(prefix: &str, value: &Value, found: &mut Vec<(String, Value)>) {
    match value {
        Value::Object(map) => {
            for (key, value) in map {
                let path = if prefix.is_empty() { key.clone() } else { format!("{prefix}.{key}") };
                flatten(&path, value, found);
            }
        }
        Value::Array(items) => {
            let numbers = items.iter().enumerate().filter(|(_, item)| item.is_number());
            found.extend(numbers.map(|(place, item)| (format!("{prefix}.{place}"), item.clone())));
        }
        other => found.push((prefix.to_string(), other.clone())),
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use serde_json::json;

    #[test]
    fn differences_are_relative_and_round_off_beside_its_like_is_none() {
        let a = json!({ "pressure": { "force_N": 1e4, "moment_Nmm": 1e-11, "p_max_MPa": 5.0 }, "counters": { "dofs": 10 } });
        let b = json!({ "pressure": { "force_N": 1e4, "moment_Nmm": -2e-11, "p_max_MPa": 5.5 }, "counters": { "dofs": 20 } });
        let found = compare([&a, &b]);
        let of = |key: &str| found.iter().find(|entry| entry.key == key).unwrap().clone();
        assert!(of("pressure.moment_Nmm").relative.unwrap() < 1e-14 && !of("pressure.force_N").differs());
        assert!((of("pressure.p_max_MPa").relative.unwrap() - 0.5 / 5.5).abs() < 1e-15);
        assert!(of("pressure.p_max_MPa").counts(0.05) && !of("pressure.p_max_MPa").counts(0.1));
        assert!(of("counters.dofs").differs() && !of("counters.dofs").counts(0.0));
    }

    #[test]
    fn how_a_result_was_found_does_not_count_and_what_was_asked_for_does() {
        let of = |x: f64| {
            json!({ "heat": { "balance": x, "T_max1_at_mm": [x, 0.0], "T_max1_degC": x }, "interface": { "condition": x },
                    "wear": { "run_in_error": x, "turns": { "because": x.to_string() } }, "pressure": { "balance": x.to_string() } })
        };
        let found = compare([&of(1.0), &of(2.0)]);
        let counting: Vec<&str> = found.iter().filter(|entry| entry.counts(1e-3)).map(|entry| entry.key.as_str()).collect();
        assert_eq!(counting, ["heat.T_max1_degC", "pressure.balance"]);
    }

    #[test]
    fn words_and_absent_keys_differ_and_count() {
        let found = compare([&json!({ "status": "ok", "shape": { "gap_max_um": 1.0 } }), &json!({ "status": "refused" })]);
        assert!(found.iter().all(|entry| entry.counts(1.0)) && found.len() == 2, "{found:?}");
    }
}
