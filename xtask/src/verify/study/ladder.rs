//! Runs both programs on their ladders.

use super::super::{programs, tables};
use super::case::{Curve, Study};
use super::front::{Point, relative_l2};
use serde_json::Value;
use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};

/// A study, and what and where it is run.
pub(crate) struct Setting<'a> {
    /// The workspace.
    pub(crate) root: &'a Path,
    /// The program of ours.
    pub(crate) wearshape: &'a Path,
    pub(crate) study: &'a Study,
    /// Where its runs write.
    pub(crate) folder: &'a Path,
}

/// What the levels are compared with.
pub(crate) struct Truth {
    values: Vec<f64>,
    modes: Vec<Vec<f64>>,
    keep: Vec<bool>,
    pub(crate) summary: Value,
    pub(crate) table: tables::Csv,
}

/// Solves the finest level of ours into `<folder>/ours`.
pub(crate) fn truth(setting: &Setting<'_>) -> Result<Truth, String> {
    let study = setting.study;
    let ours = setting.folder.join("ours");
    let settings: Vec<&String> = study.set.iter().chain(&study.truth).collect();
    solve(setting, &study.scene, &settings, &ours)?;
    let table = tables::read_csv(&ours.join("contact.csv"))?;
    let summary = tables::read_json(&ours.join("summary.json"))?;
    let values = table.column(&study.column)?.to_vec();
    let modes = study.modes.iter().map(|name| table.column(name).map(<[f64]>::to_vec)).collect::<Result<_, _>>()?;
    let s = table.column("s_mm")?;
    let ends: Vec<f64> = summary["contact"]["ends_mm"].as_array().into_iter().flatten().filter_map(Value::as_f64).collect();
    let all = if ends.is_empty() { s } else { &ends };
    let (low, high) = all.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| (low.min(*x), high.max(*x)));
    let half = 0.5 * study.inner * (high - low);
    let keep = s.iter().map(|s| (s - 0.5 * (low + high)).abs() <= half * (1.0 + 1e-9)).collect();
    Ok(Truth { values, modes, keep, summary, table })
}

impl Truth {
    /// Error of values at all places.
    pub(crate) fn error(&self, values: &[f64]) -> f64 {
        let kept = |list: &[f64]| list.iter().zip(&self.keep).filter(|(_, keep)| **keep).map(|(v, _)| *v).collect::<Vec<f64>>();
        let modes: Vec<Vec<f64>> = self.modes.iter().map(|mode| kept(mode)).collect();
        relative_l2(&kept(values), &kept(&self.values), &modes)
    }
}

/// One ladder of ours, timed by `wearshape study`, the errors by a run of each level.
pub(crate) fn ours(setting: &Setting<'_>, curve: &Curve, truth: &Truth) -> Result<Vec<Point>, String> {
    let study = setting.study;
    let rows = times(setting, curve)?;
    let scene = curve.scene.as_ref().unwrap_or(&study.scene);
    let mut points = Vec::new();
    for row in &rows {
        let value = |key: &str| row[key].as_f64().unwrap_or(f64::NAN);
        let (degree, layers) = (value("degree"), value("layers"));
        let error = if study.by_program {
            value("error_true")
        } else {
            let level = [format!("mesh.degree={degree}"), format!("mesh.layers={layers}"), "check=false".into()];
            let settings: Vec<&String> = study.set.iter().chain(&curve.set).chain(&level).collect();
            let at = setting.folder.join("level");
            solve(setting, scene, &settings, &at)?;
            truth.error(tables::read_csv(&at.join("contact.csv"))?.column(&study.column)?)
        };
        // A level as near to the truth as that one's own error has none.
        if !error.is_finite() {
            continue;
        }
        let label = format!("degree {degree}, {layers} layers");
        points.push(Point { label, unknowns: value("dofs"), seconds: value("seconds_total"), error });
    }
    Ok(points)
}

