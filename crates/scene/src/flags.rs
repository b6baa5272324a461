//! `--set key=value`: one key of the scene replaced from the command line.

use crate::fault::{Fault, Place};
use crate::tree::{self, Entry, Node, Origin, Value};

/// Keys that exclude each other: setting one removes the others of its row. `*` stands for any one key.
const ALTERNATIVES: [&[&str]; 28] = [
    &["accuracy", "mesh"],
    &["load.force", "load.approach"],
    &["load.moment", "load.tilt"],
    &["load.twist", "load.torque"],
    &["wear.beta", "wear.k", "wear.table", "wear.law"],
    &["wear.a", "wear.table"],
    &["wear.b", "wear.table"],
    &["wear.threshold", "wear.table"],
    &["wear.a", "wear.law"],
    &["wear.b", "wear.law"],
    &["wear.threshold", "wear.law"],
    &["wear.law.*"],
    &["heat.share", "heat.conductance"],
    &["body1.heat.*.temperature", "body1.heat.*.convection", "body1.heat.*.flux"],
    &["body2.heat.*.temperature", "body2.heat.*.convection", "body2.heat.*.flux"],
    &["body1.heat.*.ambient", "body1.heat.*.temperature"],
    &["body2.heat.*.ambient", "body2.heat.*.temperature"],
    &["body1.heat.*.ambient", "body1.heat.*.flux"],
    &["body2.heat.*.ambient", "body2.heat.*.flux"],
    &["sliding.omega", "sliding.speed"],
    &["body1.geometry.*"],
    &["body2.geometry.*"],
    &["body1.support.*.pin", "body1.support.*.roller"],
    &["body2.support.*.pin", "body2.support.*.roller"],
    &["surface.*"],
    &["wear.until.*"],
    &["body1", "surface"],
    &["body2", "surface"],
];

/// The longest `--set`, bytes, and the deepest: parts of its key, and lists and tables within each other in its value.
const LONGEST: usize = 100_000;
const DEEPEST: usize = 64;

/// Applies the `--set` options, in their order, to the tree of the scene.
pub(crate) fn apply(tree: &mut Node, settings: &[String]) -> Result<(), Fault> {
    for (number, setting) in settings.iter().enumerate() {
        let wrong = |message: String, remedy: &str| Fault {
            place: Some(Place::Flag(format!("--set {setting}"))),
            ..Fault::new("wrong-flag", message, remedy)
        };
        if setting.len() > LONGEST {
            return Err(too_much(setting, format!("is {} bytes long, of at most {LONGEST}", setting.len())));
        }
        let form = "write --set key=value, as in --set contact.friction=0.1";
        let Some((key, text)) = setting.split_once('=') else {
            return Err(wrong(format!("--set {setting} has no `=`"), form));
        };
        let key = key.trim();
        if key.is_empty() || key.split('.').any(|part| part.trim().is_empty()) {
            return Err(wrong(format!("--set {setting}: the key is empty or has an empty part"), form));
        }
        let path: Vec<&str> = key.split('.').map(|part| part.trim().trim_matches('"')).collect();
        let depth = depth(text).max(path.len());
        if depth > DEEPEST {
            return Err(too_much(setting, format!("is nested {depth} deep, of at most {DEEPEST}")));
        }
        let mut value = value_of(text.trim());
        mark(&mut value, number);
        displace(tree, &path);
        open(tree, &path, number);
        put(tree, &path, Node { value, origin: Origin::Flag(number) }, number).map_err(|(parent, what)| {
            wrong(format!("--set {setting}: `{parent}` is {what}"), &format!("set `{parent}` itself, or a key that exists"))
        })?;
    }
    Ok(())
}

/// A setting beyond a bound, of which only the beginning is shown.
fn too_much(setting: &str, what: String) -> Fault {
    let start: String = setting.chars().take(40).collect();
    Fault {
        place: Some(Place::Flag(format!("--set {start}..."))),
        ..Fault::new("wrong-flag", format!("--set {start}... {what}"), "write it into the scene file")
    }
}

/// How deep lists and tables lie within each other at most, as the brackets outside of quotes say.
fn depth(text: &str) -> usize {
    let (mut deepest, mut depth, mut quote) = (0_usize, 0_usize, None);
    for c in text.chars() {
        match (quote, c) {
            (Some(open), _) => quote = Some(open).filter(|open| *open != c),
            (None, '"' | '\'') => quote = Some(c),
            (None, '[' | '{') => depth += 1,
            (None, ']' | '}') => depth = depth.saturating_sub(1),
            _ => {}
        }
        deepest = deepest.max(depth);
    }
    deepest
}

/// The value of a `--set`: TOML; else a number that begins with a point; else a list or table with bare words; else text.
pub(crate) fn value_of(text: &str) -> Value {
    if let Some(value) = tree::parse_value(text) {
        return value;
    }
    if let Some(number) = number_of(text) {
        return Value::Float(number);
    }
    if text.starts_with(['[', '{']) {
        let mut rest = text;
        if let Some(value) = loose(&mut rest)
            && rest.trim().is_empty()
        {
            return value;
        }
    }
    Value::Text(text.to_string())
}

fn number_of(text: &str) -> Option<f64> {
    let first = text.trim_start_matches(['+', '-']).chars().next()?;
    if first.is_ascii_digit() || first == '.' { text.parse().ok() } else { None }
}

