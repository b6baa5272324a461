//! `cargo xtask tidy`: the rules of the house that the compiler does not check.
//!
//! Every finding names file and line, the rule, and what to do instead.

mod circles;
mod finding;
mod graph;
mod imports;
mod lengths;
mod libraries;
mod list;
mod modules;
mod names;
mod notes;
mod parsed;
mod source;
mod strip;
mod today;

use std::fs;
use std::io;
use std::path::Path;
use std::process::ExitCode;

use finding::{Finding, TextFile};

/// Checks the whole workspace and prints the findings; fails when there is one. With `--list` prints the figures instead.
pub(crate) fn run(root: &Path, words: &[String]) -> ExitCode {
    let list = match words {
        [] => false,
        [word] if word == "--list" => true,
        _ => {
            eprintln!("tidy: takes `--list` or nothing");
            return ExitCode::from(2);
        }
    };
    let files = match text_files(root) {
        Ok(files) => files,
        Err(error) => {
            eprintln!("tidy: cannot read the workspace at {}: {error}", root.display());
            return ExitCode::from(2);
        }
    };
    if list {
        print!("{}", list::figures(&parsed::parse(&files).0));
        return ExitCode::SUCCESS;
    }
    let findings = check(&files);
    if findings.is_empty() {
        println!("tidy: {} files, nothing to mend", files.len());
        return ExitCode::SUCCESS;
    }
    for finding in &findings {
        eprintln!("{finding}");
    }
    eprintln!("\ntidy: {} finding(s) in {} files", findings.len(), files.len());
    ExitCode::FAILURE
}

/// All findings, in order of file and line.
fn check(files: &[TextFile]) -> Vec<Finding> {
    let mut findings = imports::check(files);
    findings.extend(source::check(files));
    findings.extend(notes::check(files));
    let (parsed, broken) = parsed::parse(files);
    findings.extend(broken);
    findings.extend(circles::check(&parsed, today::CIRCLES));
    findings.extend(lengths::check(&parsed, today::LONG_FUNCTIONS, today::WIDE_SIGNATURES));
    findings.extend(libraries::check(&parsed, today::OUTSIDE_LIBRARIES));
    findings.sort();
    findings
}

/// Every file the rules speak about: sources, manifests, scripts and pages, without build output.
fn text_files(root: &Path) -> io::Result<Vec<TextFile>> {
    let mut files = Vec::new();
    collect(root, "", &mut files)?;
    files.sort_by(|a, b| a.path.cmp(&b.path));
    Ok(files)
}

fn collect(folder: &Path, prefix: &str, files: &mut Vec<TextFile>) -> io::Result<()> {
    for entry in fs::read_dir(folder)? {
        let entry = entry?;
        let name = entry.file_name().to_string_lossy().into_owned();
        let path = format!("{prefix}{name}");
        if entry.file_type()?.is_dir() {
            let built = prefix.is_empty() && matches!(name.as_str(), "target" | "out" | ".git");
            if !built && name != "__pycache__" {
                collect(&entry.path(), &format!("{path}/"), files)?;
            }
        } else if is_text(&path) {
            // A file that is not UTF-8 is no text of ours; one that vanished meanwhile is no finding.
            if let Ok(text) = fs::read_to_string(entry.path()) {
                files.push(TextFile { path, text });
            }
        }
    }
    Ok(())
}

fn is_text(path: &str) -> bool {
    let known = [".rs", ".toml", ".py", ".md", ".sh"].iter().any(|end| path.ends_with(end));
    known || path.starts_with(".ci/")
}
