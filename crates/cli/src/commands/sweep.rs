//! `wearshape sweep`: a scene over a grid of keys, one row a point, failures kept as rows.

use std::path::PathBuf;
use std::time::Instant;

use rayon::prelude::*;
use report::SCHEMA_VERSION;
use scene::{Document, Fault};
use serde_json::{Map, Value, json};
use wearshape::{Bodies, Options, Problem, Status};

use crate::again::again;
use crate::args::SweepArgs;
use crate::exit::Exit;
use crate::folder::Folder;
use crate::grid::Grid;
use crate::interrupt;
use crate::live::Live;
use crate::open::{self, Beside, open};
use crate::options::{options, with_threads};
use crate::print::{print_json, print_out};
use crate::progress::Progress;

/// Points computed between two writes.
const CHUNK: usize = 64;

/// What every point of a sweep needs.
struct Sweep<'a> {
    args: &'a SweepArgs,
    grid: Grid,
    options: Options<'static>,
    bodies: Bodies,
}

/// Computes all points and writes sweep.csv and sweep.jsonl.
pub(crate) fn run(args: &SweepArgs) -> Result<Exit, Fault> {
    let start = Instant::now();
    let common = &args.common;
    // Rows hold no lists.
    let options = Options { machining: false, ..options(common)? };
    let sweep = Sweep { args, grid: Grid::read(&args.over)?, options, bodies: Bodies::default() };
    let count = sweep.grid.count;
    let (first, beside) = open(&args.scene, &sweep.grid.settings(0, &common.set))?;
    let target = common.output.clone().unwrap_or_else(|| PathBuf::from("out").join(format!("{}-sweep", first.name)));
    if common.dry_run {
        if common.json {
            print_json(&json!({ "scene": first.name, "points": count, "folder": target.display().to_string() }));
        } else {
            print_out(&format!("{count} points of {}\nwould write {}\n", first.name, target.display()));
        }
        return Ok(Exit::Done);
    }
    interrupt::listen();
    let folder = Folder::begin(&target, common.resume)?;
    let mark = sweep.begin(&folder, &first, &beside)?;
    let mut rows = if common.resume { finished_rows(&folder) } else { Vec::new() };
    with_threads(common, || sweep.compute(&folder, &mut rows))??;
    if rows.len() < count {
        let words = [&["sweep", &args.scene][..], &sweep.over()].concat();
        eprintln!("interrupted after {} of {count} points; {}", rows.len(), again(&words, common, Some("every finished row")));
        return Ok(Exit::Interrupted);
    }
    folder.write("sweep.csv", &table(&rows))?;
    folder.write("timing.json", &report::pretty(&json!({ "seconds_total": start.elapsed().as_secs_f64(), "points": count })))?;
    let failed = rows.iter().filter(|row| row["status"] != "ok").count();
    let summary = sweep.summary(&first.name, &mark, failed);
    folder.write("summary.json", &report::pretty(&summary))?;
    folder.finish()?;
    if common.json {
        print_json(&summary);
    } else if !common.quiet {
        print_out(&format!("{count} points, {failed} without an answer\nfiles     {}\n", target.join("sweep.csv").display()));
    }
    Ok(if failed == 0 { Exit::Done } else { Exit::GoalMissed })
}

