//! The scene as a tree of values, each of which remembers where it was written.

use std::ops::Range;

use toml::de::{DeTable, DeValue};

/// Where a key or value was written.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Origin {
    /// Bytes of the scene file.
    File(Range<usize>),
    /// The n-th `--set` of the command line.
    Flag(usize),
}

/// A value and its place.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Node {
    /// The value.
    pub(crate) value: Value,
    /// Where it was written.
    pub(crate) origin: Origin,
}

/// A TOML value.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Value {
    /// true or false.
    Bool(bool),
    /// A whole number.
    Integer(i64),
    /// A number with a point, an exponent, or inf.
    Float(f64),
    /// Text.
    Text(String),
    /// A list.
    List(Vec<Node>),
    /// Keys with values, in the order of the file.
    Table(Vec<Entry>),
}

/// One key of a table.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Entry {
    /// The key, without quotes.
    pub(crate) key: String,
    /// Where the key was written.
    pub(crate) origin: Origin,
    /// Its value.
    pub(crate) node: Node,
}

impl Node {
    /// The child under a key, or at a place of a list.
    pub(crate) fn child(&self, key: &str) -> Option<&Node> {
        match &self.value {
            Value::Table(entries) => entries.iter().find(|e| e.key == key).map(|e| &e.node),
            Value::List(items) => key.parse::<usize>().ok().and_then(|at| items.get(at)),
            _ => None,
        }
    }

    /// The node under a path of tables.
    pub(crate) fn at_mut(&mut self, path: &[&str]) -> Option<&mut Node> {
        path.iter().try_fold(self, |node, key| match &mut node.value {
            Value::Table(entries) => entries.iter_mut().find(|entry| entry.key == *key).map(|entry| &mut entry.node),
            _ => None,
        })
    }

    /// The node under a dotted key.
    pub(crate) fn find(&self, dotted: &str) -> Option<&Node> {
        dotted.split('.').try_fold(self, |node, key| node.child(key))
    }

    /// Where a dotted key stands: its value, or the last of its parents that was written.
    pub(crate) fn place_of(&self, dotted: &str) -> Option<Origin> {
        let mut node = self;
        let mut origin = None;
        for key in dotted.split('.') {
            match &node.value {
                Value::Table(entries) => {
                    let Some(entry) = entries.iter().find(|e| e.key == key) else {
                        break;
                    };
                    let is_table = matches!(entry.node.value, Value::Table(_));
                    origin = Some(if is_table { entry.origin.clone() } else { entry.node.origin.clone() });
                    node = &entry.node;
                }
                _ => {
                    let Some(child) = node.child(key) else { break };
                    origin = Some(child.origin.clone());
                    node = child;
                }
            }
        }
        origin
    }
}

/// Reads TOML text. An error carries the parser's sentence and its place in the text.
pub(crate) fn parse(text: &str) -> Result<Node, (String, Range<usize>)> {
    let table = DeTable::parse(text).map_err(|error| {
        let span = error.span().unwrap_or(0..0);
        (error.message().trim_end().replace('\n', ", "), span)
    })?;
    let span = table.span();
    Ok(Node { value: table_value(table.get_ref())?, origin: Origin::File(span) })
}

fn table_value(table: &DeTable<'_>) -> Result<Value, (String, Range<usize>)> {
    let mut entries = Vec::new();
    for (key, value) in table.iter() {
        entries.push(Entry {
            key: key.get_ref().to_string(),
            origin: Origin::File(key.span()),
            node: Node { value: plain(value.get_ref(), value.span())?, origin: Origin::File(value.span()) },
        });
    }
    entries.sort_unstable_by_key(|entry| match &entry.origin {
        Origin::File(span) => span.start,
        Origin::Flag(_) => usize::MAX,
    });
    Ok(Value::Table(entries))
}

fn plain(value: &DeValue<'_>, span: Range<usize>) -> Result<Value, (String, Range<usize>)> {
    Ok(match value {
        DeValue::String(text) => Value::Text(text.to_string()),
        DeValue::Boolean(flag) => Value::Bool(*flag),
        DeValue::Integer(number) => {
            let parsed = i64::from_str_radix(number.as_str(), number.radix());
            Value::Integer(parsed.map_err(|_| (format!("the whole number {number} is too large"), span))?)
        }
        DeValue::Float(number) => {
            let parsed: f64 =
                number.as_str().parse().map_err(|_| (format!("the number {number} cannot be read"), span.clone()))?;
            if parsed.is_infinite() && !number.as_str().contains("inf") {
                return Err((format!("the number {number} is too large"), span));
            }
            Value::Float(parsed)
        }
        DeValue::Datetime(date) => Value::Text(date.to_string()),
        DeValue::Array(items) => {
            let mut list = Vec::new();
            for item in items.iter() {
                list.push(Node { value: plain(item.get_ref(), item.span())?, origin: Origin::File(item.span()) });
            }
            Value::List(list)
        }
        DeValue::Table(table) => table_value(table)?,
    })
}

/// Reads one TOML value, as on the right-hand side of a `--set`.
pub(crate) fn parse_value(text: &str) -> Option<Value> {
    let value = DeValue::parse(text).ok()?;
    match value.get_ref() {
        DeValue::Datetime(_) => None,
        other => plain(other, 0..text.len()).ok(),
    }
}
