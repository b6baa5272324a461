//! `wearshape sweep`: a scene over a grid of keys, one row a point, failures kept as rows.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::time::Instant;

use rayon::prelude::*;
use report::SCHEMA_VERSION;
use scene::{Document, Fault, Place};
use serde_json::{Map, Value, json};
use wearshape::{Bodies, Options, Profile, Solution, Status};

use crate::again::again;
use crate::args::SweepArgs;
use crate::exit::Exit;
use crate::folder::Folder;
use crate::grid::{Grid, texts};
use crate::interrupt;
use crate::live::Live;
use crate::open::Source;
use crate::options::{options, threads};
use crate::print::{print_json, print_out, talk};
use crate::progress::Progress;
use crate::sweep::curves::{self, CURVES};
use crate::sweep::figures::Figures;
use crate::sweep::rows::{BASE, ROWS, Rows, axis_value};

/// Points computed between two writes.
const CHUNK: usize = 64;

/// What every point of a sweep needs.
struct Sweep<'a> {
    args: &'a SweepArgs,
    source: Source,
    grid: Grid,
    /// Values of axes in base units, by key and what was typed.
    base: BTreeMap<(String, String), f64>,
    options: Options<'static>,
    /// Columns of the curves that not every scene has.
    extras: Vec<&'static str>,
    bodies: Bodies,
}

/// The row of a point, and its curves.
struct Point {
    row: Value,
    curve: Curve,
}

/// The curves of a point.
enum Curve {
    /// As they are written: those of every point are kept.
    Written(String),
    /// Those of few points are kept.
    Known(Box<Profile>),
    /// There are none.
    Absent,
}

/// A fault of a setting that comes from the grid, in the words of its `--over`.
fn as_over(fault: Fault, args: &SweepArgs) -> Fault {
    let Some(Place::Flag(flag)) = &fault.place else { return fault };
    let setting = flag.strip_prefix("--set ").filter(|setting| !args.common.set.iter().any(|set| set == setting));
    let key = |text: &str| text.split_once('=').map(|(key, _)| key.trim().to_string());
    let of_grid = setting.and_then(key).and_then(|own| args.over.iter().find(|over| key(over).as_deref() == Some(&own)));
    let Some(over) = of_grid else { return fault };
    Fault { place: Some(Place::Flag(format!("--over {over}"))), ..fault }
}

/// Computes all points; writes their rows, curves and page.
pub(crate) fn run(args: &SweepArgs) -> Result<Exit, Fault> {
    let start = Instant::now();
    let common = &args.common;
    // Rows hold no long lists.
    let options = Options { machining: false, ..options(&args.points)? };
    let grid = Grid::read(&args.over)?;
    let source = Source::read(&args.scene)?;
    let first = source.document(&grid.settings(0, &common.set)).map_err(|fault| as_over(fault, args))?;
    let count = grid.count;
    let target = common.output.clone().unwrap_or_else(|| PathBuf::from("out").join(format!("{}-sweep", first.name)));
    if common.dry_run {
        if common.json {
            print_json(&json!({ "scene": first.name, "points": count, "folder": target.display().to_string() }));
        } else {
            print_out(&format!("{count} {} of {}\nwould write {}\n", points(count), first.name, target.display()));
        }
        return Ok(Exit::Done);
    }
    let base = base_units(&source, &grid, &common.set);
    let extras = curves::extras(&first.scene, &grid);
    let sweep = Sweep { args, source, grid, base, options, extras, bodies: Bodies::default() };
    let threads = threads(common.threads)?;
    interrupt::listen();
    let (folder, mark) = sweep.begin(&target, &first)?;
    let mut rows = sweep.finished(&folder)?;
    let before = rows.count;
    threads.install(|| sweep.compute(&folder, &mut rows))?;
    if rows.count < count {
        let words = [&["sweep", &args.scene][..], &sweep.over()].concat();
        let again = again(&words, (common, &args.points), Some("every finished row"));
        talk(&format!("interrupted after {} of {count} points; {again}", rows.count));
        return Ok(Exit::Interrupted);
    }
    rows.write_table(&folder, &sweep.grid)?;
    folder.write(
        "timing.json",
        &report::pretty(&json!({ "seconds_total": start.elapsed().as_secs_f64(), "points": count - before })),
    )?;
    if sweep.options.sample.is_none() {
        curves::leave_drawn(&folder, &rows.drawn)?;
    }
    let figures = Figures::new(&sweep.grid, &rows.first);
    let summary = sweep.summary(&first.name, &mark, rows.failed, before);
    folder.write("report.html", &page(folder.path(), &sweep.grid, &summary, &rows, &mark))?;
    let unanswered = rows.answered == 0;
    let (summary, beside) = if unanswered { folder.finish_beside_good(&summary)? } else { (folder.finish(&summary)?, None) };
    if beside.is_some() && !common.quiet {
        talk(&format!("{} keeps the sweep of before", target.display()));
    }
    if common.json {
        print_json(&summary);
    } else if !common.quiet {
        print_out(&screen(&figures, &rows, before, beside.as_deref().unwrap_or(&target)));
    }
    Ok(if rows.failed == 0 { Exit::Done } else { Exit::GoalMissed })
}

