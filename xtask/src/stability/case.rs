//! The table of extreme cases, read from verify/stability.toml.

use std::fs;
use std::path::Path;
use toml::{Table, Value};

/// One extreme case.
pub(crate) struct Case {
    pub(crate) name: String,
    pub(crate) what: String,
    /// What makes the result right.
    pub(crate) right: String,
    pub(crate) kind: Kind,
}

/// What is started.
pub(crate) enum Kind {
    Scene(Box<Scene>),
    /// Tests of a crate whose names begin with the filter.
    Tests {
        package: String,
        filter: String,
    },
}

/// A run of the program and what must hold of it.
pub(crate) struct Scene {
    pub(crate) scene: String,
    pub(crate) set: Vec<String>,
    pub(crate) exit: i32,
    pub(crate) says: Option<String>,
    pub(crate) numbers: Vec<Number>,
    pub(crate) scaled: Option<Scaled>,
}

/// What must hold of one number of summary.json.
pub(crate) struct Number {
    /// Its place, as a JSON pointer, and that of a number it is divided by.
    pub(crate) of: String,
    pub(crate) over: Option<String>,
    /// Value and relative tolerance.
    pub(crate) is: Option<(f64, f64)>,
    pub(crate) below: Option<f64>,
    pub(crate) above: Option<f64>,
}

/// Columns that must be those of an earlier case times a factor.
pub(crate) struct Scaled {
    pub(crate) like: String,
    /// The table of both that has them.
    pub(crate) table: String,
    pub(crate) columns: Vec<(String, f64)>,
    /// Relative to the largest value; 0: bit for bit.
    pub(crate) within: f64,
}

/// Reads the table; the message of an error names the case and the key.
pub(crate) fn read(path: &Path) -> Result<Vec<Case>, String> {
    let text = fs::read_to_string(path).map_err(|error| format!("{}: {error}", path.display()))?;
    parse(&text).map_err(|message| format!("{}: {message}", path.display()))
}

fn parse(text: &str) -> Result<Vec<Case>, String> {
    let table: Table = text.parse().map_err(|error| format!("{error}"))?;
    let list = table.get("case").and_then(Value::as_array).ok_or("no [[case]]")?;
    let mut cases: Vec<Case> = Vec::new();
    for value in list {
        let case = case(value)?;
        if cases.iter().any(|earlier| earlier.name == case.name) {
            return Err(format!("two cases {}", case.name));
        }
        if let Kind::Scene(scene) = &case.kind
            && let Some(scaled) = &scene.scaled
            && !cases.iter().any(|earlier| earlier.name == scaled.like)
        {
            return Err(format!("{}: no earlier case {}", case.name, scaled.like));
        }
        cases.push(case);
    }
    Ok(cases)
}

fn case(value: &Value) -> Result<Case, String> {
    let name = word(value, "name")?;
    let kind = match value.get("tests") {
        Some(tests) => Kind::Tests { package: word(tests, "package")?, filter: word(tests, "filter")? },
        None => Kind::Scene(Box::new(scene(value).map_err(|message| format!("{name}: {message}"))?)),
    };
    Ok(Case { what: word(value, "what")?, right: word(value, "right")?, kind, name })
}

fn scene(value: &Value) -> Result<Scene, String> {
    let scaled = value.get("scaled").map(scaled).transpose()?;
    let texts = list(value, "set").iter().filter_map(Value::as_str).map(String::from).collect();
    Ok(Scene {
        scene: word(value, "scene")?,
        set: texts,
        exit: value.get("exit").and_then(Value::as_integer).unwrap_or(0) as i32,
        says: value.get("says").and_then(Value::as_str).map(String::from),
        numbers: list(value, "numbers").iter().map(number).collect::<Result<_, _>>()?,
        scaled,
    })
}

fn number(value: &Value) -> Result<Number, String> {
    let of = word(value, "of")?;
    let read = |key: &str| value.get(key).and_then(float);
    let is = match (read("is"), read("within")) {
        (Some(is), Some(within)) => Some((is, within)),
        (None, None) => None,
        _ => return Err(format!("{of}: `is` and `within` go together")),
    };
    let number = Number {
        over: value.get("over").and_then(Value::as_str).map(String::from),
        is,
        below: read("below"),
        above: read("above"),
        of,
    };
    if number.is.is_none() && number.below.is_none() && number.above.is_none() {
        return Err(format!("{}: nothing to hold it against", number.of));
    }
    Ok(number)
}

fn scaled(value: &Value) -> Result<Scaled, String> {
    let pair = |entry: &Value| Some((entry.get(0)?.as_str()?.to_string(), float(entry.get(1)?)?));
    let columns: Option<Vec<_>> = list(value, "columns").iter().map(pair).collect();
    let columns = columns.filter(|columns| !columns.is_empty()).ok_or("scaled needs columns = [[name, factor], ..]")?;
    let within = value.get("within").and_then(float).ok_or("scaled needs within")?;
    let table = value.get("table").and_then(Value::as_str).unwrap_or("contact.csv").to_string();
    Ok(Scaled { like: word(value, "like")?, table, columns, within })
}

fn list<'a>(value: &'a Value, key: &str) -> &'a [Value] {
    value.get(key).and_then(Value::as_array).map_or(&[], Vec::as_slice)
}

fn word(value: &Value, key: &str) -> Result<String, String> {
    value.get(key).and_then(Value::as_str).map(String::from).ok_or(format!("`{key}` is missing or no text"))
}

fn float(value: &Value) -> Option<f64> {
    value.as_float().or(value.as_integer().map(|whole| whole as f64))
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    #[test]
    fn the_table_of_the_repository_is_read() {
        let cases = read(&Path::new(env!("CARGO_MANIFEST_DIR")).join("../verify/stability.toml")).unwrap();
        assert!(cases.len() >= 40, "{}", cases.len());
    }

    #[test]
    fn a_number_without_a_demand_and_a_base_that_comes_later_are_refused() {
        let head = "[[case]]\nname='a'\nwhat='w'\nright='r'\nscene='s'\n";
        assert!(parse(&format!("{head}numbers=[{{of='/x'}}]")).is_err_and(|e| e.contains("nothing to hold")));
        let scaled = format!("{head}scaled={{like='b',columns=[['gap_um',1.0]],within=0.0}}");
        assert!(parse(&scaled).is_err_and(|e| e.contains("no earlier case b")));
    }
}
