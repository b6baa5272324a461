//! `wearshape diff`: what two folders of results differ in.

use std::path::Path;

use scene::{Fault, Place};
use serde_json::{Value, json};

use crate::args::DiffArgs;
use crate::bounded;
use crate::diff::contact::{self, Apart, Contact, Table};
use crate::diff::scenes;
use crate::diff::summaries::{self, Entry};
use crate::exit::Exit;
use crate::open::Source;
use crate::print::{print_json, print_out};

/// The files of a folder that are compared.
struct Results {
    summary: Value,
    scene: String,
    contact: Option<String>,
}

/// All differences.
struct Difference {
    summary: Vec<Entry>,
    /// Where both have a table of contact points; or why they are not compared.
    contact: Option<Result<Contact, String>>,
    scene: Vec<(String, [Option<String>; 2])>,
    tolerance: f64,
}

/// Says what two folders differ in: exit 0 if their results are the same within the tolerance, 1 if they are not.
pub(crate) fn run(args: &DiffArgs) -> Result<Exit, Fault> {
    if !(args.tolerance >= 0.0 && args.tolerance.is_finite()) {
        let place = Some(Place::Flag(format!("--tolerance {}", args.tolerance)));
        return Err(Fault { place, ..Fault::new("wrong-flag", "a tolerance is a number from 0", "give one like 1e-6") });
    }
    let (a, b) = (read(&args.first)?, read(&args.second)?);
    let contact = a.contact.as_ref().zip(b.contact.as_ref()).map(|(of_a, of_b)| {
        let (of_a, of_b) = (Table(of_a), Table(of_b));
        contact::compare(&of_a, &of_b, &closing(&args.first, &of_a))
    });
    let difference = Difference {
        summary: summaries::compare([&a.summary, &b.summary]),
        contact,
        scene: scenes::compare([&a.scene, &b.scene]),
        tolerance: args.tolerance,
    };
    let same = difference.first().is_none();
    if args.json {
        let folders = [&args.first, &args.second].map(|folder| folder.display().to_string());
        print_json(&difference.document(folders, same));
    } else if !args.quiet {
        print_out(&difference.text());
    }
    Ok(if same { Exit::Done } else { Exit::GoalMissed })
}

fn read(folder: &Path) -> Result<Results, Fault> {
    let fault = |message: String| Fault {
        place: Some(Place::Flag(folder.display().to_string())),
        ..Fault::new("no-results", message, "give the folders of two finished runs: wearshape diff out/one out/other")
    };
    let read = |name: &str| {
        let path = folder.join(name);
        bounded::result_text(&path).map_err(|error| fault(format!("cannot read {}: {error}", path.display())))
    };
    let damaged = |error: &dyn std::fmt::Display| fault(format!("{} is damaged: {error}", folder.join("summary.json").display()));
    let summary: Value = serde_json::from_str(&read("summary.json")?).map_err(|error| damaged(&error))?;
    if !summary["schema_version"].is_u64() {
        return Err(damaged(&"it has no schema_version"));
    }
    if let Some(what) = other_than_run(&summary) {
        return Err(fault(format!("{} holds {what}, and only runs can be compared", folder.display())));
    }
    let contact = if folder.join("contact.csv").exists() { Some(read("contact.csv")?) } else { None };
    Ok(Results { summary, scene: read("scene.resolved.toml")?, contact })
}

/// What a folder holds that is no run, by its summary.
fn other_than_run(summary: &Value) -> Option<&'static str> {
    let kinds =
        [("levels", "a study"), ("over", "a sweep"), ("item", "a figure of the paper"), ("items", "figures of the paper")];
    kinds.into_iter().find(|(key, _)| !summary[key].is_null()).map(|(_, what)| what)
}

/// Closing velocities of the free rigid modes of the scene in a folder, at the points of its table; none where the scene is no problem any more.
fn closing(folder: &Path, table: &Table<'_>) -> Vec<Vec<f64>> {
    let scene = folder.join("scene.resolved.toml").display().to_string();
    let problem = Source::read(&scene).and_then(|source| source.problem(&[]));
    let [position, normal] = table.places();
    problem.map(|(_, problem)| problem.closing(&position, &normal)).unwrap_or_default()
}

