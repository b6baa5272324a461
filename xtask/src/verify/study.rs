//! `cargo xtask verify --study`: error against seconds, wearshape and dolfinx side by side.
//!
//! One run, one thread each, both programs in turn, the least seconds of several repetitions. Seconds
//! run from the scene, read, to the answer, meshing included; the start of either program is left out,
//! and so is what dolfinx compiles.

mod case;
mod front;
mod ladder;
mod outcome;
mod page;
mod plot;

use case::Study;
use front::{Point, front, seconds_at};
use ladder::Setting;
use outcome::{Factor, Ladder, Outcome};
use serde_json::{Value, json};
use std::fs;
use std::path::Path;

/// Runs the studies of verify/study.toml, or the named ones; false when a truth or a factor is missed.
pub(crate) fn run(root: &Path, wearshape: &Path, names: &[String], repeat: usize, docs: bool) -> Result<bool, String> {
    let studies = case::read(&root.join("verify/study.toml"))?;
    if let Some(unknown) = names.iter().find(|name| studies.iter().all(|study| study.name != **name)) {
        let known: Vec<&str> = studies.iter().map(|study| study.name.as_str()).collect();
        return Err(format!("there is no study `{unknown}`; there are: {}", known.join(", ")));
    }
    if docs && !names.is_empty() {
        return Err("--docs writes all studies of one run: leave --case out".into());
    }
    let mut outcomes = Vec::new();
    for study in studies.into_iter().filter(|study| names.is_empty() || names.contains(&study.name)) {
        let outcome = one(root, wearshape, study, repeat)?;
        print(&outcome);
        outcomes.push(outcome);
    }
    let folder = root.join("target/verify");
    let save = |name: &str, text: String| {
        fs::write(folder.join(name), text).map_err(|error| format!("{}: {error}", folder.join(name).display()))
    };
    let machine = page::Machine::here(&outcomes, repeat);
    let cases: Vec<Value> = outcomes.iter().map(record).collect();
    save("study.json", format!("{:#}\n", json!({ "machine": machine.words, "cases": cases })))?;
    save("study.html", page::html(&outcomes, &machine))?;
    if docs {
        page::docs(root, &outcomes, &machine)?;
    }
    println!("{}\nverify: {}", machine.words, folder.join("study.html").display());
    Ok(outcomes.iter().all(|outcome| outcome.passed))
}

fn one(root: &Path, wearshape: &Path, study: Study, repeat: usize) -> Result<Outcome, String> {
    let folder = root.join("target/verify/study").join(&study.name);
    fs::create_dir_all(&folder).map_err(|error| format!("{}: {error}", folder.display()))?;
    let setting = Setting { root, wearshape, study: &study, folder: &folder };
    let truth = ladder::truth(&setting)?;
    let (sentences, mut passed) = known(root, &study, &truth)?;
    let mut ladders = Vec::new();
    for curve in &study.curves {
        let points = ladder::ours(&setting, curve, &truth)?;
        ladders.push(Ladder { name: format!("wearshape, {}", curve.name), ours: true, points });
    }
    // The first run compiles and is thrown away.
    let mut found = ladder::theirs(&setting, &truth)?;
    for number in 0..repeat {
        for (curve, ladder) in study.curves.iter().zip(&mut ladders) {
            let rows = ladder::times(&setting, curve)?;
            let seconds = rows.iter().map(|row| row["seconds_total"].as_f64().unwrap_or(f64::NAN));
            ladder.points.iter_mut().zip(seconds).for_each(|(point, seconds)| point.seconds = point.seconds.min(seconds));
        }
        let again = ladder::theirs(&setting, &truth)?;
        if number == 0 {
            found = again;
        } else {
            let pairs = found.points.iter_mut().zip(&again.points);
            pairs.for_each(|(point, again)| point.seconds = point.seconds.min(again.seconds));
            found.waited = found.waited.min(again.waited);
        }
    }
    ladders.iter_mut().for_each(|ladder| ladder.points.retain(|point| point.error > 0.0));
    ladders.push(Ladder { name: study.theirs.clone(), ours: false, points: found.points });
    let best = |ours: bool| front(ladders.iter().filter(|ladder| ladder.ours == ours).flat_map(|ladder| &ladder.points));
    let (ours, theirs) = (best(true), best(false));
    let least = |error: f64| study.least.iter().find(|(at, _)| *at == error).map(|(_, factor)| *factor);
    let factor = |error: &f64| Factor {
        error: *error,
        ours: seconds_at(&ours, *error),
        theirs: seconds_at(&theirs, *error),
        least: least(*error),
    };
    let factors: Vec<Factor> = study.factors.iter().map(factor).collect();
    passed &= !factors.iter().any(Factor::missed);
    Ok(Outcome { study, ladders, truth: sentences, factors, versions: found.versions, waited: found.waited, passed })
}

