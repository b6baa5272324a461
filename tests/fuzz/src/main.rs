//! Mutated inputs for what reads them: scenes, gmsh files, gap profiles, recordings.
//!
//! ```text
//! fuzz TARGET FOLDER SECONDS SEED     begins with the corpus, goes on with mutations of it
//! fuzz TARGET FOLDER FILE             gives one input once
//! ```
//!
//! `cargo xtask fuzz` starts it under a limit of memory. An input lies in `FOLDER/input` while it is tried, so that it outlives an abort. One at which
//! the program panics, disagrees with itself, or takes longer than [`LONGEST`] is kept beside it, and the rest goes on; `FOLDER/counts.txt` tells the numbers.

mod clock;
mod mutate;
mod random;
mod recording;
mod targets;

use std::fs;
use std::panic::{self, AssertUnwindSafe};
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::sync::{Arc, Mutex, PoisonError};
use std::time::{Duration, Instant};

use clock::Clock;
use mutate::mutated;
use random::Random;
use targets::{Outcome, Target};

/// What one input may take, of the processor's time where the system tells it.
const LONGEST: Duration = Duration::from_secs(5);
/// Failures after which a campaign ends.
const ENOUGH: usize = 10;

/// The numbers of a campaign.
#[derive(Default)]
struct Counts {
    accepted: usize,
    refused: usize,
    failures: Vec<String>,
    slowest: Duration,
}

fn main() -> ExitCode {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let done = match words.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        [target, folder, seconds, seed] => campaign(target, Path::new(folder), seconds, seed),
        [target, folder, file] => once(target, Path::new(folder), Path::new(file)),
        _ => Err("takes TARGET FOLDER SECONDS SEED, or TARGET FOLDER FILE".into()),
    };
    match done {
        Ok(code) => code,
        Err(message) => {
            eprintln!("fuzz: {message}");
            ExitCode::from(2)
        }
    }
}

/// Gives one input, and lets a panic be one.
fn once(target: &str, folder: &Path, file: &Path) -> Result<ExitCode, String> {
    let target = Target::new(target, folder)?;
    let input = fs::read(file).map_err(|error| format!("{}: {error}", file.display()))?;
    let clock = Clock::start();
    let outcome = target.give(&input)?;
    println!("{outcome:?} in {:?}", clock.took());
    Ok(if clock.took() > LONGEST { ExitCode::FAILURE } else { ExitCode::SUCCESS })
}

fn campaign(name: &str, folder: &Path, seconds: &str, seed: &str) -> Result<ExitCode, String> {
    let seconds: u64 = seconds.parse().map_err(|_| format!("{seconds} is no number of seconds"))?;
    let mut random = Random::new(seed.parse().map_err(|_| format!("{seed} is no seed"))?);
    let target = Target::new(name, folder)?;
    let corpus = target.corpus()?;
    let (said, mut counts) = (listen(), Counts::default());
    let end = Instant::now() + Duration::from_secs(seconds);
    // What is sound comes first: a corpus that is refused would be of no use.
    for input in &corpus {
        try_one(&target, input, folder, &said, &mut counts)?;
    }
    while Instant::now() < end && counts.failures.len() < ENOUGH {
        let input = target.mutated(&corpus, &mut random, mutated);
        try_one(&target, &input, folder, &said, &mut counts)?;
    }
    let Counts { accepted, refused, failures, slowest } = counts;
    let text = format!(
        "{} inputs, {accepted} accepted, {refused} refused, {} failed, {} in the corpus, the slowest {:.2} s\n{}",
        accepted + refused + failures.len(),
        failures.len(),
        corpus.len(),
        slowest.as_secs_f64(),
        failures.concat()
    );
    write(&folder.join("counts.txt"), text.as_bytes())?;
    Ok(if failures.is_empty() { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

/// From here on panics are kept instead of told: the last one is read here.
fn listen() -> Arc<Mutex<String>> {
    let said = Arc::new(Mutex::new(String::new()));
    let heard = Arc::clone(&said);
    panic::set_hook(Box::new(move |panic| {
        *heard.lock().unwrap_or_else(PoisonError::into_inner) = panic.to_string().replace('\n', " ");
    }));
    said
}

/// Gives an input, and keeps it where it is a failure.
fn try_one(target: &Target, input: &[u8], folder: &Path, said: &Mutex<String>, counts: &mut Counts) -> Result<(), String> {
    write(&folder.join("input"), input)?;
    let clock = Clock::start();
    let outcome = panic::catch_unwind(AssertUnwindSafe(|| target.give(input)));
    let took = clock.took();
    counts.slowest = counts.slowest.max(took);
    let why = match outcome {
        Err(_) => Some(said.lock().unwrap_or_else(PoisonError::into_inner).clone()),
        Ok(Err(why)) => Some(why),
        Ok(Ok(_)) if took > LONGEST => Some(format!("it took {:.1} s", took.as_secs_f64())),
        Ok(Ok(Outcome::Accepted)) => {
            counts.accepted += 1;
            None
        }
        Ok(Ok(Outcome::Refused)) => {
            counts.refused += 1;
            None
        }
    };
    if let Some(why) = why {
        let file: PathBuf = folder.join(format!("failed-{}", counts.failures.len() + 1));
        write(&file, input)?;
        counts.failures.push(format!("{}: {why}\n", file.display()));
    }
    Ok(())
}

fn write(path: &Path, bytes: &[u8]) -> Result<(), String> {
    fs::write(path, bytes).map_err(|error| format!("{}: {error}", path.display()))
}
