//! `cargo xtask fuzz`: mutated inputs for what reads scenes, gmsh files, gap profiles and recordings.
//!
//! `tests/fuzz` makes and gives them, in a process of its own for each reader, under a limit of memory. It needs the stable compiler and nothing else.

use crate::verify::programs;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, ExitCode, Stdio};

const TARGETS: [&str; 4] = ["scene", "gmsh", "profile", "recording"];
/// Readers that are tried at the same time.
const AT_ONCE: usize = 2;
/// Memory of a process (KiB): 1 GB of addresses.
const MEMORY: usize = 1_000_000;
/// Seconds beyond its own that a campaign may take: the last input, and the start.
const GRACE: u64 = 60;

/// What is asked for.
struct Wanted {
    targets: Vec<&'static str>,
    seconds: u64,
    seed: u64,
}

/// Tries the readers and prints how many inputs they had.
pub(crate) fn run(root: &Path, words: &[String]) -> ExitCode {
    match campaigns(root, words) {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::FAILURE,
        Err(message) => {
            eprintln!("fuzz: {message}");
            ExitCode::from(2)
        }
    }
}

fn wanted(words: &[String]) -> Result<Wanted, String> {
    let mut wanted = Wanted { targets: Vec::new(), seconds: 60, seed: 1 };
    let mut rest = words.iter();
    while let Some(word) = rest.next() {
        let mut number = || rest.next().and_then(|text| text.parse::<u64>().ok()).ok_or(format!("{word} needs a whole number"));
        match word.as_str() {
            "--seconds" => wanted.seconds = number()?,
            "--seed" => wanted.seed = number()?,
            other => match TARGETS.iter().find(|known| **known == other) {
                Some(known) => wanted.targets.push(known),
                None => return Err(format!("there is no reader or option `{other}`: write {}", TARGETS.join(", "))),
            },
        }
    }
    if wanted.targets.is_empty() {
        wanted.targets = TARGETS.to_vec();
    }
    Ok(wanted)
}

fn campaigns(root: &Path, words: &[String]) -> Result<bool, String> {
    let wanted = wanted(words)?;
    let program = programs::build_one(root, "fuzz", "fuzz")?;
    println!("fuzz: {} s each, seed {}, {} MB of memory", wanted.seconds, wanted.seed, MEMORY / 1000);
    let mut sound = true;
    for some in wanted.targets.chunks(AT_ONCE) {
        let started: Vec<(&str, PathBuf, Child)> =
            some.iter().map(|target| start(root, &program, target, &wanted)).collect::<Result<_, _>>()?;
        for (target, folder, mut child) in started {
            let ended = child.wait().map_err(|error| format!("{target}: {error}"))?;
            let told = fs::read_to_string(folder.join("counts.txt")).unwrap_or_else(|_| {
                let input = folder.join("input");
                format!("{ended} at {}; its last words are in {}\n", input.display(), folder.join("said.txt").display())
            });
            print!("{target:<9}  {told}");
            if !ended.success() {
                sound = false;
                println!("{:<9}  again: {} {target} {} FILE", "", program.display(), folder.display());
            }
        }
    }
    Ok(sound)
}

/// Starts a campaign in a folder of its own.
fn start<'a>(root: &Path, program: &Path, target: &'a str, wanted: &Wanted) -> Result<(&'a str, PathBuf, Child), String> {
    let folder = root.join("target/fuzz").join(target);
    let failed = |error: std::io::Error| format!("{}: {error}", folder.display());
    if folder.exists() {
        fs::remove_dir_all(&folder).map_err(failed)?;
    }
    fs::create_dir_all(&folder).map_err(failed)?;
    let said = fs::File::create(folder.join("said.txt")).map_err(failed)?;
    // Processor time ends an input that never does.
    let limits = format!("ulimit -v {MEMORY} && ulimit -t {} && exec \"$0\" \"$@\"", 2 * wanted.seconds + GRACE);
    let child = Command::new("sh")
        .args(["-c", &limits])
        .arg(program)
        .args([target, &folder.display().to_string(), &wanted.seconds.to_string(), &wanted.seed.to_string()])
        .current_dir(&folder)
        .stdin(Stdio::null())
        .stdout(Stdio::null())
        .stderr(said)
        .spawn()
        .map_err(|error| format!("sh: {error}"))?;
    Ok((target, folder, child))
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    #[test]
    fn readers_are_named_or_all() {
        let words = |text: &str| text.split_whitespace().map(ToString::to_string).collect::<Vec<_>>();
        let all = wanted(&words("--seconds 5")).unwrap();
        assert_eq!((all.targets.len(), all.seconds, all.seed), (4, 5, 1));
        assert_eq!(wanted(&words("gmsh scene --seed 7")).unwrap().targets, ["gmsh", "scene"]);
        assert!(wanted(&words("mesh")).is_err() && wanted(&words("--seconds")).is_err());
    }
}
