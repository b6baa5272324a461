//! `wearshape study`: error against run time, degree by degree.

use std::ops::ControlFlow;
use std::path::{Path, PathBuf};

use report::{Axis, LinePlot, Series, line_plot, numbers_row, table};
use scene::{Document, Fault, Place};
use wearshape::{
    DEGREES, Event, Measure, Options, Problem, Quantity, Status, Step, StudyLevel, Truth, Unstudied, outermost, study,
};

use crate::again::again;
use crate::args::{Common, Points, StudyArgs};
use crate::bounded;
use crate::clock::seconds;
use crate::diff::scenes;
use crate::exit::Exit;
use crate::folder::Folder;
use crate::interrupt;
use crate::open::Source;
use crate::options::threads;
use crate::print::{print_json, print_out, talk};
use crate::progress::Progress;

/// Columns of study.csv.
const COLUMNS: [&str; 12] = [
    "degree",
    "layers",
    "dofs",
    "trace_dofs",
    "seconds_mesh",
    "seconds_assemble",
    "seconds_factor",
    "seconds_interface",
    "seconds_contact",
    "seconds_total",
    "error_estimate",
    "error_true",
];
/// So many of them are counted.
const COUNTS: usize = 4;

/// What the levels of a study are compared with.
struct Against {
    /// Its name.
    name: String,
    /// None where it is the finest level.
    truth: Option<Truth>,
    /// The error that it tells of itself.
    error: Option<f64>,
}

/// Differences from a truth say nothing of a level up to so many times the error that it tells, for that may be off itself.
const SURE: f64 = 3.0;

impl Against {
    /// The least difference that says something.
    fn least(&self) -> Option<f64> {
        self.error.map(|error| SURE * error)
    }
}

/// A row of study.csv.
struct Row {
    numbers: [f64; 12],
    /// Whether the level is as near to the truth as that one's own error, so that its true error is not known.
    within: bool,
}

/// Solves a scene on a ladder of degrees and writes study.csv, study.json and study.svg.
pub(crate) fn run(args: &StudyArgs) -> Result<Exit, Fault> {
    let common = &args.common;
    let source = Source::read(&args.scene)?;
    let document = source.document(&common.set)?;
    let (_, problem) = source.problem(&settings(&document, &common.set))?;
    let Some(quantity) = Quantity::of(&problem) else {
        return Err(document.locate(meshless(&document)));
    };
    let mut against = match &args.reference {
        None => Against { name: "the finest degree".into(), truth: None, error: None },
        Some(folder) => reference(folder, &problem.resolved(), quantity)?,
    };
    problem.available().map_err(|fault| document.locate(fault))?;
    let target = common.output.clone().unwrap_or_else(|| PathBuf::from("out").join(format!("{}-study", problem.name())));
    if let Some(folder) = &args.reference {
        Folder::check_apart(&target, folder, "--reference")?;
    }
    if common.dry_run {
        dry_run(common, &problem, &target);
        return Ok(Exit::Done);
    }
    if !common.quiet {
        unused(&document, args).iter().for_each(|what| talk(what));
    }
    let threads = threads(common.threads)?;
    interrupt::listen();
    let folder = Folder::begin(&target, &problem.resolved(), false)?;
    let truth = against.truth.take();
    let found = Found { common, problem: &problem, quantity, against, target: &target };
    match threads.install(|| levels(args, &source, truth)) {
        Ok(levels) => found.keep(folder, &levels),
        Err(Unstudied::Unanswered { degree, status, reason }) => found.keep_unanswered(folder, degree, status, &reason),
        Err(Unstudied::Interrupted) => {
            folder.discard();
            talk(&format!("interrupted; {}", call(args)));
            Ok(Exit::Interrupted)
        }
        Err(Unstudied::Wrong(fault)) => {
            folder.discard();
            Err(document.locate(fault))
        }
    }
}

/// Refuses a scene whose tasks need no mesh.
fn meshless(document: &Document) -> Fault {
    let remedy = match document.scene.surface {
        Some(_) => "give body1 and body2 in place of `surface`, and tasks = [\"pressure\", \"shape\"]",
        None => "add a task with elastic bodies: --set tasks=[pressure,shape]",
    };
    Fault::at("tasks", "not-available", "study compares meshes, and this scene needs none", remedy)
}

