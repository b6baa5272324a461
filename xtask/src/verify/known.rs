//! `cargo xtask verify --known`: the scripts against numbers that others found, without wearshape.
//!
//! verify/known.toml names a built-in scene, changes, sample points and values; they are laid out as
//! wearshape would write them, and the script's answer is compared with them.

use super::case::{Wanted, text, wanted};
use super::report::Outcome;
use super::row::Row;
use super::{compare, programs, report};
use std::fs;
use std::path::Path;
use std::time::Instant;
use toml::{Table, Value};

/// Compares all known cases, the quick ones, or the named ones; true when all pass.
pub(crate) fn compare(root: &Path, names: &[String], quick: bool, fault: Option<&str>) -> Result<bool, String> {
    let path = root.join("verify/known.toml");
    let content = fs::read_to_string(&path).map_err(|error| format!("{}: {error}", path.display()))?;
    let table: Table = content.parse().map_err(|error| format!("{}: {error}", path.display()))?;
    let started = Instant::now();
    let mut outcomes = Vec::new();
    for value in table.get("case").and_then(Value::as_array).into_iter().flatten() {
        let name = text(value, "name")?;
        let in_quick = value.get("quick").and_then(Value::as_bool) == Some(true);
        let wanted = if names.is_empty() { !quick || in_quick } else { names.contains(&name) };
        if !wanted {
            continue;
        }
        let began = Instant::now();
        let result = one(root, value, &name, fault);
        let outcome = Outcome::known(&name, &text(value, "scene")?, result, began.elapsed().as_secs_f64());
        report::print(&outcome);
        outcomes.push(outcome);
    }
    report::write(&root.join("target/verify/known"), &outcomes, None, started.elapsed().as_secs_f64())
}

fn one(root: &Path, case: &Value, name: &str, fault: Option<&str>) -> Result<Vec<Row>, String> {
    let folder = root.join("target/verify/known").join(name);
    let ours = folder.join("ours");
    fs::create_dir_all(&ours).map_err(|error| format!("{}: {error}", ours.display()))?;
    let save = |name: &str, text: String| {
        fs::write(ours.join(name), text).map_err(|error| format!("{}: {error}", ours.join(name).display()))
    };
    save("scene.resolved.toml", scene(root, case)?)?;
    save("contact.csv", columns(case)?)?;
    save("summary.json", summary(case))?;
    programs::script(root, &text(case, "script")?, &folder, fault)?;
    let list = case.get("quantities").and_then(Value::as_array).ok_or(format!("{name}: no quantities"))?;
    let quantities: Vec<Wanted> = list.iter().map(wanted).collect::<Result<_, _>>()?;
    compare::rows(&quantities, &folder)
}

/// The built-in scene with the case's changes laid over it.
fn scene(root: &Path, case: &Value) -> Result<String, String> {
    let path = root.join("crates/scene/scenes").join(text(case, "scene")? + ".toml");
    let mut scene = read_toml(&path)?;
    if let Some(changes) = case.get("change").and_then(Value::as_table) {
        lay_over(&mut scene, changes);
    }
    Ok(scene.to_string())
}

/// Supports replace each other; other tables are merged key by key.
fn lay_over(scene: &mut Table, changes: &Table) {
    for (key, value) in changes {
        match (scene.get_mut(key), value) {
            (Some(Value::Table(inner)), Value::Table(change)) if key != "support" => lay_over(inner, change),
            _ => {
                scene.insert(key.clone(), value.clone());
            }
        }
    }
}

fn read_toml(path: &Path) -> Result<Table, String> {
    let content = fs::read_to_string(path).map_err(|error| format!("{}: {error}", path.display()))?;
    content.parse().map_err(|error| format!("{}: {error}", path.display()))
}

/// contact.csv from the case's points and values.
fn columns(case: &Value) -> Result<String, String> {
    let table = case.get("columns").and_then(Value::as_table).ok_or("no [case.columns]")?;
    let names: Vec<&str> = table.keys().map(String::as_str).collect();
    let values: Vec<Vec<f64>> =
        table.values().map(|value| value.as_array().into_iter().flatten().filter_map(number).collect::<Vec<f64>>()).collect();
    let count = values.first().map_or(0, Vec::len);
    if values.iter().any(|column| column.len() != count) {
        return Err("the columns differ in length".into());
    }
    let mut text = names.join(",") + "\n";
    for row in 0..count {
        let cells: Vec<String> = values.iter().map(|column| format!("{:?}", column[row])).collect();
        text += &(cells.join(",") + "\n");
    }
    Ok(text)
}

fn number(value: &Value) -> Option<f64> {
    value.as_float().or(value.as_integer().map(|whole| whole as f64))
}

/// summary.json from the case's `summary` table.
fn summary(case: &Value) -> String {
    let empty = Value::Table(Table::new());
    serde_json::to_string(case.get("summary").unwrap_or(&empty)).unwrap_or_default()
}
