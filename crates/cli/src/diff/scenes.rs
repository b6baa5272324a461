//! The keys of two scenes.

use std::collections::BTreeMap;

use toml::Value;

/// Keys whose values differ, as they are written; none where a key is absent.
pub(crate) fn compare(scenes: [&str; 2]) -> Vec<(String, [Option<String>; 2])> {
    let both = scenes.map(|text| {
        let mut found = BTreeMap::new();
        flatten("", &Value::Table(toml::from_str(text).unwrap_or_default()), &mut found);
        found
    });
    let mut keys: Vec<&String> = both.iter().flat_map(BTreeMap::keys).collect();
    keys.sort();
    keys.dedup();
    let values = |key: &String| both.each_ref().map(|scene| scene.get(key).cloned());
    keys.into_iter().map(|key| (key.clone(), values(key))).filter(|(_, [a, b])| a != b).collect()
}

fn flatten(prefix: &str, value: &Value, found: &mut BTreeMap<String, String>) {
    match value {
        Value::Table(table) => {
            for (key, value) in table {
                let path = if prefix.is_empty() { key.clone() } else { format!("{prefix}.{key}") };
                flatten(&path, value, found);
            }
        }
        other => {
            found.insert(prefix.to_string(), other.to_string());
        }
    }
}