/// What of the scene and the options a study does not use, with the reason.
fn unused(document: &Document, args: &StudyArgs) -> Vec<String> {
    let [first, .., last] = DEGREES;
    let degree = document.scene.mesh.as_ref().and_then(|mesh| mesh.degree);
    let degree = degree.map(|degree| format!("mesh.degree = {degree} is not used: a study solves the degrees {first} to {last}"));
    let sample = args.sample.map(|_| "--sample is not used: a study has no contact.csv".into());
    let resume = args.resume.then(|| "--resume is not used: a study begins anew".into());
    [degree, sample, resume].into_iter().flatten().collect()
}

/// The settings of the scene as a whole: where the layers are given, those of the finest level.
fn settings(document: &Document, set: &[String]) -> Vec<String> {
    let [.., finest] = DEGREES;
    let layers = document.scene.mesh.as_ref().map(|_| format!("mesh.degree={finest}"));
    set.iter().cloned().chain(layers).collect()
}

/// Says what would be done.
fn dry_run(common: &Common, problem: &Problem, target: &Path) {
    if common.json {
        print_json(&serde_json::json!({ "scene": problem.name(), "degrees": DEGREES, "folder": target.display().to_string() }));
    } else {
        print_out(&format!("would solve {} degrees and write {}\n", DEGREES.len(), target.display()));
    }
}

/// A study that has come to its end.
struct Found<'a> {
    common: &'a Common,
    problem: &'a Problem,
    quantity: Quantity,
    against: Against,
    target: &'a Path,
}

impl Found<'_> {
    /// Writes the folder and says what was found.
    fn keep(&self, folder: Folder, levels: &[StudyLevel]) -> Result<Exit, Fault> {
        let rows: Vec<Row> = levels.iter().map(|level| row(level, self.against.least())).collect();
        let within = rows.iter().filter(|row| row.within).count();
        let mut verdict = format!("{} degrees, compared with {}.", rows.len(), self.against.name);
        if let Some(least) = self.against.least().filter(|_| within > 0) {
            verdict +=
                &format!(" {within} of them are as near to it ({least:.0e}) as its own error: their true error is not known.");
        }
        let mut summary = self.summary(Status::Ok, &verdict, &rows);
        if let Some(error) = self.against.error {
            summary["truth_error"] = error.into();
        }
        folder.write("study.csv", &table(&COLUMNS, rows.iter().map(|row| numbers_row(&row.numbers))))?;
        folder.write("study.json", &report::pretty(&summary))?;
        folder.write("study.svg", &line_plot(&picture(self.problem.name(), self.quantity, &self.against.name, &rows)))?;
        let summary = folder.finish(&summary)?;
        self.print(&summary, || screen(&rows, self));
        Ok(Exit::Done)
    }

    /// Writes the folder of a scene without an answer, beside a good one, and says why.
    fn keep_unanswered(&self, folder: Folder, degree: usize, status: Status, reason: &str) -> Result<Exit, Fault> {
        let head = if status == Status::Refused { "This scene has no answer" } else { "The computation did not arrive" };
        let verdict = format!("{head}, at degree {degree}: {}.", scene::with_short_numbers(reason));
        let (summary, beside) = folder.finish_beside_good(&self.summary(status, &verdict, &[]))?;
        if beside.is_some() && !self.common.quiet {
            talk(&format!("{} keeps the study of before", self.target.display()));
        }
        let target = beside.as_deref().unwrap_or(self.target).display();
        self.print(&summary, || format!("{verdict}\nfiles     {target}\n"));
        Ok(Exit::of(status))
    }

    fn print(&self, summary: &serde_json::Value, screen: impl FnOnce() -> String) {
        if self.common.json {
            print_json(summary);
        } else if !self.common.quiet {
            print_out(&screen());
        }
    }

    fn summary(&self, status: Status, verdict: &str, rows: &[Row]) -> serde_json::Value {
        let object = |row: &Row| -> serde_json::Value {
            let known = COLUMNS.iter().zip(row.numbers).enumerate().filter(|(_, (_, value))| value.is_finite());
            // What is counted is whole.
            let number = |at, value: f64| if at < COUNTS { (value as u64).into() } else { serde_json::json!(value) };
            let known = known.map(|(at, (name, value))| (name.to_string(), number(at, value)));
            let within = row.within.then(|| ("within_truth_error".to_string(), true.into()));
            known.chain(within).collect::<serde_json::Map<_, _>>().into()
        };
        serde_json::json!({
            "schema_version": report::SCHEMA_VERSION,
            "version": env!("CARGO_PKG_VERSION"),
            "scene": self.problem.name(),
            "scene_sha256": scene::sha256(self.problem.resolved()),
            "status": status,
            "verdict": verdict,
            "quantity": self.quantity.description(),
            "truth": self.against.name,
            "levels": rows.iter().map(object).collect::<Vec<_>>(),
        })
    }
}

