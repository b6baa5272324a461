//! `cargo xtask stability`: extreme cases, each right or refused by name.
//!
//! Every case of verify/stability.toml is run; the table says what came out, with residuals, and what makes it right.
//! It fails when one case does. `--docs` writes docs/stability.md; `--scenes` leaves out what `cargo test` runs anyway.

mod case;
mod check;
mod page;
mod row;

use crate::verify::programs;
use case::{Case, Kind, Scene};
use check::Result as Checked;
use row::Row;
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode, Stdio};
use std::time::{Duration, Instant};

/// Longest time one case may take.
const LIMIT: Duration = Duration::from_secs(120);

/// Runs all cases, or the named ones.
pub(crate) fn run(root: &Path, words: &[String]) -> ExitCode {
    match all(root, words) {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::FAILURE,
        Err(message) => {
            eprintln!("stability: {message}");
            ExitCode::from(2)
        }
    }
}

fn all(root: &Path, words: &[String]) -> Result<bool, String> {
    let (mut names, mut docs, mut scenes, mut program) = (Vec::new(), false, false, None);
    let mut rest = words.iter();
    while let Some(word) = rest.next() {
        match word.as_str() {
            "--docs" => docs = true,
            "--scenes" => scenes = true,
            "--case" => names.push(rest.next().ok_or("--case needs the name of a case")?.clone()),
            "--program" => program = Some(PathBuf::from(rest.next().ok_or("--program needs the path of a built wearshape")?)),
            other => return Err(format!("there is no option `{other}`")),
        }
    }
    if docs && (scenes || !names.is_empty()) {
        return Err("--docs writes all cases: leave --case and --scenes out".into());
    }
    let cases = case::read(&root.join("verify/stability.toml"))?;
    known(&cases, &names)?;
    let wearshape = program.map_or_else(|| programs::build(root), Ok)?;
    let needed = needed(&cases, &names);
    let started = Instant::now();
    let mut rows = Vec::new();
    let wanted = |case: &Case| match needed.is_empty() {
        true => !scenes || matches!(case.kind, Kind::Scene(_)),
        false => needed.contains(&case.name),
    };
    for case in cases.into_iter().filter(wanted) {
        let began = Instant::now();
        let result = match &case.kind {
            Kind::Scene(scene) => run_scene(root, &wearshape, &case.name, scene)?,
            Kind::Tests { package, filter } => run_tests(root, package, filter)?,
        };
        let row = Row { case, result, seconds: began.elapsed().as_secs_f64() };
        println!("{}", page::line(&row));
        rows.push(row);
    }
    let failed = rows.iter().filter(|row| !row.result.failures.is_empty()).count();
    println!("stability: {} cases, {failed} failed, {:.0} s", rows.len(), started.elapsed().as_secs_f64());
    if docs {
        page::write(root, &rows)?;
    }
    Ok(failed == 0)
}

/// Refuses names that no case has.
fn known(cases: &[Case], names: &[String]) -> Result<(), String> {
    let all: Vec<&str> = cases.iter().map(|case| case.name.as_str()).collect();
    match names.iter().find(|name| !all.contains(&name.as_str())) {
        Some(unknown) => Err(format!("there is no case `{unknown}`; there are: {}", all.join(", "))),
        None => Ok(()),
    }
}

/// The named cases and those they are held against; empty: all.
fn needed(cases: &[Case], names: &[String]) -> Vec<String> {
    let mut needed = names.to_vec();
    for case in cases.iter().rev().filter(|case| names.contains(&case.name)) {
        if let Kind::Scene(scene) = &case.kind {
            needed.extend(scene.scaled.iter().map(|scaled| scaled.like.clone()));
        }
    }
    needed
}

fn run_scene(root: &Path, wearshape: &Path, name: &str, scene: &Scene) -> Result<Checked, String> {
    let beside = root.join("target/stability");
    let folder = beside.join(name);
    if folder.exists() {
        std::fs::remove_dir_all(&folder).map_err(|error| format!("{}: {error}", folder.display()))?;
    }
    let mut command = Command::new(wearshape);
    command.current_dir(root).args(["run", &scene.scene, "--json", "-q", "--no-progress", "-o"]).arg(&folder);
    scene.set.iter().for_each(|change| {
        command.args(["--set", change]);
    });
    let (code, stdout) = finish(command)?;
    let document = check::document(&stdout, &folder);
    Ok(check::scene(scene, code, &document, &folder, &beside))
}

fn run_tests(root: &Path, package: &str, filter: &str) -> Result<Checked, String> {
    let cargo = std::env::var("CARGO").unwrap_or_else(|_| "cargo".into());
    let mut command = Command::new(cargo);
    command.current_dir(root).args(["test", "--release", "--quiet", "--package", package, "--test", "it", "--", filter]);
    command.stderr(Stdio::inherit());
    let output = command.stdin(Stdio::null()).output().map_err(|error| format!("cargo: {error}"))?;
    let text = String::from_utf8_lossy(&output.stdout);
    let last = text.lines().find_map(|line| line.strip_prefix("test result: ")).unwrap_or("no test ran").to_string();
    let passed = last.split_whitespace().skip_while(|word| *word != "ok.").nth(1).and_then(|word| word.parse::<usize>().ok());
    let mut result = Checked { says: last.split(';').take(2).collect::<Vec<_>>().join(";"), ..Checked::default() };
    if !output.status.success() || passed.is_none_or(|count| count == 0) {
        result.failures.push(format!("cargo test -p {package} {filter}: {last}"));
    }
    Ok(result)
}

/// Exit code and output of a program that is stopped when it takes too long.
fn finish(mut command: Command) -> Result<(Option<i32>, Vec<u8>), String> {
    let started = Instant::now();
    command.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::null());
    let mut child = command.spawn().map_err(|error| format!("wearshape: {error}"))?;
    let mut pipe = child.stdout.take();
    let reader = std::thread::spawn(move || {
        let mut text = Vec::new();
        if let Some(pipe) = &mut pipe {
            let _ = std::io::Read::read_to_end(pipe, &mut text);
        }
        text
    });
    let code = loop {
        if let Some(status) = child.try_wait().map_err(|error| format!("wearshape: {error}"))? {
            break status.code();
        }
        if started.elapsed() > LIMIT {
            let _ = child.kill();
            let _ = child.wait();
            break None;
        }
        std::thread::sleep(Duration::from_millis(5));
    };
    Ok((code, reader.join().unwrap_or_default()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_name_that_no_case_has_is_answered_with_those_there_are() {
        let tests = || Kind::Tests { package: "wear".into(), filter: "x".into() };
        let case = |name: &str| Case { name: name.into(), what: String::new(), right: String::new(), kind: tests() };
        let cases = ["one", "other"].map(case);
        assert_eq!(known(&cases, &["other".into()]), Ok(()));
        let said = known(&cases, &["one".into(), "nosuch".into()]);
        assert_eq!(said, Err("there is no case `nosuch`; there are: one, other".into()));
    }
}
