//! `cargo xtask bench [crate ..]`: the benches of our crates, as ratios.
//!
//! Seconds on a shared machine mean little; a ratio of two times of one run means more. A bench is
//! a plain program (`harness = false`). Of what it prints, lines of the form
//!
//! ```text
//! bench <name> <seconds> [<name of the bench it is compared with>]
//! ```
//!
//! become a table with ratios; the rest is passed on as it is.

use std::fs;
use std::path::Path;
use std::process::ExitCode;

use super::packages::{cargo, package_of, printed};

/// One line of a bench.
#[derive(Debug, Clone, PartialEq)]
struct Measure {
    name: String,
    seconds: f64,
    against: Option<String>,
}

/// Runs the benches of the named crates, or of all, and prints their ratios.
pub(crate) fn run(root: &Path, words: &[String]) -> ExitCode {
    let crates = match crates_with_benches(root) {
        Ok(crates) => crates,
        Err(message) => return stop(&message),
    };
    if let Some(unknown) = words.iter().find(|word| !crates.contains(word)) {
        return stop(&format!("no benches in a crate `{unknown}`; there are some in: {}", crates.join(", ")));
    }
    let wanted: Vec<&String> = crates.iter().filter(|name| words.is_empty() || words.contains(name)).collect();
    if wanted.is_empty() {
        return stop("no crate has a benches/ folder yet");
    }
    for name in wanted {
        println!("{name}");
        match measure(root, name) {
            Ok(measures) => print(&measures),
            Err(message) => return stop(&message),
        }
    }
    ExitCode::SUCCESS
}

fn stop(message: &str) -> ExitCode {
    eprintln!("bench: {message}");
    ExitCode::from(2)
}

fn crates_with_benches(root: &Path) -> Result<Vec<String>, String> {
    let folder = root.join("crates");
    let entries = fs::read_dir(&folder).map_err(|error| format!("{}: {error}", folder.display()))?;
    let mut names: Vec<String> = entries
        .filter_map(Result::ok)
        .filter(|entry| entry.path().join("benches").is_dir())
        .map(|entry| entry.file_name().to_string_lossy().into_owned())
        .collect();
    names.sort();
    Ok(names)
}

fn measure(root: &Path, name: &str) -> Result<Vec<Measure>, String> {
    let package = package_of(root, name)?;
    let text = printed(cargo(root).args(["bench", "--package", &package, "--bench", "*"]))?;
    for line in text.lines().filter(|line| !line.starts_with("bench ")) {
        println!("{line}");
    }
    parse(&text)
}

fn parse(text: &str) -> Result<Vec<Measure>, String> {
    text.lines().filter_map(|line| line.strip_prefix("bench ").map(|rest| line_of(line, rest))).collect()
}

fn line_of(line: &str, rest: &str) -> Result<Measure, String> {
    let mut words = rest.split_whitespace();
    let name = words.next().ok_or(format!("no name: {line}"))?;
    let seconds: Option<f64> = words.next().and_then(|word| word.parse().ok());
    let seconds = seconds.filter(|seconds| *seconds > 0.0).ok_or(format!("no time in seconds: {line}"))?;
    Ok(Measure { name: name.into(), seconds, against: words.next().map(String::from) })
}

fn print(measures: &[Measure]) {
    for measure in measures {
        let time = readable(measure.seconds);
        match ratio(measures, measure) {
            Some((other, ratio)) => {
                println!("  {:<44} {time:>10}  {ratio:8.2} of {other}", measure.name)
            }
            None => println!("  {:<44} {time:>10}", measure.name),
        }
    }
}

/// The bench it is compared with, and how many times its time this one takes.
fn ratio<'a>(measures: &'a [Measure], measure: &Measure) -> Option<(&'a str, f64)> {
    let other = measures.iter().find(|other| Some(&other.name) == measure.against.as_ref())?;
    Some((&other.name, measure.seconds / other.seconds))
}

fn readable(seconds: f64) -> String {
    let (value, unit) = match seconds {
        s if s < 1e-6 => (s * 1e9, "ns"),
        s if s < 1e-3 => (s * 1e6, "us"),
        s if s < 1.0 => (s * 1e3, "ms"),
        s => (s, "s"),
    };
    format!("{value:.3} {unit}")
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    #[test]
    fn a_ratio_is_taken_within_one_run() {
        let text = "running\nbench p8/plain 5e-3\nbench p8/products 2e-5 p8/plain\n";
        let measures = parse(text).unwrap();
        assert_eq!(measures.len(), 2);
        let (other, value) = ratio(&measures, &measures[1]).unwrap();
        assert!(other == "p8/plain" && (value - 4e-3).abs() < 1e-15);
        assert!(ratio(&measures, &measures[0]).is_none());
    }

    #[test]
    fn a_line_without_a_time_is_an_error() {
        assert!(parse("bench p8/plain\n").is_err());
        assert!(parse("bench p8/plain 0\n").is_err());
    }

    #[test]
    fn times_are_readable() {
        assert_eq!(readable(2.1e-5), "21.000 us");
        assert_eq!(readable(1.5), "1.500 s");
    }
}
