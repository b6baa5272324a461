//! Rows "the paper says, we get", as table, CSV and JSON.

use serde_json::{Map, Value, json};

/// One number of an item, beside what it is to be compared with.
#[derive(Debug, Clone, Default, PartialEq)]
pub(crate) struct Row {
    /// What it is.
    pub(crate) quantity: String,
    /// Its unit; empty for a pure number.
    pub(crate) unit: &'static str,
    /// What the paper's text states, and where.
    pub(crate) paper: Option<(f64, &'static str)>,
    /// Value of the paper's formula as printed, where that is in error.
    pub(crate) printed: Option<f64>,
    /// Value of a closed form, or of another way to the same number.
    pub(crate) reference: Option<f64>,
    /// What the program computes.
    pub(crate) ours: f64,
    /// A word on the comparison.
    pub(crate) note: String,
}

impl Row {
    /// Difference from what the paper states, else from the reference: relative, or absolute where that is zero.
    pub(crate) fn difference(&self) -> Option<f64> {
        let other = self.paper.map(|said| said.0).or(self.reference)?;
        let size = if other == 0.0 { 1.0 } else { other.abs() };
        Some((self.ours - other) / size)
    }

    fn cells(&self) -> [String; 8] {
        let number = |value: Option<f64>| value.map(digits).unwrap_or_default();
        [
            self.quantity.clone(),
            self.unit.to_string(),
            number(self.paper.map(|said| said.0)),
            self.paper.map(|said| said.1.to_string()).unwrap_or_default(),
            number(self.printed),
            number(self.reference),
            digits(self.ours),
            self.difference().map(share).unwrap_or_default(),
        ]
    }
}

/// Headings of a table of rows, without the note.
const HEADINGS: [&str; 8] =
    ["quantity", "unit", "paper says", "where", "formula as printed", "independent value", "we get", "difference"];

/// Five digits: what is the same on every machine.
fn digits(value: f64) -> String {
    if value != 0.0 && value.abs() < 1e-9 {
        return "< 1e-9".into();
    }
    if value == 0.0 || !value.is_finite() {
        return format!("{value}");
    }
    let magnitude = value.abs().log10().floor() as i32;
    if !(-4..7).contains(&magnitude) {
        return format!("{value:.3e}");
    }
    scene::short(value)
}

/// A difference: round-off is no number to print.
fn share(difference: f64) -> String {
    let size = difference.abs();
    match size {
        _ if size < 1e-9 => "< 1e-9".into(),
        _ if size < 1e-3 => format!("{difference:.0e}"),
        _ => format!("{:+.2} %", 100.0 * difference),
    }
}

/// The rows as a table for the terminal; notes stand under their rows.
pub(crate) fn rows_table(rows: &[Row]) -> String {
    let lines: Vec<[String; 8]> = rows.iter().map(Row::cells).collect();
    let used = |column: usize| lines.iter().any(|line| !line[column].is_empty());
    let columns: Vec<usize> = (0..8).filter(|column| used(*column)).collect();
    let width =
        |column: usize| lines.iter().map(|line| line[column].chars().count()).chain([HEADINGS[column].len()]).max().unwrap_or(0);
    let line = |cells: &[String; 8]| {
        let text: Vec<String> = columns
            .iter()
            .map(|column| match column {
                0 | 1 | 3 => format!("{:<1$}", cells[*column], width(*column)),
                _ => format!("{:>1$}", cells[*column], width(*column)),
            })
            .collect();
        text.join("  ").trim_end().to_string() + "\n"
    };
    let mut out = line(&HEADINGS.map(str::to_string));
    for (cells, row) in lines.iter().zip(rows) {
        out += &line(cells);
        if !row.note.is_empty() {
            out += &format!("      {}\n", row.note);
        }
    }
    out
}

/// The rows as a table in Markdown.
pub(crate) fn rows_markdown(rows: &[Row]) -> String {
    let lines: Vec<[String; 8]> = rows.iter().map(Row::cells).collect();
    let columns: Vec<usize> = (0..8).filter(|column| lines.iter().any(|line| !line[*column].is_empty())).collect();
    let noted = rows.iter().any(|row| !row.note.is_empty());
    let line = |cells: &[String; 8], note: &str| {
        let mut all: Vec<&str> = columns.iter().map(|column| cells[*column].as_str()).collect();
        all.extend(noted.then_some(note));
        let all: Vec<String> = all.iter().map(|text| text.replace('|', "\\|")).collect();
        format!("| {} |\n", all.join(" | "))
    };
    let mut out = line(&HEADINGS.map(str::to_string), "note");
    out += &line(&HEADINGS.map(|_| "---".to_string()), "---");
    for (cells, row) in lines.iter().zip(rows) {
        out += &line(cells, &row.note);
    }
    out
}

/// The rows as CSV with all digits.
pub(crate) fn rows_csv(rows: &[(&str, &Row)]) -> String {
    let number = |value: Option<f64>| value.map(scene::number_text).unwrap_or_default();
    let names = ["item", "quantity", "unit", "paper", "where", "printed", "reference", "ours", "difference", "note"];
    let cells = |(item, row): &(&str, &Row)| {
        vec![
            (*item).to_string(),
            row.quantity.clone(),
            row.unit.to_string(),
            number(row.paper.map(|said| said.0)),
            row.paper.map_or("", |said| said.1).to_string(),
            number(row.printed),
            number(row.reference),
            number(Some(row.ours)),
            number(row.difference()),
            row.note.clone(),
        ]
    };
    report::table(&names, rows.iter().map(cells))
}

/// The rows as JSON; what is not there is an absent key.
pub(crate) fn rows_json(rows: &[Row]) -> Value {
    let object = |row: &Row| -> Value {
        let mut map = Map::new();
        map.insert("quantity".into(), json!(row.quantity));
        map.insert("unit".into(), json!(row.unit));
        let numbers = [
            ("paper", row.paper.map(|said| said.0)),
            ("printed", row.printed),
            ("reference", row.reference),
            ("ours", Some(row.ours)),
            ("difference", row.difference()),
        ];
        for (key, value) in numbers {
            if let Some(value) = value.filter(|value| value.is_finite()) {
                map.insert(key.into(), json!(value));
            }
        }
        if let Some((_, place)) = row.paper {
            map.insert("where".into(), json!(place));
        }
        if !row.note.is_empty() {
            map.insert("note".into(), json!(row.note));
        }
        Value::Object(map)
    };
    rows.iter().map(object).collect()
}
