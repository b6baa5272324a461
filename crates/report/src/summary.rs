//! summary.json.

use serde::Serialize;
use serde_json::{Map, Value, json};
use wearshape::{Problem, Solution, Stage, Status};

use crate::json::SCHEMA_VERSION;
use crate::verdict::verdict;

/// The whole summary: absent stages and numbers that are not finite are absent keys.
pub fn summary(problem: &Problem, solution: &Solution) -> Value {
    let mut all = Map::new();
    let mut put = |key: &str, value: Value| {
        all.insert(key.to_string(), value);
    };
    put("schema_version", json!(SCHEMA_VERSION));
    put("version", json!(env!("CARGO_PKG_VERSION")));
    put("scene", json!(problem.name()));
    put("scene_sha256", json!(scene::sha256(problem.resolved())));
    put("status", value(&solution.status));
    put("verdict", json!(verdict(problem, solution)));
    put("stages", value(&stages(problem, solution)));
    put("counters", value(&solution.effort.counters));
    put("unused_keys", json!(problem.unused_keys()));
    put("lints", json!(problem.remarks().iter().chain(&solution.remarks).collect::<Vec<_>>()));
    put("pressure", value(&solution.pressure));
    put("machining", value(&solution.machining));
    put("reversing", value(&solution.reversing));
    put("contact", value(&solution.contact));
    put("shape", value(&solution.shape));
    put("wear", value(&solution.wear));
    put("energy", value(&solution.energy));
    if !solution.reactions.is_empty() {
        let reactions: Map<String, Value> =
            solution.reactions.iter().map(|(edge, reaction)| (edge.clone(), value(reaction))).collect();
        put("reactions", Value::Object(reactions));
    }
    put("heat", value(&solution.heat));
    put("brake", value(&solution.brake));
    put("error", value(&solution.error));
    put("interface", value(&solution.interface));
    without_nulls(Value::Object(all))
}

/// What was done and left out, as far as the run came.
fn stages(problem: &Problem, solution: &Solution) -> Vec<Stage> {
    let plan = problem.plan();
    let refused = solution.status == Status::Refused && solution.shape.is_some() && solution.machined.is_none();
    match (solution.without_pressure, refused) {
        (true, _) => plan.without_pressure(),
        (false, true) => plan.with_refused_shape(),
        (false, false) => plan.stages.clone(),
    }
}

fn value(part: &impl Serialize) -> Value {
    serde_json::to_value(part).unwrap_or_default()
}

/// Drops keys without a value: absent stages, and numbers that JSON cannot hold.
pub(crate) fn without_nulls(value: Value) -> Value {
    match value {
        Value::Object(map) => {
            let kept = map.into_iter().filter(|(_, value)| !value.is_null());
            Value::Object(kept.map(|(key, value)| (key, without_nulls(value))).collect())
        }
        Value::Array(items) => Value::Array(items.into_iter().filter(|item| !item.is_null()).map(without_nulls).collect()),
        other => other,
    }
}

/// The numbers and words of a summary under dotted keys, without lists.
pub fn numbers(summary: &Value) -> Vec<(String, Value)> {
    let mut out = Vec::new();
    flatten("", summary, 0, &mut out);
    out
}

/// Numbers in a list that still are columns of a row each.
const SHORT: usize = 4;

/// The numbers and words of a summary under dotted keys, and the numbers of lists of up to four, counted from 0: `contact.ends_mm.1`.
pub fn numbers_and_short_lists(summary: &Value) -> Vec<(String, Value)> {
    let mut out = Vec::new();
    flatten("", summary, SHORT, &mut out);
    out
}

/// Adds what a part of a summary holds; of lists those of numbers alone that are no longer than `short`.
fn flatten(prefix: &str, value: &Value, short: usize, out: &mut Vec<(String, Value)>) {
    match value {
        Value::Object(map) => {
            for (key, value) in map {
                let path = if prefix.is_empty() { key.clone() } else { format!("{prefix}.{key}") };
                flatten(&path, value, short, out);
            }
        }
        Value::Array(items) => {
            if items.len() <= short && items.iter().all(Value::is_number) {
                out.extend(items.iter().enumerate().map(|(place, item)| (format!("{prefix}.{place}"), item.clone())));
            }
        }
        other => out.push((prefix.to_string(), other.clone())),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn short_lists_of_numbers_are_numbers_by_their_place() {
        let summary =
            json!({ "a": { "b": [1, 2.5], "long": [1, 2, 3, 4, 5], "words": ["x"], "mixed": [1, "x"], "none": [] }, "c": 3 });
        let keys = |found: Vec<(String, Value)>| found.into_iter().map(|(key, _)| key).collect::<Vec<_>>();
        assert_eq!(keys(numbers(&summary)), ["c"]);
        assert_eq!(
            numbers_and_short_lists(&summary),
            [("a.b.0".into(), json!(1)), ("a.b.1".into(), json!(2.5)), ("c".into(), json!(3))]
        );
    }
}