impl Sweep<'_> {
    /// The `--over` options as words.
    fn over(&self) -> Vec<&str> {
        self.args.over.iter().flat_map(|over| ["--over", over]).collect()
    }

    /// Begins the folder with the scene of the first point, headed by what the sweep is, and its files; refuses to go on with another sweep. Returns
    /// that text too.
    fn begin(&self, target: &Path, first: &Document) -> Result<(Folder, String), Fault> {
        let common = &self.args.common;
        let plan =
            json!({ "scene": self.args.scene, "set": common.set, "over": self.args.over, "sample": self.args.points.sample });
        // A first point without an answer is a row like any other; its scene stays as it is written.
        let posed = self.source.pose(first);
        let (resolved, files) =
            posed.map_or_else(|_| (first.scene.clone(), Vec::new()), |problem| (problem.scene().clone(), problem.files()));
        let mark = format!("# {plan}\n{}{}", self.files_of_axes(), scene::scene_text(&resolved));
        let folder = Folder::begin(target, &mark, self.args.points.resume)?;
        folder.write_files_of_scene(files)?;
        Ok((folder, mark))
    }

    /// What the files hold that values of axes name, a line each: as they are now, and not only those of the first point.
    fn files_of_axes(&self) -> String {
        let files = self.grid.words().flat_map(|(_, value)| texts(value));
        let files: BTreeSet<String> = files.filter(|path| self.source.is_beside(path)).collect();
        let line = |path: &String| {
            let bytes = self.source.beside(path).ok()?;
            Some(format!("# {} has sha256 {}\n", json!(path), scene::sha256(bytes)))
        };
        files.iter().filter_map(line).collect()
    }

    /// The rows that are there already; what was torn behind them is cut off.
    fn finished(&self, folder: &Folder) -> Result<Rows, Fault> {
        let mut rows = Rows::default();
        let length = rows.see_finished(&folder.path().join(ROWS), &self.grid);
        folder.cut(ROWS, length)?;
        let kept = curves::length_of(&folder.path().join(CURVES), rows.count);
        folder.cut(CURVES, kept)?;
        if kept == 0 {
            folder.append(CURVES, &curves::header(&self.grid, &self.extras))?;
        }
        Ok(rows)
    }

    /// Adds the rows that are missing, and writes them as they come; Ctrl-C ends it with those that are finished.
    fn compute(&self, folder: &Folder, rows: &mut Rows) -> Result<(), Fault> {
        let count = self.grid.count;
        let progress = Progress::counted(&self.args.common, count);
        progress.done(rows.count);
        // The first point is computed alone: what it factorises serves the others.
        let mut size = 1;
        while rows.count < count && !interrupt::asked() {
            let chunk = rows.count..count.min(rows.count + std::mem::replace(&mut size, CHUNK));
            // The points are begun in their order, so that few rows stand behind the first that is cut short.
            let mut new: Vec<(usize, Point)> =
                chunk.clone().par_bridge().filter_map(|point| Some((point, self.point(point)?))).collect();
            new.sort_by_key(|(point, _)| *point);
            let whole = chunk.zip(new).map_while(|(point, (of, found))| (point == of).then_some(found));
            let new: Vec<Point> = whole.collect();
            let mut curves = String::new();
            for Point { row, curve } in &new {
                let point = rows.count;
                let drawn = rows.see(row, count);
                match curve {
                    Curve::Written(text) => curves += text,
                    Curve::Known(profile) if drawn => curves += &curves::curve(&self.grid, point, profile, &self.extras),
                    Curve::Known(_) | Curve::Absent => {}
                }
            }
            // Curves first: a row that is there has its curves.
            folder.append(CURVES, &curves)?;
            folder.append(ROWS, &new.iter().map(|point| format!("{}\n", point.row)).collect::<String>())?;
            progress.done(rows.count);
        }
        progress.end();
        Ok(())
    }

    /// One point: the keys, the status, the numbers of the summary. None if Ctrl-C has cut it short.
    fn point(&self, point: usize) -> Option<Point> {
        if interrupt::asked() {
            return None;
        }
        let mut row = Map::new();
        for (key, value) in self.grid.at(point) {
            row.insert(key.into(), axis_value(&value));
            let base = self.base.get(&(key.to_string(), value.to_string())).copied();
            let finite = || value.parse().ok().filter(|number: &f64| number.is_finite());
            let bare = || finite().filter(|_| self.base.keys().any(|(of, _)| of == key));
            if let Some(base) = base.or_else(bare) {
                row.insert(format!("{key}{BASE}"), json!(base));
            }
        }
        let mut curve = Curve::Absent;
        match self.solve(&self.grid.settings(point, &self.args.common.set)) {
            Ok((solution, _)) if solution.status == Status::Interrupted => return None,
            Ok((solution, summary)) => {
                let skipped = ["schema_version", "version", "scene", "scene_sha256"];
                for (key, value) in report::numbers_and_short_lists(&summary) {
                    if !skipped.contains(&key.as_str()) && !key.starts_with("counters.") {
                        row.insert(key, value);
                    }
                }
                curve = self.curve(point, solution);
            }
            Err(fault) => {
                row.insert("status".into(), json!("invalid"));
                row.insert("verdict".into(), json!(fault.message));
            }
        }
        Some(Point { row: Value::Object(row), curve })
    }

    /// The curves of a point: with --sample at so many places, else fine ones.
    fn curve(&self, point: usize, solution: Solution) -> Curve {
        if self.options.sample.is_some() {
            let written = |profile| Curve::Written(curves::curve(&self.grid, point, profile, &self.extras));
            return solution.profile.as_ref().map_or(Curve::Absent, written);
        }
        solution.curve.or(solution.profile).map_or(Curve::Absent, |profile| Curve::Known(Box::new(profile)))
    }

    /// Solution and summary of the scene with some settings.
    fn solve(&self, settings: &[String]) -> Result<(Solution, Value), Fault> {
        let (document, problem) = self.source.problem(settings)?;
        problem.available().map_err(|fault| document.locate(fault))?;
        let solved = Live::silent().solve(&problem, &self.options, &self.bodies);
        let solution = solved.map_err(|fault| document.locate(fault))?;
        let summary = report::summary(&problem, &solution);
        Ok((solution, summary))
    }

    /// The summary; what was counted is of this call alone, which took over the points `before`.
    fn summary(&self, name: &str, mark: &str, failed: usize, before: usize) -> Value {
        let count = self.grid.count;
        let mut summary = json!({
            "schema_version": SCHEMA_VERSION,
            "version": env!("CARGO_PKG_VERSION"),
            "scene": name,
            "scene_sha256": scene::sha256(mark),
            "status": if failed == 0 { Status::Ok } else { Status::NotConverged },
            "verdict": format!("{count} {}, {failed} without an answer.", points(count)),
            "over": self.grid.document(),
            "points": count,
            "failed": failed,
            "counters": { "factorisations": self.bodies.factorisations(), "factorisations_saved": self.bodies.reused() },
        });
        if before > 0 {
            summary["counters"]["points"] = json!(count - before);
        }
        summary
    }
}