impl Difference {
    /// Where the results differ first by more than the tolerance.
    fn first(&self) -> Option<String> {
        let contact = self.contact.as_ref().and_then(|contact| match contact {
            Err(_) => Some("the points of contact.csv".to_string()),
            Ok(contact) => {
                let columns = [("pressure_MPa", contact.pressure), ("gap_um", contact.gap)];
                let apart = |apart: &Option<Apart>| apart.is_some_and(|apart| apart.largest_relative > self.tolerance);
                columns.iter().find(|(_, column)| apart(column)).map(|(name, _)| format!("{name} of contact.csv"))
            }
        });
        let counts = |entry: &&Entry| entry.counts(self.tolerance);
        contact.or_else(|| self.summary.iter().find(counts).map(|entry| entry.key.clone()))
    }

    fn document(&self, folders: [String; 2], same: bool) -> Value {
        let apart = |apart: Option<Apart>| {
            apart.map(|apart| {
                json!({
                    "largest": apart.largest,
                    "largest_relative": apart.largest_relative,
                    "l2_relative": apart.l2_relative,
                    "interpolation_relative": apart.interpolation_relative,
                })
            })
        };
        let entry = |entry: &Entry| {
            let [a, b] = &entry.values;
            json!({ "key": entry.key, "a": a, "b": b, "relative": entry.relative, "result": entry.result })
        };
        let contact = self.contact.as_ref().map(|contact| match contact {
            Err(why) => json!({ "not_compared": why }),
            Ok(contact) => json!({
                "points": contact.points,
                "interpolated": contact.interpolated,
                "pressure_MPa": apart(contact.pressure),
                "gap_um": apart(contact.gap),
            }),
        });
        json!({
            "a": folders[0],
            "b": folders[1],
            "tolerance": self.tolerance,
            "same": same,
            "scene": self.scene.iter().map(|(key, [a, b])| json!({ "key": key, "a": a, "b": b })).collect::<Vec<_>>(),
            "summary": self.summary.iter().map(entry).collect::<Vec<_>>(),
            "contact": contact,
        })
    }

    fn text(&self) -> String {
        let mut out = String::new();
        if !self.scene.is_empty() {
            out += "scene\n";
            for (key, [a, b]) in &self.scene {
                let written = |value: &Option<String>| value.clone().unwrap_or_else(|| "-".into());
                out += &format!("  {key}: {} | {}\n", written(a), written(b));
            }
        }
        let differing: Vec<&Entry> =
            self.summary.iter().filter(|entry| entry.differs() && !entry.key.contains("sha256")).collect();
        if !differing.is_empty() {
            out += "summary                                           A             B  relative\n";
            out.extend(differing.into_iter().map(line));
        }
        match &self.contact {
            None => {}
            Some(Err(why)) => out += &format!("contact.csv\n  not compared: {why}\n"),
            Some(Ok(contact)) => out += &curves(contact),
        }
        match self.first() {
            None => out + &format!("the results are the same within {:e}\n", self.tolerance),
            Some(place) => out + &format!("the results differ by more than {:e}, as in {place}\n", self.tolerance),
        }
    }
}

/// A key of the summary with both values.
fn line(entry: &Entry) -> String {
    let shown = |value: &Option<Value>| match value {
        None => "-".to_string(),
        Some(Value::String(text)) => text.clone(),
        Some(value) => value.as_f64().map_or_else(|| value.to_string(), scene::short),
    };
    let [a, b] = entry.values.each_ref().map(shown);
    let relative = entry.relative.map_or(String::new(), |relative| format!("{relative:.1e}"));
    let mark = if entry.result { "" } else { " (how)" };
    let key = format!("{}{mark}", entry.key);
    if a.len() > 12 || b.len() > 12 {
        return format!("  {key}\n    A: {a}\n    B: {b}\n");
    }
    format!("  {key:<38}  {a:>12}  {b:>12}  {relative:>8}\n")
}

/// What the curves are apart by.
fn curves(contact: &Contact) -> String {
    let how = if contact.interpolated { "interpolated over s" } else { "the same places" };
    let mut out = format!("contact.csv, {} points, {how}\n", contact.points);
    let columns = [("pressure", "MPa", contact.pressure), ("gap without rigid part", "um", contact.gap)];
    for (name, unit, apart) in columns {
        if let Some(Apart { largest, largest_relative, l2_relative, interpolation_relative }) = apart {
            out += &format!("  {name}: largest {largest:.3e} {unit}, relative {largest_relative:.1e}, L2 {l2_relative:.1e}\n");
            if contact.interpolated {
                out += &format!("    of which interpolation may be {interpolation_relative:.1e}\n");
            }
        }
    }
    out
}
