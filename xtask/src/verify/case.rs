//! The table of cases, read from verify/cases.toml.

use std::fs;
use std::path::Path;
use toml::{Table, Value};

/// One comparison: a scene, a script, quantities with tolerances.
pub(crate) struct Case {
    pub(crate) name: String,
    /// Built-in scene or path of a file from the root of the workspace.
    pub(crate) scene: String,
    /// Changes of the scene, `key=value`.
    pub(crate) set: Vec<String>,
    /// Script in verify/.
    pub(crate) script: String,
    /// Number of sample points along the contact.
    pub(crate) sample: Option<i64>,
    /// Part of `--quick`.
    pub(crate) quick: bool,
    /// Why the case is not run yet.
    pub(crate) waits: Option<String>,
    /// Wrong problems that this case must catch.
    pub(crate) faults: Vec<String>,
    pub(crate) quantities: Vec<Wanted>,
}

/// One quantity of a case.
pub(crate) struct Wanted {
    /// Its name in the script's out.json.
    pub(crate) name: String,
    /// Where it stands in our output.
    pub(crate) ours: String,
    /// Largest difference that passes, relative to the largest value of ours.
    pub(crate) tolerance: f64,
    pub(crate) norm: Norm,
}

/// How differences over the points become one number.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Norm {
    Max,
    Rms,
}

/// Reads the table; the message of an error names the case and the key.
pub(crate) fn read(path: &Path) -> Result<Vec<Case>, String> {
    let text = fs::read_to_string(path).map_err(|error| format!("{}: {error}", path.display()))?;
    let table: Table = text.parse().map_err(|error| format!("{}: {error}", path.display()))?;
    let cases = table.get("case").and_then(Value::as_array).ok_or(format!("{}: no [[case]]", path.display()))?;
    cases.iter().map(|value| case(value).map_err(|message| format!("{}: {message}", path.display()))).collect()
}

fn case(value: &Value) -> Result<Case, String> {
    let name = text(value, "name")?;
    let quantities = value.get("quantities").and_then(Value::as_array).map_or(&[] as &[Value], Vec::as_slice);
    if quantities.is_empty() {
        return Err(format!("case {name}: no quantities, so it cannot fail"));
    }
    Ok(Case {
        scene: text(value, "scene")?,
        set: texts(value, "set"),
        script: text(value, "script")?,
        sample: value.get("sample").and_then(Value::as_integer),
        quick: value.get("quick").and_then(Value::as_bool).unwrap_or(false),
        waits: value.get("waits").and_then(Value::as_str).map(String::from),
        faults: texts(value, "faults"),
        quantities: quantities.iter().map(wanted).collect::<Result<_, _>>().map_err(|e| format!("case {name}: {e}"))?,
        name,
    })
}

/// A quantity from its table.
pub(crate) fn wanted(value: &Value) -> Result<Wanted, String> {
    let name = text(value, "name")?;
    let tolerance = value.get("tolerance").and_then(Value::as_float).filter(|t| *t > 0.0 && *t < 1.0);
    Ok(Wanted {
        ours: value.get("ours").and_then(Value::as_str).unwrap_or(&name).to_string(),
        tolerance: tolerance.ok_or(format!("{name}: needs a tolerance between 0 and 1"))?,
        norm: match value.get("norm").and_then(Value::as_str) {
            None | Some("max") => Norm::Max,
            Some("rms") => Norm::Rms,
            Some(other) => return Err(format!("{name}: norm is max or rms, not {other}")),
        },
        name,
    })
}

/// A text that must be there.
pub(crate) fn text(value: &Value, key: &str) -> Result<String, String> {
    value.get(key).and_then(Value::as_str).map(String::from).ok_or(format!("`{key}` is missing or no text"))
}

fn texts(value: &Value, key: &str) -> Vec<String> {
    let list = value.get(key).and_then(Value::as_array);
    list.into_iter().flatten().filter_map(Value::as_str).map(String::from).collect()
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    fn parse(text: &str) -> Result<Case, String> {
        case(&Value::Table(text.parse().unwrap()))
    }

    #[test]
    fn a_case_without_quantities_is_refused() {
        assert!(parse("name='a'\nscene='s'\nscript='gap.py'").is_err_and(|e| e.contains("cannot fail")));
    }

    #[test]
    fn a_quantity_without_tolerance_is_refused() {
        let text = "name='a'\nscene='s'\nscript='gap.py'\nquantities=[{name='gap_um'}]";
        assert!(parse(text).is_err_and(|e| e.contains("gap_um") && e.contains("tolerance")));
    }

    #[test]
    fn the_table_of_the_repository_is_read_and_names_are_unique() {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../verify/cases.toml");
        let cases = read(&path).unwrap();
        let mut names: Vec<&str> = cases.iter().map(|case| case.name.as_str()).collect();
        names.sort_unstable();
        names.dedup();
        assert_eq!(names.len(), cases.len());
        assert!(cases.iter().all(|case| path.with_file_name(&case.script).exists()));
    }
}
