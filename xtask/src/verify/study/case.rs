//! The table of studies, read from verify/study.toml.

use super::super::case::text;
use std::fs;
use std::path::Path;
use toml::{Table, Value};

/// One answer by two programs.
pub(crate) struct Study {
    pub(crate) name: String,
    pub(crate) title: String,
    pub(crate) scene: String,
    /// Changes of the scene for everything.
    pub(crate) set: Vec<String>,
    /// Further changes for the truth.
    pub(crate) truth: Vec<String>,
    pub(crate) sample: i64,
    /// Column of contact.csv that is compared.
    pub(crate) column: String,
    /// Columns that a difference may contain freely.
    pub(crate) modes: Vec<String>,
    /// Share of the contact that counts.
    pub(crate) inner: f64,
    /// Errors at which the seconds are compared.
    pub(crate) factors: Vec<f64>,
    /// (error, factor) that must be reached.
    pub(crate) least: Vec<(f64, f64)>,
    pub(crate) curves: Vec<Curve>,
    /// The program measures the error of its levels itself.
    pub(crate) by_program: bool,
    pub(crate) theirs: String,
    /// Digits of the compared column that others found: the table `known`, if there is one.
    pub(crate) known: Option<Table>,
    /// Digits of summary.json that others found.
    pub(crate) numbers: Vec<Table>,
}

/// One ladder of ours.
pub(crate) struct Curve {
    pub(crate) name: String,
    /// Another scene with the same answer.
    pub(crate) scene: Option<String>,
    pub(crate) set: Vec<String>,
}

/// Reads the table; the message of an error names the study and the key.
pub(crate) fn read(path: &Path) -> Result<Vec<Study>, String> {
    let content = fs::read_to_string(path).map_err(|error| format!("{}: {error}", path.display()))?;
    let table: Table = content.parse().map_err(|error| format!("{}: {error}", path.display()))?;
    let cases = table.get("case").and_then(Value::as_array).ok_or(format!("{}: no [[case]]", path.display()))?;
    cases.iter().map(|value| study(value).map_err(|message| format!("{}: {message}", path.display()))).collect()
}

fn study(value: &Value) -> Result<Study, String> {
    let name = text(value, "name")?;
    let part = |key: &str| value.get(key).ok_or(format!("{name}: no [case.{key}]"));
    let (ours, theirs) = (part("ours")?, part("theirs")?);
    let curves = list(ours, "curves").iter().map(curve).collect::<Result<Vec<_>, _>>().map_err(|e| format!("{name}: {e}"))?;
    let factors: Vec<f64> = list(value, "factors").iter().filter_map(Value::as_float).collect();
    if curves.is_empty() || factors.is_empty() || list(theirs, "levels").is_empty() {
        return Err(format!("{name}: needs curves, levels and factors"));
    }
    let pair = |entry: &Value| Some((number(entry.get("error")?)?, number(entry.get("factor")?)?));
    Ok(Study {
        title: text(value, "title")?,
        scene: text(value, "scene")?,
        set: texts(value, "set"),
        truth: texts(value, "truth"),
        sample: value.get("sample").and_then(Value::as_integer).ok_or(format!("{name}: no sample"))?,
        column: text(value, "column")?,
        modes: texts(value, "modes"),
        inner: value.get("inner").and_then(number).unwrap_or(1.0),
        factors,
        least: list(value, "least").iter().filter_map(pair).collect(),
        curves,
        by_program: ours.get("error").and_then(Value::as_str) == Some("program"),
        theirs: text(theirs, "name")?,
        known: value.get("known").and_then(Value::as_table).cloned(),
        numbers: list(value, "numbers").iter().filter_map(Value::as_table).cloned().collect(),
        name,
    })
}

fn curve(value: &Value) -> Result<Curve, String> {
    let scene = value.get("scene").and_then(Value::as_str).map(String::from);
    Ok(Curve { name: text(value, "name")?, scene, set: texts(value, "set") })
}

fn list<'a>(value: &'a Value, key: &str) -> &'a [Value] {
    value.get(key).and_then(Value::as_array).map_or(&[], Vec::as_slice)
}

fn texts(value: &Value, key: &str) -> Vec<String> {
    list(value, key).iter().filter_map(Value::as_str).map(String::from).collect()
}

/// A number, written with or without a point.
pub(crate) fn number(value: &Value) -> Option<f64> {
    value.as_float().or(value.as_integer().map(|whole| whole as f64))
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    #[test]
    fn the_table_of_the_repository_is_read() {
        let studies = read(&Path::new(env!("CARGO_MANIFEST_DIR")).join("../verify/study.toml")).unwrap();
        let drum = studies.iter().find(|study| study.name == "drum-gap").unwrap();
        assert_eq!(drum.sample, 1201);
        assert!(drum.least.contains(&(1e-5, 30.0)) && drum.least.contains(&(1e-6, 50.0)));
        assert!(drum.known.is_some());
    }
}