/// report.html from the files of a folder.
fn page(folder: &Path, grid: &Grid, summary: &Value, rows: &Rows, mark: &str) -> String {
    let named = toml::from_str::<toml::Table>(mark).ok().and_then(|scene| Some(scene.get("title")?.as_str()?.to_string()));
    let title = named.as_deref().or(summary["scene"].as_str()).unwrap_or("");
    let figures = Figures::new(grid, &rows.first);
    report::sweep_page(&report::SweepPage {
        title,
        summary,
        plots: &curves::plots(&folder.join(CURVES), grid, &rows.drawn, title),
        names: &figures.names,
        rows: &figures.rows,
        reasons: &figures.reasons,
        resolved: mark,
    })
}

/// The page of a finished sweep, built again; none where the scene of the folder is not headed by what was swept.
pub(super) fn page_again(folder: &Path, read: &dyn Fn(&str) -> Option<Vec<u8>>, there: &dyn Fn(&str) -> bool) -> Option<String> {
    let text = |name: &str| String::from_utf8(read(name)?).ok();
    let mark = text("scene.resolved.toml")?;
    let plan: Value = serde_json::from_str(mark.lines().next()?.strip_prefix("# ")?).ok()?;
    let over: Vec<String> = serde_json::from_value(plan["over"].clone()).ok()?;
    let grid = Grid::read(&over).ok().filter(|_| !over.is_empty())?;
    let summary: Value = serde_json::from_str(&text("summary.json")?).ok()?;
    let mut rows = Rows::default();
    // Read line by line: only what is shown is kept.
    (there(CURVES) && there(ROWS)).then_some(())?;
    rows.see_finished(&folder.join(ROWS), &grid);
    Some(page(folder, &grid, &summary, &rows, &mark))
}