/// Rows of `wearshape study` of a curve.
pub(crate) fn times(setting: &Setting<'_>, curve: &Curve) -> Result<Vec<Value>, String> {
    let Setting { root, wearshape, study, folder } = setting;
    let mut command = Command::new(wearshape);
    command.current_dir(root).args(["study", curve.scene.as_ref().unwrap_or(&study.scene)]);
    command.args(["--threads", "1", "-q", "--no-progress", "-o"]).arg(folder.join("study"));
    if study.by_program {
        command.arg("--reference").arg(folder.join("ours"));
    }
    for change in study.set.iter().chain(&curve.set) {
        command.args(["--set", change]);
    }
    finish(command)?;
    let found = tables::read_json(&folder.join("study/study.json"))?;
    found["levels"].as_array().cloned().ok_or_else(|| "study.json has no levels".into())
}

fn solve(setting: &Setting<'_>, scene: &str, changes: &[&String], folder: &Path) -> Result<(), String> {
    let mut command = Command::new(setting.wearshape);
    command.current_dir(setting.root).args(["run", scene, "-q", "--no-progress", "--threads", "1", "-o"]).arg(folder);
    command.args(["--sample", &setting.study.sample.to_string()]);
    for change in changes {
        command.args(["--set", change]);
    }
    finish(command)
}

/// Ends well, or with the goal not met: a coarse level need not be accurate.
fn finish(mut command: Command) -> Result<(), String> {
    let output = command.stdin(Stdio::null()).output().map_err(|error| format!("wearshape: {error}"))?;
    match output.status.code() {
        Some(0 | 1) => Ok(()),
        _ => Err(format!("wearshape ended with {}: {}", output.status, String::from_utf8_lossy(&output.stderr).trim())),
    }
}

/// What dolfinx says: its rows with errors, its versions, and how much longer the wall clock was than the processor's.
pub(crate) struct Theirs {
    pub(crate) points: Vec<Point>,
    pub(crate) versions: Value,
    pub(crate) waited: f64,
}

/// The ladder of dolfinx.
pub(crate) fn theirs(setting: &Setting<'_>, truth: &Truth) -> Result<Theirs, String> {
    let Setting { root, study, folder, .. } = setting;
    let out = folder.join("out.json");
    let log = folder.join("script.log");
    let file = fs::File::create(&log).map_err(|error| format!("{}: {error}", log.display()))?;
    let mut command = programs::python(root);
    command.arg(root.join("verify/study.py")).arg(folder).arg(&study.name);
    let status = command.stdout(Stdio::null()).stderr(file).status().map_err(|error| format!("study.py: {error}"))?;
    if !status.success() {
        return Err(format!("study.py ended with {status}; see {}", log.display()));
    }
    let found = tables::read_json(&out)?;
    let rows = found["rows"].as_array().cloned().unwrap_or_default();
    let number = |row: &Value, key: &str| row[key].as_f64().unwrap_or(f64::NAN);
    let point = |row: &Value| {
        let values: Vec<f64> = row["values"].as_array().into_iter().flatten().map(|v| v.as_f64().unwrap_or(f64::NAN)).collect();
        Point {
            label: label(row),
            unknowns: number(row, "unknowns"),
            seconds: number(row, "seconds"),
            error: truth.error(&values),
        }
    };
    let waited = rows.iter().map(|row| number(row, "seconds") / number(row, "seconds_cpu")).fold(1.0, f64::max);
    Ok(Theirs { points: rows.iter().map(point).collect(), versions: found["versions"].clone(), waited })
}

fn label(row: &Value) -> String {
    let known = [
        ("degree", "P"),
        ("cells", "cells "),
        ("steps", "steps "),
        ("size", "size "),
        ("near", "near "),
        ("smallest", "smallest "),
    ];
    let words = known.iter().filter(|(key, _)| row[*key].is_number()).map(|(key, word)| format!("{word}{}", row[*key]));
    words.collect::<Vec<_>>().join(", ")
}
