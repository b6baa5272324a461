//! `cargo xtask profile`: which stage of the program takes how much of its time.

use super::case::{self, Case};
use super::process;
use crate::machine::machine;
use crate::verify::{programs, tables};
use serde_json::Value;
use std::fs;
use std::path::Path;
use std::process::ExitCode;

const PAGE: &str = "docs/where-time-goes.md";
/// Runs of a scene, of which the quickest is shown.
const REPEAT: usize = 3;
/// Share of the seconds that a stage must have somewhere to get a column of its own.
const SHOWN: f64 = 0.05;

/// Where the time of one scene went.
#[derive(Debug, Clone, PartialEq)]
struct Profile {
    name: String,
    /// Processor seconds, and those of the system among them.
    seconds: f64,
    system: f64,
    /// Shares of the clock's seconds of the stages by name; what is left is starting, drawing and writing.
    stages: Vec<(String, f64)>,
    factorisations: u64,
    unknowns: u64,
    /// MB.
    peak: f64,
}

/// Prints the table and, if asked to, writes it to docs.
pub(crate) fn run(root: &Path, words: &[String]) -> ExitCode {
    match table(root, words) {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("profile: {message}");
            ExitCode::from(2)
        }
    }
}

fn table(root: &Path, words: &[String]) -> Result<(), String> {
    let (mut names, mut docs) = (Vec::new(), false);
    let mut rest = words.iter();
    while let Some(word) = rest.next() {
        match word.as_str() {
            "--docs" => docs = true,
            "--case" => names.push(rest.next().ok_or("--case needs the name of a case")?.clone()),
            other => return Err(format!("there is no option `{other}`")),
        }
    }
    if docs && !names.is_empty() {
        return Err("--docs writes all scenes: leave --case out".into());
    }
    let cases = case::named(case::all(root)?, &names)?;
    let program = programs::build(root)?;
    let mut profiles = Vec::new();
    for case in cases.iter().filter(|case| !names.is_empty() || case.is_built_in() || case.is_meshed()) {
        let profile = profile(root, &program, case)?;
        println!("{:<34} {:.3} s", profile.name, profile.seconds);
        profiles.push(profile);
    }
    let rows = rows(&profiles);
    println!("\n{rows}");
    if docs {
        let path = root.join(PAGE);
        fs::write(&path, page(&rows, &machine())).map_err(|error| format!("{}: {error}", path.display()))?;
    }
    Ok(())
}

/// The quickest of several runs.
fn profile(root: &Path, program: &Path, case: &Case) -> Result<Profile, String> {
    let folder = root.join("target/speed/profile");
    let mut best: Option<Profile> = None;
    for _ in 0..REPEAT {
        let taken = process::run(root, program, &case.words(&folder))?.ok_or(format!("{}: no answer", case.name))?;
        if best.as_ref().is_none_or(|best| taken.seconds() < best.seconds) {
            let [timing, summary] = ["timing.json", "summary.json"].map(|file| tables::read_json(&folder.join(file)));
            let (timing, counters) = (timing?, summary?["counters"].clone());
            best = Some(Profile {
                name: case.name.clone(),
                seconds: taken.seconds(),
                system: taken.system,
                stages: shares(&timing),
                factorisations: counters["factorisations"].as_u64().unwrap_or(0),
                unknowns: counters["dofs"].as_u64().unwrap_or(0),
                peak: taken.peak,
            });
        }
    }
    best.ok_or(format!("{}: no run", case.name))
}

/// Shares of the stages in the seconds of a run.
fn shares(timing: &Value) -> Vec<(String, f64)> {
    let all = timing["seconds_total"].as_f64().unwrap_or(0.0);
    let stages = timing["stages"].as_array().map_or(&[][..], Vec::as_slice);
    let share = |stage: &Value| Some((stage["name"].as_str()?.to_string(), stage["seconds"].as_f64()? / all));
    stages.iter().filter_map(share).filter(|(_, share)| share.is_finite()).collect()
}

/// The table: a column for each stage that counts somewhere, in the order in which the program goes through them.
fn rows(profiles: &[Profile]) -> String {
    let mut columns: Vec<&str> = Vec::new();
    for (name, _) in profiles.iter().flat_map(|profile| &profile.stages).filter(|(_, share)| *share >= SHOWN) {
        if !columns.contains(&name.as_str()) {
            columns.push(name);
        }
    }
    let mut text = format!("| scene | processor s | of the system | {} | other |", columns.join(" | "));
    text += &format!(" factorised | unknowns | peak MB |\n|{}\n", "---|".repeat(columns.len() + 7));
    for profile in profiles {
        let share = |name: &&str| profile.stages.iter().filter(|(stage, _)| stage == name).map(|(_, share)| share).sum::<f64>();
        let shares: Vec<f64> = columns.iter().map(share).collect();
        let other = (1.0 - shares.iter().sum::<f64>()).max(0.0);
        let percent = |share: f64| if share < 0.005 { String::new() } else { format!("{:.0} %", 100.0 * share) };
        let cells: Vec<String> = shares.into_iter().chain([other]).map(percent).collect();
        text += &format!(
            "| {} | {:.3} | {:.0} % | {} | {} | {} | {:.0} |\n",
            profile.name,
            profile.seconds,
            100.0 * profile.system / profile.seconds,
            cells.join(" | "),
            profile.factorisations,
            profile.unknowns,
            profile.peak
        );
    }
    text
}

fn page(rows: &str, machine: &str) -> String {
    format!(
        "# Where the time goes\n\nWritten by `cargo xtask profile --docs`: every built-in scene at its own accuracy, then bodies from gmsh \
         ([speed.toml](../verify/speed.toml)), with one thread; the quickest of {REPEAT} runs. Processor seconds are those of the whole \
         program, user and system; the shares are of its seconds by the clock: the stages of `timing.json`, and what none of them \
         counts, which is starting, drawing and writing. The stage of a proof or of a run in time has the bodies in it that only it needs. \
         Factorised: bodies reduced to their contact surface. Unknowns: of the level that is reported.\n\n\
         Measured {machine}.\n\n{rows}"
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    #[test]
    fn shares_are_of_all_seconds_and_the_rest_is_other() {
        let timing =
            json!({ "seconds_total": 2.0, "stages": [{ "name": "mesh", "seconds": 0.5 }, { "name": "factor", "seconds": 1.0 }] });
        let stages = shares(&timing);
        assert_eq!(stages, [("mesh".to_string(), 0.25), ("factor".to_string(), 0.5)]);
        let profile = Profile { name: "a".into(), seconds: 2.0, system: 0.5, stages, factorisations: 3, unknowns: 7, peak: 20.0 };
        let text = rows(&[profile]);
        let expected = "| scene | processor s | of the system | mesh | factor | other | factorised | unknowns | peak MB |";
        assert_eq!(text.lines().next(), Some(expected));
        assert_eq!(text.lines().last(), Some("| a | 2.000 | 25 % | 25 % | 50 % | 25 % | 3 | 7 | 20 |"));
    }

    #[test]
    fn a_stage_that_counts_nowhere_has_no_column() {
        let stages = vec![("setup".to_string(), 0.001), ("wear".to_string(), 0.9)];
        let profile = Profile { name: "a".into(), seconds: 1.0, system: 0.0, stages, factorisations: 0, unknowns: 0, peak: 1.0 };
        let head = rows(&[profile]).lines().next().unwrap_or_default().to_string();
        assert!(head.contains("wear") && !head.contains("setup"), "{head}");
    }
}
