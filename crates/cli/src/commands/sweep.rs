//! `wearshape sweep`: a scene over a grid of keys, one row a point, failures kept as rows.

use std::path::PathBuf;
use std::time::Instant;

use rayon::prelude::*;
use report::SCHEMA_VERSION;
use scene::{Fault, Place};
use serde_json::{Map, Value, json};
use wearshape::{Bodies, Options, Problem, Status};

use crate::args::{Common, SweepArgs};
use crate::commands::run::{options, with_threads};
use crate::commands::{print_json, print_out};
use crate::exit::Exit;
use crate::folder::Folder;
use crate::interrupt;
use crate::live::Live;
use crate::open::{self, open};
use crate::progress::Progress;

/// Points computed between two looks at Ctrl-C and two writes.
const CHUNK: usize = 64;

/// One key with its values as text.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Over {
    /// Dotted key.
    pub(crate) key: String,
    /// Right-hand sides of `--set`.
    pub(crate) values: Vec<String>,
}

/// Computes all points and writes sweep.csv and sweep.jsonl.
pub(crate) fn run(args: &SweepArgs) -> Result<Exit, Fault> {
    let start = Instant::now();
    let common = &args.common;
    // Rows hold no lists.
    let options = Options { machining: false, ..options(common)? };
    let grid = args.over.iter().map(|over| read_over(over)).collect::<Result<Vec<Over>, Fault>>()?;
    let count = grid.iter().map(|over| over.values.len()).try_fold(1usize, |n, m| n.checked_mul(m));
    let Some(count) = count.filter(|count| *count <= 10_000_000) else {
        return Err(Fault::new("wrong-flag", "the grid has more than ten million points", "give fewer values"));
    };
    let settings = |point: usize| settings_of(&grid, point, &common.set);
    let (first, beside) = open(&args.scene, &settings(0))?;
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
    let plan = json!({ "scene": args.scene, "set": common.set, "over": args.over, "sample": common.sample });
    // A first point without an answer is a row like any other; its scene stays as it is written.
    let (resolved, files) = Problem::new(&first, &|path| beside.read(path))
        .map_or_else(|_| (first.scene.clone(), Vec::new()), |problem| (problem.scene().clone(), problem.files()));
    let mark = format!("# {}\n{}", plan, scene::scene_text(&resolved)?);
    let folder = Folder::begin(&target, common.resume)?;
    if common.resume {
        folder.same_scene(&mark)?;
    }
    let mut rows = if common.resume { finished_rows(&folder) } else { Vec::new() };
    rows.truncate(count);
    folder.write("scene.resolved.toml", &mark)?;
    for (name, bytes) in files {
        folder.write_bytes(&name, &bytes)?;
    }
    folder.write("sweep.jsonl", &lines(&rows))?;
    let bodies = Bodies::default();
    let progress = Progress::counted(common, count);
    while rows.len() < count {
        if interrupt::asked() {
            progress.end();
            eprintln!("interrupted after {} of {count} points; continue with --resume", rows.len());
            return Ok(Exit::Interrupted);
        }
        let chunk: Vec<usize> = (rows.len()..count.min(rows.len() + CHUNK)).collect();
        let new = in_threads(common, &chunk, |point| row(&args.scene, (&grid, point), &settings(point), &options, &bodies))?;
        folder.append("sweep.jsonl", &lines(&new))?;
        rows.extend(new);
        progress.done(rows.len());
    }
    progress.end();
    folder.write("sweep.csv", &table(&rows))?;
    folder.write("timing.json", &report::pretty(&json!({ "seconds_total": start.elapsed().as_secs_f64(), "points": count })))?;
    let failed = rows.iter().filter(|row| row["status"] != "ok").count();
    let summary = json!({
        "schema_version": SCHEMA_VERSION,
        "version": env!("CARGO_PKG_VERSION"),
        "scene": first.name,
        "scene_sha256": scene::sha256(&mark),
        "status": if failed == 0 { Status::Ok } else { Status::NotConverged },
        "verdict": format!("{count} points, {failed} without an answer."),
        "over": grid.iter().map(|over| (over.key.clone(), json!(over.values))).collect::<Map<_, _>>(),
        "points": count,
        "failed": failed,
        "counters": { "factorisations": bodies.factorisations(), "factorisations_saved": bodies.reused() },
    });
    folder.write("summary.json", &report::pretty(&summary))?;
    folder.finish()?;
    if common.json {
        print_json(&summary);
    } else if !common.quiet {
        print_out(&format!("{count} points, {failed} without an answer\nfiles     {}\n", target.join("sweep.csv").display()));
    }
    Ok(if failed == 0 { Exit::Done } else { Exit::GoalMissed })
}

