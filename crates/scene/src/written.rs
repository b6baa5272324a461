//! The values of a scene as they are written, and the text with others in their place: comments, order and units stay.

use std::ops::Range;

use crate::document::syntax;
use crate::fault::Fault;
use crate::tree::{self, Node, Origin, Value};

/// A value of a text.
#[derive(Debug, Clone, PartialEq)]
pub struct Written {
    /// Dotted key; a place of a list is a number from 0.
    pub key: String,
    /// The value as TOML, with its unit where it has one.
    pub text: String,
    /// Line number from 1.
    pub line: usize,
}

/// All numbers, texts and switches of a scene's text, in their order.
///
/// # Errors
/// Text that is not TOML, with its place.
pub fn written(file: &str, text: &str) -> Result<Vec<Written>, Fault> {
    let tree = tree::parse(text).map_err(|(message, span)| syntax(file, text, &message, span))?;
    let mut found = Vec::new();
    collect(&tree, String::new(), text, &mut found);
    found.sort_unstable_by_key(|(start, _)| *start);
    Ok(found.into_iter().map(|(_, value)| value).collect())
}

fn collect(node: &Node, key: String, text: &str, found: &mut Vec<(usize, Written)>) {
    let below = |name: &str| if key.is_empty() { name.to_string() } else { format!("{key}.{name}") };
    match &node.value {
        Value::Table(entries) => entries.iter().for_each(|entry| collect(&entry.node, below(&entry.key), text, found)),
        Value::List(items) => {
            items.iter().enumerate().for_each(|(place, item)| collect(item, below(&place.to_string()), text, found));
        }
        Value::Bool(_) | Value::Integer(_) | Value::Float(_) | Value::Text(_) => {
            if let Some((start, written)) = span(node).and_then(|span| Some((span.start, text.get(span)?))) {
                let line = text[..start].matches('\n').count() + 1;
                found.push((start, Written { key, text: written.to_string(), line }));
            }
        }
    }
}

fn span(node: &Node) -> Option<Range<usize>> {
    match &node.origin {
        Origin::File(span) => Some(span.clone()),
        Origin::Flag(_) => None,
    }
}

/// A scene's text with another value, as TOML, under a dotted key: in the place of the one that is written, else in the table that it belongs to.
///
/// # Errors
/// Text that is not TOML, or a key or value that cannot be written into it.
pub fn rewritten(text: &str, key: &str, value: &str) -> Result<String, Fault> {
    let tree = tree::parse(text).map_err(|(message, span)| syntax("scene", text, &message, span))?;
    let changed = match tree.find(key) {
        Some(node) => in_place(node, text, value),
        None => added(&tree, text, key, value),
    };
    let changed = changed.filter(|changed| tree::parse(changed).is_ok_and(|tree| tree.find(key).is_some()));
    changed.ok_or_else(|| {
        Fault::at(key, "cannot-write", format!("{key} = {value} cannot be written into the scene"), "write it into the text")
    })
}

fn in_place(node: &Node, text: &str, value: &str) -> Option<String> {
    let span = span(node)?;
    let written = text.get(span.clone())?;
    let spread = matches!(node.value, Value::Table(_)) && !written.starts_with('{');
    (!spread).then(|| [&text[..span.start], value, &text[span.end..]].concat())
}

/// A key that is not there yet: within the braces of its table, below its heading, or before the first heading.
fn added(tree: &Node, text: &str, key: &str, value: &str) -> Option<String> {
    let parts: Vec<&str> = key.split('.').collect();
    for depth in (1..parts.len()).rev() {
        let (table, rest) = (parts[..depth].join("."), parts[depth..].join("."));
        let braces =
            tree.find(&table).and_then(span).filter(|span| text.get(span.clone()).is_some_and(|text| text.starts_with('{')));
        if let Some(braces) = braces {
            let inside = text.get(braces.start + 1..braces.end - 1)?.trim_end();
            let comma = if inside.is_empty() { " " } else { ", " };
            let end = braces.start + 1 + inside.len();
            return Some(format!("{}{comma}{rest} = {value} {}", &text[..end], &text[braces.end - 1..]));
        }
        if let Some(end) = heading(text, |name| name == table) {
            return Some(format!("{}{rest} = {value}\n{}", &text[..end.end], &text[end.end..]));
        }
    }
    let start = heading(text, |_| true).map_or(text.len(), |heading| heading.start);
    let (before, after) = text.split_at(start);
    let end = if before.is_empty() || before.ends_with('\n') { "" } else { "\n" };
    Some(format!("{before}{end}{key} = {value}\n{after}"))
}