/// A list or table in which words need no quotes: `[pressure, shape]`, `{ left = [x] }`.
fn loose(rest: &mut &str) -> Option<Value> {
    let node = |value| Node { value, origin: Origin::Flag(0) };
    *rest = rest.trim_start();
    if let Some(inner) = rest.strip_prefix('[') {
        *rest = inner;
        let mut items = Vec::new();
        loop {
            *rest = rest.trim_start();
            if let Some(after) = rest.strip_prefix(']') {
                *rest = after;
                return Some(Value::List(items));
            }
            items.push(node(loose(rest)?));
            *rest = rest.trim_start();
            *rest = rest.strip_prefix(',').unwrap_or(rest);
            if rest.is_empty() {
                return None;
            }
        }
    }
    if let Some(inner) = rest.strip_prefix('{') {
        *rest = inner;
        let mut entries = Vec::new();
        loop {
            *rest = rest.trim_start();
            if let Some(after) = rest.strip_prefix('}') {
                *rest = after;
                return Some(Value::Table(entries));
            }
            let (key, after) = rest.split_once('=')?;
            *rest = after;
            let key = key.trim().trim_matches('"').to_string();
            entries.push(Entry { key, origin: Origin::Flag(0), node: node(loose(rest)?) });
            *rest = rest.trim_start();
            *rest = rest.strip_prefix(',').unwrap_or(rest);
            if rest.is_empty() {
                return None;
            }
        }
    }
    let end = match rest.chars().next()? {
        quote @ ('"' | '\'') => rest[1..].find(quote)? + 2,
        _ => rest.find([',', ']', '}']).unwrap_or(rest.len()),
    };
    let (word, after) = rest.split_at(end);
    *rest = after;
    let word = word.trim();
    Some(tree::parse_value(word).or_else(|| number_of(word).map(Value::Float)).unwrap_or_else(|| Value::Text(word.to_string())))
}

fn mark(value: &mut Value, number: usize) {
    match value {
        Value::List(items) => items.iter_mut().for_each(|node| {
            node.origin = Origin::Flag(number);
            mark(&mut node.value, number);
        }),
        Value::Table(entries) => entries.iter_mut().for_each(|entry| {
            entry.origin = Origin::Flag(number);
            entry.node.origin = Origin::Flag(number);
            mark(&mut entry.node.value, number);
        }),
        _ => {}
    }
}

/// Removes the alternatives of the key that is about to be set.
fn displace(tree: &mut Node, path: &[&str]) {
    for row in ALTERNATIVES {
        for pattern in row {
            let parts: Vec<&str> = pattern.split('.').collect();
            let hit = path.len() >= parts.len() && parts.iter().zip(path).all(|(p, k)| *p == "*" || p == k);
            if !hit {
                continue;
            }
            if parts.last() == Some(&"*") {
                let keep = path[parts.len() - 1];
                retain(tree, &path[..parts.len() - 1], |key| key == keep);
            }
            for other in row.iter().filter(|other| *other != pattern) {
                // A `*` of the other key is what stands there in the path.
                let other = other.split('.').enumerate();
                let other: Vec<&str> = other.map(|(depth, key)| if key == "*" { path[depth] } else { key }).collect();
                let (last, parents) = other.split_last().unwrap_or((&"", &[]));
                retain(tree, parents, |key| key != *last);
            }
        }
    }
}

/// Makes a table of a value whose short form stands where the path goes deeper: a number as gap or a time as end gives way, the file of a gap
/// becomes its term `profile`.
fn open(tree: &mut Node, path: &[&str], number: usize) {
    let (["contact", "gap", _, ..] | ["wear", "until", _, ..]) = path else { return };
    let Some(node) = tree.at_mut(&path[..2]) else { return };
    let entries = match std::mem::replace(&mut node.value, Value::Table(Vec::new())) {
        Value::Table(entries) => entries,
        file @ Value::Text(_) if path[1] == "gap" => {
            let origin = node.origin.clone();
            vec![Entry { key: "profile".to_string(), origin: origin.clone(), node: Node { value: file, origin } }]
        }
        _ => {
            node.origin = Origin::Flag(number);
            Vec::new()
        }
    };
    node.value = Value::Table(entries);
}

fn retain(tree: &mut Node, parents: &[&str], keep: impl Fn(&str) -> bool) {
    let Some(node) = tree.at_mut(parents) else { return };
    if let Value::Table(entries) = &mut node.value {
        entries.retain(|entry| keep(&entry.key));
    }
}

/// Puts a node under a path, making tables on the way. An error names the parent that has no such place, and says what it is.
fn put(tree: &mut Node, path: &[&str], node: Node, number: usize) -> Result<(), (String, String)> {
    let mut at = tree;
    for (depth, key) in path.iter().enumerate() {
        let parent = path[..depth].join(".");
        at = match &mut at.value {
            Value::List(items) => {
                let what = match items.len() {
                    0 => "an empty list".to_string(),
                    long => format!("a list with the places 0 to {}", long - 1),
                };
                let item = key.parse::<usize>().ok().and_then(|place| items.get_mut(place));
                item.ok_or((parent, what))?
            }
            Value::Table(entries) => {
                let place = entries.iter().position(|entry| entry.key == *key).unwrap_or_else(|| {
                    let origin = Origin::Flag(number);
                    let empty = Node { value: Value::Table(Vec::new()), origin: origin.clone() };
                    entries.push(Entry { key: key.to_string(), origin, node: empty });
                    entries.len() - 1
                });
                if depth + 1 == path.len() {
                    entries[place].origin = Origin::Flag(number);
                }
                &mut entries[place].node
            }
            _ => return Err((parent, "a value, not a table".into())),
        };
    }
    *at = node;
    Ok(())
}
