//! `wearshape study`: error against run time, degree by degree.

use std::path::PathBuf;

use crate::args::StudyArgs;
use crate::commands::run::with_threads;
use crate::commands::{print_json, print_out};
use crate::document::Document;
use crate::exit::Exit;
use crate::fault::Fault;
use crate::fe::{StudyLevel, study};
use crate::profile::number_text;
use crate::report::line_plot::{Axis, LinePlot, Series, line_plot};
use crate::report::{self, Folder};
use crate::setup::setup;

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

/// Solves the shape of a scene on a ladder of degrees and writes study.csv, study.json and study.svg.
pub(crate) fn run(args: &StudyArgs) -> Result<Exit, Fault> {
    let common = &args.common;
    let document = Document::open(&args.scene, &common.set)?;
    let problem = setup(&document)?;
    if !problem.plan.runs("shape") {
        let remedy = "add the task: --set tasks=[pressure,shape]";
        return Err(Fault::new("not-available", "study compares shapes, and this scene asks for none", remedy));
    }
    if args.reference.is_some() {
        let remedy = "leave --reference out: the finest degree is the truth";
        return Err(Fault::new("not-available", "--reference is not available yet", remedy));
    }
    crate::fe::available(&problem).map_err(|fault| document.locate(fault))?;
    let target = common.output.clone().unwrap_or_else(|| PathBuf::from("out").join(format!("{}-study", problem.name)));
    if common.dry_run {
        print_out(&format!("would solve 7 degrees and write {}\n", target.display()));
        return Ok(Exit::Done);
    }
    let folder = Folder::begin(&target, false)?;
    let levels = match with_threads(common, || study(&problem))? {
        Ok(levels) => levels,
        Err(fault) => {
            folder.discard();
            return Err(document.locate(fault));
        }
    };
    let rows: Vec<[f64; 12]> = levels.iter().map(row).collect();
    let mut table = COLUMNS.join(",") + "\n";
    for row in &rows {
        table += &(row.iter().map(|v| number_text(*v)).collect::<Vec<_>>().join(",") + "\n");
    }
    let object = |row: &[f64; 12]| -> serde_json::Value {
        let known = COLUMNS.iter().zip(row).filter(|(_, value)| value.is_finite());
        known.map(|(name, value)| (name.to_string(), serde_json::json!(value))).collect::<serde_json::Map<_, _>>().into()
    };
    let document = serde_json::json!({
        "schema_version": report::SCHEMA_VERSION,
        "version": env!("CARGO_PKG_VERSION"),
        "scene": problem.name,
        "quantity": "max |dg| / max g, rigid part removed; error_true against the finest degree",
        "levels": rows.iter().map(object).collect::<Vec<_>>(),
    });
    folder.write("study.csv", &table)?;
    folder.write("study.json", &report::pretty(&document))?;
    folder.write("study.svg", &line_plot(&picture(&problem.name, &rows)))?;
    folder.write("scene.resolved.toml", &report::resolved(&problem)?)?;
    // Marks the folder as ours, so that the next study may replace it.
    folder.write("summary.json", &report::pretty(&document))?;
    folder.finish()?;
    if common.json {
        print_json(&document);
    } else if !common.quiet {
        print_out(&screen(&rows, &target));
    }
    Ok(Exit::Done)
}

fn row(level: &StudyLevel) -> [f64; 12] {
    let seconds = |stage: &str| level.times.iter().filter(|(name, _)| name == stage).map(|(_, s)| s).sum::<f64>();
    [
        level.degree as f64,
        level.layers as f64,
        level.counters.dofs as f64,
        level.counters.trace_dofs as f64,
        seconds("mesh"),
        seconds("assemble"),
        seconds("factor"),
        seconds("interface"),
        seconds("shape"),
        level.times.iter().map(|(_, s)| s).sum(),
        level.estimate.unwrap_or(f64::NAN),
        level.error.unwrap_or(f64::NAN),
    ]
}

fn picture(name: &str, rows: &[[f64; 12]]) -> LinePlot {
    let series = |label: &str, column: usize, dashed: bool| Series {
        name: label.to_string(),
        points: rows.iter().filter(|row| row[column].is_finite()).map(|row| (row[9], row[column])).collect(),
        marks: true,
        dashed,
    };
    LinePlot {
        title: format!("{name}: error of the gap against run time"),
        x_label: "seconds".into(),
        y_label: "max |dg| / max g".into(),
        axes: [Axis::Logarithmic, Axis::Logarithmic],
        from_zero: false,
        series: vec![series("against the finest degree", 11, false), series("estimated", 10, true)],
    }
}

fn screen(rows: &[[f64; 12]], target: &std::path::Path) -> String {
    let mut out = String::from("degree  unknowns   seconds  estimated      true\n");
    let number = |value: f64| if value.is_finite() { format!("{value:.1e}") } else { "-".into() };
    for row in rows {
        out += &format!("{:>6}  {:>8}  {:>8.4}  {:>9}  {:>8}\n", row[0], row[2], row[9], number(row[10]), number(row[11]));
    }
    out + &format!("files     {}\n", target.display())
}