/// `key=from:to:count` or `key=a,b,c`; commas inside brackets and quotes do not separate.
pub(crate) fn read_over(text: &str) -> Result<Over, Fault> {
    let wrong = |message: String| Fault {
        place: Some(Place::Flag(format!("--over {text}"))),
        ..Fault::new("wrong-flag", message, "write --over optimum.q=0.5:3:20 or --over contact.friction=0,.1,.25")
    };
    let Some((key, values)) = text.split_once('=') else {
        return Err(wrong(format!("--over {text} has no `=`")));
    };
    let key = key.trim().to_string();
    if key.is_empty() {
        return Err(wrong(format!("--over {text} has no key")));
    }
    let parts: Vec<&str> = values.split(':').collect();
    if let [from, to, count] = parts[..]
        && let (Ok(from), Ok(to)) = (from.trim().parse::<f64>(), to.trim().parse::<f64>())
    {
        let count: usize = count.trim().parse().map_err(|_| wrong(format!("`{count}` is no number of values")))?;
        if count == 0 || !from.is_finite() || !to.is_finite() {
            return Err(wrong(format!("`{values}` has no values")));
        }
        let last = (count - 1).max(1) as f64;
        let value = |i: usize| {
            let t = i as f64 / last;
            if i + 1 == count && count > 1 { to } else { from + (to - from) * t }
        };
        return Ok(Over { key, values: (0..count).map(|i| scene::number_text(value(i))).collect() });
    }
    let mut list = vec![String::new()];
    let (mut depth, mut quote) = (0i32, None);
    for c in values.chars() {
        match (c, quote) {
            ('"' | '\'', None) => quote = Some(c),
            (c, Some(q)) if c == q => quote = None,
            ('[' | '{', None) => depth += 1,
            (']' | '}', None) => depth -= 1,
            (',', None) if depth == 0 => {
                list.push(String::new());
                continue;
            }
            _ => {}
        }
        if let Some(last) = list.last_mut() {
            last.push(c);
        }
    }
    let values: Vec<String> = list.iter().map(|value| value.trim().to_string()).collect();
    if values.iter().any(String::is_empty) {
        return Err(wrong(format!("--over {text} has an empty value")));
    }
    Ok(Over { key, values })
}

/// Values of the grid at a point; the last key turns fastest.
fn values_of(grid: &[Over], mut point: usize) -> Vec<&str> {
    let mut values = vec![""; grid.len()];
    for (place, over) in grid.iter().enumerate().rev() {
        values[place] = &over.values[point % over.values.len()];
        point /= over.values.len();
    }
    values
}

fn settings_of(grid: &[Over], point: usize, set: &[String]) -> Vec<String> {
    let mut all = set.to_vec();
    all.extend(grid.iter().zip(values_of(grid, point)).map(|(over, value)| format!("{}={value}", over.key)));
    all
}

/// Rows of some points, on as many threads as asked for, up to the first that Ctrl-C has cut short.
fn in_threads(
    common: &Common,
    points: &[usize],
    row: impl Fn(usize) -> Option<Value> + Sync + Send,
) -> Result<Vec<Value>, Fault> {
    let rows = with_threads(common, || points.par_iter().map(|point| row(*point)).collect::<Vec<Option<Value>>>())?;
    Ok(rows.into_iter().map_while(|row| row).collect())
}

/// One row: the keys, the status, the numbers of the summary. None if Ctrl-C has cut it short.
fn row(
    scene: &str,
    (grid, point): (&[Over], usize),
    settings: &[String],
    options: &Options<'_>,
    bodies: &Bodies,
) -> Option<Value> {
    let mut row = Map::new();
    for (over, value) in grid.iter().zip(values_of(grid, point)) {
        row.insert(over.key.clone(), value.parse::<f64>().ok().filter(|v| v.is_finite()).map_or(json!(value), |v| json!(v)));
    }
    let computed = open::problem(scene, settings).and_then(|(document, problem)| {
        problem.available().map_err(|fault| document.locate(fault))?;
        let solution = Live::silent().solve(&problem, options, bodies).map_err(|fault| document.locate(fault))?;
        Ok((solution.status, report::summary(&problem, &solution)?))
    });
    if matches!(computed, Ok((Status::Interrupted, _))) {
        return None;
    }
    match computed {
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
    report::table(&names, rows.iter().map(|row| columns.iter().map(|key| cell(row.get(key.as_str()))).collect()))
}
