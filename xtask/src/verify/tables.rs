//! The files that runs and scripts leave behind: CSV and JSON.

use serde_json::Value;
use std::fs;
use std::path::Path;

/// A table of numbers; what is no number is NaN.
pub(crate) struct Csv {
    names: Vec<String>,
    columns: Vec<Vec<f64>>,
}

impl Csv {
    pub(crate) fn column(&self, name: &str) -> Result<&[f64], String> {
        let at = self.names.iter().position(|known| known == name.trim());
        let at = at.ok_or(format!("contact.csv has no column {name}; it has {}", self.names.join(", ")))?;
        Ok(&self.columns[at])
    }
}

pub(crate) fn read_csv(path: &Path) -> Result<Csv, String> {
    let text = fs::read_to_string(path).map_err(|error| format!("{}: {error}", path.display()))?;
    parse_csv(&text).map_err(|message| format!("{}: {message}", path.display()))
}

fn parse_csv(text: &str) -> Result<Csv, String> {
    let mut lines = text.lines();
    let names: Vec<String> = lines.next().ok_or("empty")?.split(',').map(|name| name.trim().to_string()).collect();
    let mut columns = vec![Vec::new(); names.len()];
    for (number, line) in lines.enumerate() {
        let cells: Vec<&str> = line.split(',').collect();
        if cells.len() != names.len() {
            return Err(format!("line {}: {} cells, {} names", number + 2, cells.len(), names.len()));
        }
        for (column, cell) in columns.iter_mut().zip(cells) {
            column.push(cell.trim().parse().unwrap_or(f64::NAN));
        }
    }
    Ok(Csv { names, columns })
}

/// A JSON file.
pub(crate) fn read_json(path: &Path) -> Result<Value, String> {
    let text = fs::read_to_string(path).map_err(|error| format!("{}: {error}", path.display()))?;
    serde_json::from_str(&text).map_err(|error| format!("{}: {error}", path.display()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_csv_line_with_a_cell_too_few_is_named() {
        assert!(parse_csv("a,b\n1,2\n3\n").is_err_and(|e| e.contains("line 3")));
        assert!(parse_csv("a,b\n1,nan\n").is_ok_and(|csv| csv.column("b").is_ok_and(|b| b[0].is_nan())));
    }
}