/// The line of the first heading with a name.
fn heading(text: &str, is_it: impl Fn(&str) -> bool) -> Option<Range<usize>> {
    let mut start = 0;
    for line in text.split_inclusive('\n') {
        let name = line.trim_start().strip_prefix('[').and_then(|line| line.split_once(']'));
        if name.is_some_and(|(name, _)| !name.starts_with('[') && is_it(name.trim())) {
            return Some(start..start + line.len());
        }
        start += line.len();
    }
    None
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use crate::builtin::SCENES;

    #[test]
    fn values_stand_as_they_were_written() {
        let text = "a = 1e-6 # c\nb.x = { y = \"30 deg\", z = [2.0, true] }\n[t]\nlist = [[1, 2]]\n";
        let found: Vec<_> = written("s", text).unwrap().into_iter().map(|v| (v.key, v.text, v.line)).collect();
        let says = |key: &str, text: &str, line| (key.to_string(), text.to_string(), line);
        let wanted = [
            says("a", "1e-6", 1),
            says("b.x.y", "\"30 deg\"", 2),
            says("b.x.z.0", "2.0", 2),
            says("b.x.z.1", "true", 2),
            says("t.list.0.0", "1", 4),
            says("t.list.0.1", "2", 4),
        ];
        assert_eq!(found, wanted);
        assert!(written("s", "a = = 1").unwrap_err().place.is_some());
    }

    #[test]
    fn a_value_is_replaced_and_nothing_else() {
        let text = "a = 1   # kept\nb = { c = \"1 kN\", d = [1, 2] }\n";
        assert_eq!(rewritten(text, "b.c", "\"2 kN\"").unwrap(), "a = 1   # kept\nb = { c = \"2 kN\", d = [1, 2] }\n");
        assert_eq!(rewritten(text, "b.d.1", "-3.5").unwrap(), "a = 1   # kept\nb = { c = \"1 kN\", d = [1, -3.5] }\n");
        assert_eq!(rewritten(text, "b.d", "[]").unwrap(), "a = 1   # kept\nb = { c = \"1 kN\", d = [] }\n");
        assert_eq!(rewritten(text, "b", "\"word\"").unwrap(), "a = 1   # kept\nb = \"word\"\n");
    }

    #[test]
    fn a_new_key_joins_its_table() {
        assert_eq!(rewritten("b = { c = 1 }\n", "b.d", "2").unwrap(), "b = { c = 1, d = 2 }\n");
        assert_eq!(rewritten("b = {}\n", "b.d.e", "2").unwrap(), "b = { d.e = 2 }\n");
        assert_eq!(rewritten("a = 1\n[b] # h\nc = 1\n[d]\n", "b.x.y", "2").unwrap(), "a = 1\n[b] # h\nx.y = 2\nc = 1\n[d]\n");
        assert_eq!(rewritten("a = 1\n[d]\nc = 1\n", "b.x", "2").unwrap(), "a = 1\nb.x = 2\n[d]\nc = 1\n");
        assert_eq!(rewritten("a = 1", "b", "2").unwrap(), "a = 1\nb = 2\n");
    }

    #[test]
    fn what_would_not_be_toml_is_refused() {
        for (key, value) in [("a", "1 2"), ("a.b", "1"), ("c", "{"), ("t", "1")] {
            assert_eq!(rewritten("a = 1\n[t]\nx = 1\n", key, value).unwrap_err().code, "cannot-write", "{key} = {value}");
        }
    }

    #[test]
    fn every_value_of_every_scene_can_be_written_again() {
        for scene in &SCENES {
            for value in written(scene.name, scene.text).unwrap() {
                assert_eq!(rewritten(scene.text, &value.key, &value.text).unwrap(), scene.text, "{}: {}", scene.name, value.key);
            }
        }
    }
}