/// Values of axes that were typed with a unit, in base units.
fn base_units(source: &Source, grid: &Grid, set: &[String]) -> BTreeMap<(String, String), f64> {
    let number = |key: &str, value: &str| {
        let mut settings = grid.settings(0, set);
        settings.push(format!("{key}={value}"));
        let document = source.document(&settings).ok()?;
        let table: toml::Table = toml::from_str(&scene::scene_text(&document.scene)).ok()?;
        let (first, rest) = key.split_once('.').unwrap_or((key, ""));
        let mut inner = rest.split('.').filter(|part| !part.is_empty());
        inner.try_fold(table.get(first)?, |value, part| value.get(part))?.as_float()
    };
    grid.words().filter_map(|(key, value)| Some(((key.into(), value.into()), number(key, value)?))).collect()
}

fn points(count: usize) -> &'static str {
    if count == 1 { "point" } else { "points" }
}

/// The first screen: the points, then what is left to say.
fn screen(figures: &Figures, rows: &Rows, before: usize, target: &Path) -> String {
    let mut out = figures.screen();
    if rows.count > rows.first.len() {
        out += &format!("and {} more rows in sweep.csv\n", rows.count - rows.first.len());
    }
    let (count, failed, target) = (rows.count, rows.failed, target.display());
    let kept = if before > 0 { format!(" ({before} of them from before)") } else { String::new() };
    let points = points(count);
    out + &format!("\n{count} {points}{kept}, {failed} without an answer\nfiles     {target} (sweep.csv, report.html)\n")
}