/// The levels of a study.
fn levels(args: &StudyArgs, source: &Source, truth: Option<Truth>) -> Result<Vec<StudyLevel>, Unstudied> {
    let at = |degree: usize| {
        let mut settings = args.common.set.clone();
        settings.extend([format!("mesh.degree={degree}"), "check=false".into()]);
        source.problem(&settings).map(|(_, problem)| problem)
    };
    let progress = Progress::new(&args.common);
    let options = Options { clock: seconds, ending: &interrupt::asked, ..Options::default() };
    let mut degrees = 0;
    let mut watch = |event: Event<'_>| {
        if let Event::Level { degree, .. } = event {
            degrees += 1;
            progress.say(&format!("degree {degree}, {degrees} of {}", DEGREES.len()));
        }
        if interrupt::asked() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    };
    // A level that was cut short may be at fault for that alone.
    study(&at, truth, &options, &mut watch).map_err(|why| if interrupt::asked() { Unstudied::Interrupted } else { why })
}

/// How an interrupted study begins again: its levels are compared with the finest one, so that none is of use alone.
fn call(args: &StudyArgs) -> String {
    let reference = args.reference.as_ref().map(|folder| folder.display().to_string());
    let mut words = vec!["study", &args.scene];
    words.extend(reference.iter().flat_map(|folder| ["--reference", folder]));
    again(&words, (&args.common, &Points::default()), None)
}

/// Keys that two runs of one problem may differ in: how finely it is computed, and what is written.
const FREE: [&str; 5] = ["accuracy", "check", "mesh", "output", "title"];

/// Refuses results of another scene; how finely it was computed is free.
fn same_problem(scene: &str, here: &str) -> Result<(), String> {
    let free = |key: &str| FREE.contains(&key.split('.').next().unwrap_or(key));
    let shown = |value: &Option<String>| value.clone().unwrap_or_else(|| "nothing".into());
    let apart: Vec<_> = scenes::compare([scene, here]).into_iter().filter(|(key, _)| !free(key)).collect();
    // Other tasks bring other keys with them.
    match apart.iter().find(|(key, _)| key == "tasks").or(apart.first()) {
        None => Ok(()),
        Some((key, [there, here])) => {
            Err(format!("it holds results of another scene: {key} is {} there and {} here", shown(there), shown(here)))
        }
    }
}

/// The results in the folder of a run of the same problem, as the truth.
fn reference(folder: &Path, resolved: &str, quantity: Quantity) -> Result<Against, Fault> {
    let fault = |message: String| Fault {
        place: Some(Place::Flag(format!("--reference {}", folder.display()))),
        ..Fault::new("no-reference", message, "give the folder of a finished run of the same scene: wearshape run SCENE -o DIR")
    };
    let read = |name: &str| {
        let path = folder.join(name);
        bounded::result_text(&path).map_err(|error| fault(format!("cannot read {}: {error}", path.display())))
    };
    same_problem(&read("scene.resolved.toml")?, resolved).map_err(&fault)?;
    let table = read("contact.csv")?;
    let column =
        |name: &str| report::column(&table, name).ok_or_else(|| fault(format!("contact.csv has no column `{name}` of numbers")));
    let vectors = |names: [&str; 3]| -> Result<Vec<[f64; 3]>, Fault> {
        let [x, y, z] = [column(names[0])?, column(names[1])?, column(names[2])?];
        Ok((0..x.len()).map(|i| [x[i], y[i], z[i]]).collect())
    };
    let summary: serde_json::Value =
        serde_json::from_str(&read("summary.json")?).map_err(|error| fault(format!("summary.json is not JSON: {error}")))?;
    let energy = |body: &str| summary["energy"][body].as_f64();
    let ends: Vec<f64> = summary["contact"]["ends_mm"].as_array().into_iter().flatten().filter_map(|end| end.as_f64()).collect();
    let s = column("s_mm")?;
    if s.len() < 3 {
        return Err(fault(format!("contact.csv has {} points", s.len())));
    }
    let truth = Truth {
        position: vectors(["x_mm", "y_mm", "z_mm"])?,
        normal: vectors(["nx", "ny", "nz"])?,
        pressure: column("pressure_MPa")?,
        gap: column("gap_um")?,
        ends: outermost(&ends, &s),
        energy: energy("body1_Nmm").map(|first| first + energy("body2_Nmm").unwrap_or(0.0)),
        s,
    };
    Ok(Against { name: folder.display().to_string(), truth: Some(truth), error: told(&summary["error"], quantity) })
}

