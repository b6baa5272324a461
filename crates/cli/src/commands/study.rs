//! `wearshape study`: error against run time, degree by degree.

use std::ops::ControlFlow;
use std::path::{Path, PathBuf};

use report::{Axis, LinePlot, Series, line_plot, numbers_row, table};
use scene::{Fault, Place};
use wearshape::{DEGREES, Event, Measure, Quantity, Step, StudyLevel, Truth, outermost, study};

use crate::again::again;
use crate::args::StudyArgs;
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

/// Solves a scene on a ladder of degrees and writes study.csv, study.json and study.svg.
pub(crate) fn run(args: &StudyArgs) -> Result<Exit, Fault> {
    let common = &args.common;
    let source = Source::read(&args.scene)?;
    let (document, problem) = source.problem(&common.set)?;
    let Some(quantity) = Quantity::of(&problem) else {
        let remedy = "add a task with elastic bodies: --set tasks=[pressure,shape]";
        return Err(document.locate(Fault::at(
            "tasks",
            "not-available",
            "study compares meshes, and this scene needs none",
            remedy,
        )));
    };
    let truth = args.reference.as_deref().map(|folder| reference(folder, &problem.resolved())).transpose()?;
    problem.available().map_err(|fault| document.locate(fault))?;
    let target = common.output.clone().unwrap_or_else(|| PathBuf::from("out").join(format!("{}-study", problem.name())));
    if common.dry_run {
        print_out(&format!("would solve {} degrees and write {}\n", DEGREES.len(), target.display()));
        return Ok(Exit::Done);
    }
    let against = args.reference.as_ref().map_or_else(|| "the finest degree".into(), |folder| folder.display().to_string());
    let threads = threads(common)?;
    interrupt::listen();
    let resolved = problem.resolved();
    let folder = Folder::begin(&target, &resolved, false)?;
    let levels = match threads.install(|| levels(args, &source, truth)) {
        Ok(Some(levels)) => levels,
        ended => {
            folder.discard();
            ended.map_err(|fault| document.locate(fault))?;
            talk(&format!("interrupted; {}", call(args)));
            return Ok(Exit::Interrupted);
        }
    };
    let rows: Vec<[f64; 12]> = levels.iter().map(row).collect();
    let object = |row: &[f64; 12]| -> serde_json::Value {
        let known = COLUMNS.iter().zip(row).filter(|(_, value)| value.is_finite());
        known.map(|(name, value)| (name.to_string(), serde_json::json!(value))).collect::<serde_json::Map<_, _>>().into()
    };
    let summary = serde_json::json!({
        "schema_version": report::SCHEMA_VERSION,
        "version": env!("CARGO_PKG_VERSION"),
        "scene": problem.name(),
        "scene_sha256": scene::sha256(&resolved),
        "quantity": quantity.description(),
        "truth": against,
        "levels": rows.iter().map(object).collect::<Vec<_>>(),
    });
    folder.write("study.csv", &table(&COLUMNS, rows.iter().map(|row| numbers_row(row))))?;
    folder.write("study.json", &report::pretty(&summary))?;
    folder.write("study.svg", &line_plot(&picture(problem.name(), quantity, &against, &rows)))?;
    let summary = folder.finish(&summary)?;
    if common.json {
        print_json(&summary);
    } else if !common.quiet {
        print_out(&screen(&rows, quantity, &target));
    }
    Ok(Exit::Done)
}

/// The levels of a study; none if Ctrl-C has ended it between two levels or steps.
fn levels(args: &StudyArgs, source: &Source, truth: Option<Truth>) -> Result<Option<Vec<StudyLevel>>, Fault> {
    let at = |degree: usize| {
        let mut settings = args.common.set.clone();
        settings.extend([format!("mesh.degree={degree}"), "check=false".into()]);
        source.problem(&settings).map(|(_, problem)| problem)
    };
    let progress = Progress::new(&args.common);
    let mut degrees = 0;
    let mut watch = |event: Event<'_>| {
        if let Event::Level { degree, .. } = event {
            degrees += 1;
            progress.say(&format!("degree {degree}, {degrees} of {}", DEGREES.len()));
        }
        if interrupt::asked() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    };
    match study(&at, truth, seconds, &mut watch) {
        // A level that was cut short is a fault of the study; nothing is wrong with it.
        Err(_) if interrupt::asked() => Ok(None),
        solved => solved.map(Some),
    }
}

/// How an interrupted study begins again: its levels are compared with the finest one, so that none is of use alone.
fn call(args: &StudyArgs) -> String {
    let reference = args.reference.as_ref().map(|folder| folder.display().to_string());
    let mut words = vec!["study", &args.scene];
    words.extend(reference.iter().flat_map(|folder| ["--reference", folder]));
    again(&words, &args.common, None)
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
fn reference(folder: &Path, resolved: &str) -> Result<Truth, Fault> {
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
    Ok(Truth {
        position: vectors(["x_mm", "y_mm", "z_mm"])?,
        normal: vectors(["nx", "ny", "nz"])?,
        pressure: column("pressure_MPa")?,
        gap: column("gap_um")?,
        ends: outermost(&ends, &s),
        energy: energy("body1_Nmm").map(|first| first + energy("body2_Nmm").unwrap_or(0.0)),
        s,
    })
}

fn row(level: &StudyLevel) -> [f64; 12] {
    let seconds = |stages: &[Step]| -> f64 {
        level.effort.seconds.iter().filter(|(step, _)| stages.contains(step)).map(|(_, seconds)| seconds).sum()
    };
    [
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
        level.error.unwrap_or(f64::NAN),
    ]
}

fn picture(name: &str, quantity: Quantity, against: &str, rows: &[[f64; 12]]) -> LinePlot {
    let series = |label: String, column: usize, dashed: bool| Series {
        name: label,
        points: rows.iter().filter(|row| row[column].is_finite()).map(|row| (row[9], row[column])).collect(),
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

fn screen(rows: &[[f64; 12]], quantity: Quantity, target: &Path) -> String {
    let mut out = String::from("degree  unknowns   seconds  estimated      true\n");
    let number = |value: f64| if value.is_finite() { format!("{value:.1e}") } else { "-".into() };
    for row in rows {
        out += &format!("{:>6}  {:>8}  {:>8.4}  {:>9}  {:>8}\n", row[0], row[2], row[9], number(row[10]), number(row[11]));
    }
    out + &format!("error     {}\nfiles     {}\n", quantity.description(), target.display())
}
