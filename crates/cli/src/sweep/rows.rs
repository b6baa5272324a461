//! The rows of a sweep: they stand in sweep.jsonl, one a line, and are never all in memory.

use std::collections::BTreeSet;
use std::fs::File;
use std::io::{BufRead, BufReader};
use std::path::Path;

use scene::Fault;
use serde_json::Value;

use crate::folder::Folder;
use crate::grid::Grid;
use crate::sweep::drawn::Drawn;

/// The rows as they come.
pub(crate) const ROWS: &str = "sweep.jsonl";
/// The rows as a table.
const TABLE: &str = "sweep.csv";
/// Rows that are looked at by a person.
pub(crate) const SHOWN: usize = 50;
/// Rows of the table that are written at once.
const BLOCK: usize = 1000;
/// Ending of the column of an axis in base units.
pub(crate) const BASE: &str = ".base";

/// What is known of the rows without holding them.
#[derive(Debug, Default)]
pub(crate) struct Rows {
    /// Number of rows.
    pub(crate) count: usize,
    /// Rows without an answer.
    pub(crate) failed: usize,
    /// Rows with an answer, be it less accurate than wanted.
    pub(crate) answered: usize,
    /// The points whose curves are drawn.
    pub(crate) drawn: Drawn,
    /// The first rows.
    pub(crate) first: Vec<Value>,
    /// All keys, in order of first appearance.
    columns: Vec<String>,
    known: BTreeSet<String>,
}

impl Rows {
    /// Takes note of the next row, of `all`; whether the curve of its point is to be kept.
    pub(crate) fn see(&mut self, row: &Value, all: usize) -> bool {
        for key in row.as_object().into_iter().flatten().map(|(key, _)| key) {
            if !self.known.contains(key) {
                self.known.insert(key.clone());
                self.columns.push(key.clone());
            }
        }
        let has_curve = !matches!(row["status"].as_str(), Some("invalid" | "refused"));
        let keep = has_curve && self.drawn.see(self.count, all);
        self.count += 1;
        self.answered += usize::from(matches!(row["status"].as_str(), Some("ok" | "accuracy-missed")));
        self.failed += usize::from(row["status"] != "ok");
        if self.first.len() < SHOWN {
            self.first.push(row.clone());
        }
        keep
    }

    /// Takes note of the finished rows of an interrupted sweep, up to the first that is torn or not of its point. Returns the bytes they have.
    pub(crate) fn see_finished(&mut self, file: &Path, grid: &Grid) -> u64 {
        let mut bytes = 0;
        for line in lines(file) {
            let row: Value = serde_json::from_str(&line).unwrap_or_default();
            let point = self.count;
            let of_its_point = || grid.at(point).iter().all(|(key, value)| row[key] == axis_value(value));
            if point >= grid.count || !line.ends_with('\n') || !row.is_object() || !of_its_point() {
                break;
            }
            self.see(&row, grid.count);
            bytes += line.len() as u64;
        }
        bytes
    }

    /// Writes sweep.csv from the rows in sweep.jsonl: the union of their keys, axes as they were typed.
    pub(crate) fn write_table(&self, folder: &Folder, grid: &Grid) -> Result<(), Fault> {
        folder.write(TABLE, "")?;
        let names: Vec<&str> = self.columns.iter().map(String::as_str).collect();
        let rows = folder.path().join(ROWS);
        let mut lines = lines(&rows).enumerate().peekable();
        let mut header = true;
        while header || lines.peek().is_some() {
            let block: Vec<Vec<String>> =
                lines.by_ref().take(BLOCK).map(|(point, line)| self.cells(&line, grid, point)).collect();
            let text = report::table(&names, block);
            let head = if header { 0 } else { text.find('\n').map_or(0, |end| end + 1) };
            folder.append(TABLE, &text[head..])?;
            header = false;
        }
        Ok(())
    }

    fn cells(&self, line: &str, grid: &Grid, point: usize) -> Vec<String> {
        let row: Value = serde_json::from_str(line).unwrap_or_default();
        let typed = grid.at(point);
        let cell = |key: &String| match typed.iter().find(|(axis, _)| axis == key) {
            Some((_, value)) => value.to_string(),
            None => text(row.get(key)),
        };
        self.columns.iter().map(cell).collect()
    }
}

/// A value of an axis in a row: a number where it is one, else the text as it was typed.
pub(crate) fn axis_value(typed: &str) -> Value {
    typed.parse::<f64>().ok().filter(|value| value.is_finite()).map_or_else(|| Value::from(typed), Value::from)
}

fn text(value: Option<&Value>) -> String {
    match value {
        None => String::new(),
        Some(Value::String(text)) => text.clone(),
        Some(Value::Number(number)) => number.as_f64().map(scene::number_text).unwrap_or_default(),
        Some(other) => other.to_string(),
    }
}

/// The lines of a file with their ends; none if there is no such file, up to the first that is no text.
pub(super) fn lines(file: &Path) -> impl Iterator<Item = String> + use<> {
    let mut reader = File::open(file).ok().map(BufReader::new);
    std::iter::from_fn(move || {
        let mut line = String::new();
        let length = reader.as_mut()?.read_line(&mut line).ok()?;
        (length > 0).then_some(line)
    })
}