impl Sweep<'_> {
    /// The `--over` options as words.
    fn over(&self) -> Vec<&str> {
        self.args.over.iter().flat_map(|over| ["--over", over]).collect()
    }

    /// Writes the scene of the first point, headed by what the sweep is, and its files; refuses to go on with another sweep. Returns that text.
    fn begin(&self, folder: &Folder, first: &Document, beside: &Beside) -> Result<String, Fault> {
        let common = &self.args.common;
        let plan = json!({ "scene": self.args.scene, "set": common.set, "over": self.args.over, "sample": common.sample });
        // A first point without an answer is a row like any other; its scene stays as it is written.
        let (resolved, files) = Problem::new(first, &|path| beside.read(path))
            .map_or_else(|_| (first.scene.clone(), Vec::new()), |problem| (problem.scene().clone(), problem.files()));
        let mark = format!("# {}\n{}", plan, scene::scene_text(&resolved));
        if common.resume {
            folder.same_scene(&mark)?;
        }
        folder.write("scene.resolved.toml", &mark)?;
        for (name, bytes) in files {
            folder.write_bytes(&name, &bytes)?;
        }
        Ok(mark)
    }

    /// Adds the rows that are missing, and writes them as they come; Ctrl-C ends it with those that are finished.
    fn compute(&self, folder: &Folder, rows: &mut Vec<Value>) -> Result<(), Fault> {
        let count = self.grid.count;
        rows.truncate(count);
        folder.write("sweep.jsonl", &lines(rows))?;
        let progress = Progress::counted(&self.args.common, count);
        // The first point is computed alone: what it factorises serves the others.
        let mut size = 1;
        while rows.len() < count && !interrupt::asked() {
            let chunk = rows.len()..count.min(rows.len() + std::mem::replace(&mut size, CHUNK));
            // The points are begun in their order, so that few rows stand behind the first that is cut short.
            let mut new: Vec<(usize, Value)> =
                chunk.clone().par_bridge().filter_map(|point| Some((point, self.row(point)?))).collect();
            new.sort_by_key(|(point, _)| *point);
            let whole = chunk.zip(new).map_while(|(point, (of, row))| (point == of).then_some(row));
            let new: Vec<Value> = whole.collect();
            folder.append("sweep.jsonl", &lines(&new))?;
            rows.extend(new);
            progress.done(rows.len());
        }
        progress.end();
        Ok(())
    }

    /// One row: the keys, the status, the numbers of the summary. None if Ctrl-C has cut it short.
    fn row(&self, point: usize) -> Option<Value> {
        if interrupt::asked() {
            return None;
        }
        let mut row = Map::new();
        for (key, value) in self.grid.at(point) {
            row.insert(key.into(), value.parse::<f64>().ok().filter(|v| v.is_finite()).map_or(json!(value), |v| json!(v)));
        }
        match self.solve(&self.grid.settings(point, &self.args.common.set)) {
            Ok((Status::Interrupted, _)) => return None,
            Ok((_, summary)) => {
                let skipped = ["schema_version", "version", "scene", "scene_sha256"];
                for (key, value) in report::numbers(&summary) {
                    if !skipped.contains(&key.as_str()) && !key.starts_with("counters.") {
                        row.insert(key, value);
                    }
                }
            }
            Err(fault) => {
                row.insert("status".into(), json!("invalid"));
                row.insert("verdict".into(), json!(fault.message));
            }
        }
        Some(Value::Object(row))
    }

    /// Status and summary of the scene with some settings.
    fn solve(&self, settings: &[String]) -> Result<(Status, Value), Fault> {
        let (document, problem) = open::problem(&self.args.scene, settings)?;
        problem.available().map_err(|fault| document.locate(fault))?;
        let solved = Live::silent().solve(&problem, &self.options, &self.bodies);
        let solution = solved.map_err(|fault| document.locate(fault))?;
        Ok((solution.status, report::summary(&problem, &solution)))
    }

    fn summary(&self, name: &str, mark: &str, failed: usize) -> Value {
        let count = self.grid.count;
        json!({
            "schema_version": SCHEMA_VERSION,
            "version": env!("CARGO_PKG_VERSION"),
            "scene": name,
            "scene_sha256": scene::sha256(mark),
            "status": if failed == 0 { Status::Ok } else { Status::NotConverged },
            "verdict": format!("{count} points, {failed} without an answer."),
            "over": self.grid.document(),
            "points": count,
            "failed": failed,
            "counters": { "factorisations": self.bodies.factorisations(), "factorisations_saved": self.bodies.reused() },
        })
    }
}

fn lines(rows: &[Value]) -> String {
    rows.iter().map(|row| format!("{row}\n")).collect()
}

/// Rows of an interrupted sweep.
fn finished_rows(folder: &Folder) -> Vec<Value> {
    let text = std::fs::read_to_string(folder.path().join("sweep.jsonl")).unwrap_or_default();
    let whole = text.rfind('\n').map_or("", |end| &text[..=end]);
    whole.lines().map_while(|line| serde_json::from_str(line).ok()).collect()
}

/// CSV of all rows: the union of their keys, in order of first appearance.
fn table(rows: &[Value]) -> String {
    let mut columns: Vec<&String> = Vec::new();
    for row in rows {
        for key in row.as_object().into_iter().flatten().map(|(key, _)| key) {
            if !columns.contains(&key) {
                columns.push(key);
            }
        }
    }
    let cell = |value: Option<&Value>| match value {
        None => String::new(),
        Some(Value::String(text)) => text.clone(),
        Some(Value::Number(number)) => number.as_f64().map(scene::number_text).unwrap_or_default(),
        Some(other) => other.to_string(),
    };
    let names: Vec<&str> = columns.iter().map(|key| key.as_str()).collect();
    report::table(&names, rows.iter().map(|row| columns.iter().map(move |key| cell(row.get(key.as_str())))))
}
