//! The table on the screen, report.json and report.html.

use super::case::{Case, Norm};
use super::picture;
use super::row::Row;
use serde_json::{Value, json};
use std::fs;
use std::path::Path;

/// What became of a case.
pub(crate) struct Outcome {
    name: String,
    scene: String,
    pub(crate) result: Result<Vec<Row>, String>,
    waits: bool,
    seconds: f64,
}

impl Outcome {
    /// A case that ran, well or not.
    pub(crate) fn new(case: &Case, result: Result<Vec<Row>, String>, seconds: f64) -> Self {
        let scene = std::iter::once(&case.scene).chain(&case.set).cloned().collect::<Vec<_>>().join(" ");
        Self { name: case.name.clone(), scene, result, waits: false, seconds }
    }

    /// A comparison of a script with known numbers.
    pub(crate) fn known(name: &str, scene: &str, result: Result<Vec<Row>, String>, seconds: f64) -> Self {
        Self { name: name.into(), scene: scene.into(), result, waits: false, seconds }
    }

    /// A case that is not run yet.
    pub(crate) fn waits(case: &Case, reason: &str) -> Self {
        Self { waits: true, ..Self::new(case, Err(reason.into()), 0.0) }
    }

    /// All quantities passed; a waiting case is no failure.
    fn passed(&self) -> bool {
        self.waits || self.result.as_ref().is_ok_and(|rows| rows.iter().all(Row::passed))
    }

    /// Why it did not run.
    pub(crate) fn message(&self) -> &str {
        self.result.as_ref().err().map_or("", String::as_str)
    }
}

/// Prints the lines of one case.
pub(crate) fn print(outcome: &Outcome) {
    match &outcome.result {
        Err(reason) if outcome.waits => println!("{:<31} not yet: {reason}", outcome.name),
        Err(message) => println!("{:<31} FAILED: {message}", outcome.name),
        Ok(rows) => {
            for row in rows {
                let norm = if row.norm == Norm::Rms { "rms" } else { "max" };
                println!(
                    "{:<31} {:<27} {:>4} points  {norm} {:8.1e}  allowed {:7.0e}  self-error {:7.1e}  {}",
                    outcome.name,
                    row.quantity,
                    row.points,
                    row.difference,
                    row.tolerance,
                    row.self_error,
                    row.verdict()
                );
            }
        }
    }
}

/// Writes both reports and the last line; true when everything that ran passed and something ran.
pub(crate) fn write(folder: &Path, outcomes: &[Outcome], fault: Option<&str>, seconds: f64) -> Result<bool, String> {
    let ran = outcomes.iter().filter(|outcome| !outcome.waits).count();
    let failed = outcomes.iter().filter(|outcome| !outcome.passed()).count();
    if ran == 0 {
        return Err("no case was run, so nothing is verified".into());
    }
    let save = |name: &str, text: String| {
        let path = folder.join(name);
        fs::create_dir_all(folder).and_then(|()| fs::write(&path, text)).map_err(|e| format!("{}: {e}", path.display()))
    };
    let versions = outcomes.iter().map(|outcome| versions(folder, outcome)).find(|v| !v.is_null()).unwrap_or_default();
    let cases: Vec<Value> = outcomes.iter().map(case_json).collect();
    let whole = json!({
        "passed": failed == 0, "fault": fault, "seconds": seconds, "versions": versions, "cases": cases,
    });
    save("report.json", format!("{whole:#}\n"))?;
    save("report.html", html(outcomes, &versions, fault, seconds))?;
    let waiting = outcomes.len() - ran;
    println!(
        "verify: {ran} cases, {failed} failed, {waiting} not yet run, {seconds:.0} s; {}",
        folder.join("report.html").display()
    );
    Ok(failed == 0)
}

fn versions(folder: &Path, outcome: &Outcome) -> Value {
    let path = folder.join(&outcome.name).join("out.json");
    super::tables::read_json(&path).map_or(Value::Null, |out| out["versions"].clone())
}

fn case_json(outcome: &Outcome) -> Value {
    let rows = outcome.result.as_ref().map_or(&[] as &[Row], Vec::as_slice);
    let rows: Vec<Value> = rows
        .iter()
        .map(|row| {
            json!({
                "quantity": row.quantity, "points": row.points, "scale": row.scale, "difference": row.difference,
                "tolerance": row.tolerance, "self_error": row.self_error, "passed": row.passed(),
                "norm": if row.norm == Norm::Rms { "rms" } else { "max" },
            })
        })
        .collect();
    json!({
        "case": outcome.name, "scene": outcome.scene, "passed": outcome.passed(), "ran": !outcome.waits,
        "message": outcome.message(), "seconds": outcome.seconds, "quantities": rows,
    })
}

fn html(outcomes: &[Outcome], versions: &Value, fault: Option<&str>, seconds: f64) -> String {
    let mut body = String::from("<h1>wearshape against dolfinx</h1>\n");
    let mut programs = String::new();
    for (name, version) in versions.as_object().into_iter().flatten() {
        programs += &format!("{} {} ", picture::escape(name), picture::escape(version.as_str().unwrap_or("?")));
    }
    body += &format!("<p>{programs}&middot; {seconds:.0} s</p>\n");
    if let Some(fault) = fault {
        body += &format!("<p class=bad>Deliberate fault: {}. This run must fail.</p>\n", picture::escape(fault));
    }
    body += "<table><tr><th>case<th>quantity<th>points<th>difference<th>allowed<th>self-error<th></tr>\n";
    for outcome in outcomes {
        match &outcome.result {
            Err(message) => {
                let class = if outcome.waits { "wait" } else { "bad" };
                let (name, message) = (picture::escape(&outcome.name), picture::escape(message));
                body += &format!("<tr class={class}><td>{name}<td colspan=6>{message}</tr>\n");
            }
            Ok(rows) => {
                for row in rows {
                    let class = if row.passed() { "good" } else { "bad" };
                    body += &format!(
                        "<tr class={class}><td title='{}'>{}<td>{}<td>{}<td>{:.1e}<td>{:.0e}<td>{:.1e}<td>{}</tr>\n",
                        picture::escape(&outcome.scene).replace('\'', "&#39;"),
                        picture::escape(&outcome.name),
                        picture::escape(&row.quantity),
                        row.points,
                        row.difference,
                        row.tolerance,
                        row.self_error,
                        row.verdict()
                    );
                }
            }
        }
    }
    body += "</table>\n<p>Lines: wearshape. Circles: dolfinx, rigid motion taken out. Below: the difference. The scene of a case shows when the pointer rests on its name.</p>\n";
    for outcome in outcomes {
        for row in outcome.result.as_ref().map_or(&[] as &[Row], Vec::as_slice).iter().filter(|row| row.points > 2) {
            let title = format!("{}: {}", outcome.name, row.quantity);
            body += &format!("<figure>{}</figure>\n", picture::curves(&title, &row.at, &row.ours, &row.theirs));
        }
    }
    format!(
        "<!doctype html><html lang=en><meta charset=utf-8><title>verify</title><style>body{{font:15px sans-serif;margin:2em;\
         max-width:75em}}td,th{{padding:.2em .8em;text-align:left}}.good td:last-child{{color:#060}}.bad{{color:#a00}}\
         .wait{{color:#777}}figure{{display:inline-block;margin:.5em}}</style>\n{body}</html>\n"
    )
}