/// The truth against digits that others found.
fn known(root: &Path, study: &Study, truth: &ladder::Truth) -> Result<(Vec<String>, bool), String> {
    let mut passed = true;
    let mut sentences = Vec::new();
    let mut say = |what: String, difference: f64, within: f64| {
        let fine = difference <= within;
        passed &= fine;
        sentences.push(format!("{what}: difference {difference:.1e}{}", if fine { "" } else { " — MORE THAN ALLOWED" }));
    };
    for entry in &study.numbers {
        let at = entry.get("value").and_then(toml::Value::as_str).unwrap_or_default();
        let number = |key: &str| entry.get(key).and_then(case::number).ok_or(format!("{}: {at} needs {key}", study.name));
        let value = truth.summary.pointer(at).and_then(Value::as_f64).ok_or(format!("summary.json has no number {at}"))?;
        let (known, within) = (number("known")?, number("within")?);
        say(format!("{at} = {value}, known {known}"), (value / known - 1.0).abs(), within);
    }
    if let Some(entry) = &study.known {
        let word = |key: &str| entry.get(key).and_then(toml::Value::as_str).ok_or(format!("{}: known needs {key}", study.name));
        let file = super::tables::read_json(&root.join("data/reference").join(word("file")?))?;
        let list = |pointer: &str| -> Vec<f64> {
            file.pointer(pointer).and_then(Value::as_array).into_iter().flatten().filter_map(Value::as_f64).collect()
        };
        let (values, angles) = (list(word("at")?), list(word("places")?));
        let within = entry.get("within").and_then(case::number).ok_or("known needs within")?;
        let (x, z, ours) = (truth.table.column("nx")?, truth.table.column("nz")?, truth.table.column(&study.column)?);
        let nearest = |degrees: &f64| {
            let off = |i: usize| (x[i].atan2(z[i]).to_degrees() - degrees).abs();
            (0..x.len()).min_by(|a, b| off(*a).total_cmp(&off(*b))).filter(|i| off(*i) < 1e-9)
        };
        let rows: Vec<usize> = angles.iter().filter_map(nearest).collect();
        if rows.len() != values.len() || rows.len() < 3 {
            return Err(format!("{}: the places of the known digits are not among the samples", study.name));
        }
        let mode: Vec<f64> = rows.iter().map(|i| z[*i]).collect();
        let picked: Vec<f64> = rows.iter().map(|i| ours[*i]).collect();
        say(
            format!("{} at {} angles, {}", study.column, rows.len(), word("file")?),
            front::relative_l2(&picked, &values, &[mode]),
            within,
        );
    }
    if let Some(estimate) = truth.summary["error"]["gap_relative"].as_f64() {
        sentences.push(format!("its own estimate of the error of the gap: {estimate:.1e}"));
    }
    if let Some(estimate) = truth.summary["error"]["pressure_relative"].as_f64().filter(|_| study.column.starts_with("pressure"))
    {
        sentences.push(format!("its own estimate of the error of the pressure: {estimate:.1e}"));
    }
    Ok((sentences, passed))
}

fn print(outcome: &Outcome) {
    println!("\n{}", outcome.study.title);
    outcome.truth.iter().for_each(|sentence| println!("  truth: {sentence}"));
    for ladder in &outcome.ladders {
        println!("  {}", ladder.name);
        for point in &ladder.points {
            println!(
                "    {:<50} {:>8} unknowns  {:>9.4} s  error {:.1e}",
                point.label, point.unknowns, point.seconds, point.error
            );
        }
    }
    for factor in &outcome.factors {
        println!("  {}", page::sentence(factor));
    }
}

fn record(outcome: &Outcome) -> Value {
    let point = |p: &Point| json!({ "level": p.label, "unknowns": p.unknowns, "seconds": p.seconds, "error": p.error });
    let ladder = |l: &Ladder| json!({ "name": l.name, "ours": l.ours, "levels": l.points.iter().map(point).collect::<Vec<_>>() });
    let factor = |f: &Factor| json!({ "error": f.error, "seconds_ours": f.ours, "seconds_theirs": f.theirs, "factor": f.value(), "least": f.least });
    json!({
        "case": outcome.study.name, "title": outcome.study.title, "passed": outcome.passed, "truth": outcome.truth,
        "versions": outcome.versions, "wall_over_processor": outcome.waited,
        "ladders": outcome.ladders.iter().map(ladder).collect::<Vec<_>>(),
        "factors": outcome.factors.iter().map(factor).collect::<Vec<_>>(),
    })
}