/// The error that a finished run tells of a quantity.
fn told(error: &serde_json::Value, quantity: Quantity) -> Option<f64> {
    let keys: &[&str] = match quantity {
        Quantity::Gap(_) => &["gap_relative"],
        Quantity::Contact => &["energy_relative", "pressure_relative"],
    };
    keys.iter().filter_map(|key| error[key].as_f64()).reduce(f64::max)
}

fn row(level: &StudyLevel, least: Option<f64>) -> Row {
    let seconds = |stages: &[Step]| -> f64 {
        level.effort.seconds.iter().filter(|(step, _)| stages.contains(step)).fold(0.0, |sum, (_, seconds)| sum + seconds)
    };
    let within = level.error.zip(least).is_some_and(|(error, least)| error <= least);
    let numbers = [
        level.degree as f64,
        level.layers as f64,
        level.effort.counters.dofs as f64,
        level.effort.counters.trace_dofs as f64,
        seconds(&[Step::Mesh]),
        seconds(&[Step::Assemble]),
        seconds(&[Step::Factor]),
        seconds(&[Step::Interface]),
        seconds(&[Step::Contact, Step::Shape, Step::Evolution]),
        level.effort.seconds.iter().map(|(_, s)| s).sum(),
        level.estimate.unwrap_or(f64::NAN),
        level.error.filter(|_| !within).unwrap_or(f64::NAN),
    ];
    Row { numbers, within }
}

fn picture(name: &str, quantity: Quantity, against: &str, rows: &[Row]) -> LinePlot {
    let series = |label: String, column: usize, dashed: bool| Series {
        name: label,
        points: rows.iter().map(|row| (row.numbers[9], row.numbers[column])).filter(|point| point.1.is_finite()).collect(),
        marks: true,
        dashed,
    };
    let (what, y_label) = match quantity {
        Quantity::Gap(Measure::Largest) => ("the gap", "max |dg| / max g"),
        Quantity::Gap(Measure::Crown) => ("the gap", "max |dg| / (max g - min g)"),
        Quantity::Contact => ("the contact", "relative error of energy and pressure"),
    };
    LinePlot {
        title: format!("{name}: error of {what} against run time"),
        x_label: "seconds".into(),
        y_label: y_label.into(),
        axes: [Axis::Logarithmic, Axis::Logarithmic],
        from_zero: false,
        series: vec![series(format!("against {against}"), 11, false), series("estimated".into(), 10, true)],
    }
}

fn screen(rows: &[Row], found: &Found<'_>) -> String {
    let mut out = String::from("degree  unknowns   seconds  estimated      true\n");
    let number = |value: f64| if value.is_finite() { format!("{value:.1e}") } else { "-".into() };
    let least = found.against.least().map_or(String::new(), |least| format!("<{least:.0e}"));
    for row in rows {
        let [degree, _, dofs, .., seconds, estimate, error] = row.numbers;
        let error = if row.within { least.clone() } else { number(error) };
        out += &format!("{degree:>6}  {dofs:>8}  {seconds:>8.4}  {:>9}  {error:>8}\n", number(estimate));
    }
    if rows.iter().any(|row| row.within) {
        out += &format!("{least:<8}  as near to {} as that one's own error: the true error is not known\n", found.against.name);
    }
    out + &format!("error     {}\nfiles     {}\n", found.quantity.description(), found.target.display())
}
