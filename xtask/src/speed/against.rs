//! `cargo xtask bench --against REV`: this tree's program and an earlier one, by turns.

use super::case::{self, Case};
use super::row::Row;
use super::{page, process, revision};
use crate::verify::programs;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

/// Pairs of runs of a case, if nothing is said.
const REPEAT: usize = 5;

/// What was asked for.
#[derive(Debug, Default, PartialEq)]
struct Asked {
    against: Option<String>,
    program: Option<PathBuf>,
    names: Vec<String>,
    repeat: usize,
    docs: bool,
}

/// Compares the programs, prints the table and, if asked to, writes it into docs/speed-by-release.md.
pub(crate) fn run(root: &Path, words: &[String]) -> ExitCode {
    match compare(root, words) {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("bench: {message}");
            ExitCode::from(2)
        }
    }
}

fn compare(root: &Path, words: &[String]) -> Result<(), String> {
    let asked = asked(words)?;
    let cases = case::named(case::all(root)?, &asked.names)?;
    let (name, old) = match (&asked.program, &asked.against) {
        (Some(program), _) => (program.file_name().unwrap_or_default().to_string_lossy().into_owned(), program.clone()),
        (None, Some(against)) => {
            let name = revision::name(root, against)?;
            let program = revision::built(root, &name)?;
            (name, program)
        }
        (None, None) => return Err("--against needs a revision, or --program a built wearshape".into()),
    };
    let new = programs::build(root)?;
    println!("{}", page::head(&name));
    let mut rows = Vec::new();
    for case in cases {
        let row = taken_in_turn(root, case, [&old, &new], asked.repeat)?;
        println!("{}", page::line(&row));
        rows.push(row);
    }
    println!("{}", page::whole(&rows));
    if asked.docs {
        let now = revision::name(root, "HEAD")?;
        page::write(root, [&name, &now], &rows, asked.repeat)?;
    }
    Ok(())
}

fn asked(words: &[String]) -> Result<Asked, String> {
    let mut asked = Asked { repeat: REPEAT, ..Asked::default() };
    let mut rest = words.iter();
    while let Some(word) = rest.next() {
        let mut value = |what: &str| rest.next().cloned().ok_or(format!("{word} needs {what}"));
        match word.as_str() {
            "--against" => asked.against = Some(value("a revision")?),
            "--program" => asked.program = Some(PathBuf::from(value("the path of a built wearshape")?)),
            "--case" => asked.names.push(value("the name of a case")?),
            "--repeat" => {
                let count = value("a number")?.parse().ok().filter(|count| *count > 0);
                asked.repeat = count.ok_or("--repeat needs a whole number above 0")?;
            }
            "--docs" => asked.docs = true,
            other => return Err(format!("there is no option `{other}`")),
        }
    }
    if asked.docs && !asked.names.is_empty() {
        return Err("--docs writes all cases: leave --case out".into());
    }
    Ok(asked)
}

/// Runs both programs by turns, each as often the first of a pair as the other.
fn taken_in_turn(root: &Path, case: Case, programs: [&PathBuf; 2], repeat: usize) -> Result<Row, String> {
    let words = case.words(&root.join("target/speed/out"));
    let mut runs = [Vec::new(), Vec::new()];
    for round in 0..repeat {
        for turn in [round % 2, 1 - round % 2] {
            match process::run(root, programs[turn], &words)? {
                Some(taken) => runs[turn].push(taken),
                None => return Ok(Row { case, runs: None }),
            }
        }
    }
    Ok(Row { case, runs: Some(runs) })
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    fn words(text: &str) -> Vec<String> {
        text.split(' ').map(String::from).collect()
    }

    #[test]
    fn words_are_read_and_wrong_ones_are_told() {
        let read = asked(&words("--against HEAD~3 --case cam --repeat 7")).unwrap();
        let expected = Asked { against: Some("HEAD~3".into()), names: words("cam"), repeat: 7, ..Asked::default() };
        assert_eq!(read, expected);
        for wrong in ["--against", "--repeat 0", "--repeat x", "--fast", "--docs --case cam"] {
            assert!(asked(&words(wrong)).is_err(), "{wrong}");
        }
    }
}
