//! summary.json.

use serde::Serialize;
use serde_json::{Map, Value, json};
use wearshape::{Problem, Solution};

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
    let plan = problem.plan();
    put("stages", if solution.without_pressure { value(&plan.without_pressure()) } else { value(&plan.stages) });
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
    flatten("", summary, &mut out);
    out
}

fn flatten(prefix: &str, value: &Value, out: &mut Vec<(String, Value)>) {
    match value {
        Value::Object(map) => {
            for (key, value) in map {
                let path = if prefix.is_empty() { key.clone() } else { format!("{prefix}.{key}") };
                flatten(&path, value, out);
            }
        }
        Value::Array(_) => {}
        other => out.push((prefix.to_string(), other.clone())),
    }
}
