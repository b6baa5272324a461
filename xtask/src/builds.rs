//! `cargo xtask builds`: the libraries as others build them: by the oldest Rust that is promised, and without their features. For browsers `cargo xtask web`
//! builds them, and runs them there.

use std::path::Path;
use std::process::{Command, ExitCode, Stdio};
use std::time::Instant;

use super::packages::{Library, cargo, done, libraries, oldest_rust};

/// Builds everything and says how long each part took.
pub(crate) fn run(root: &Path) -> ExitCode {
    match builds(root) {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("builds: {message}");
            ExitCode::FAILURE
        }
    }
}

fn builds(root: &Path) -> Result<(), String> {
    let libraries = libraries(root)?;
    timed(|| without_features(root, &libraries))?;
    timed(|| by_the_oldest_rust(root, &libraries))
}

/// Prints what a part says, with its seconds.
fn timed(part: impl FnOnce() -> Result<String, String>) -> Result<(), String> {
    let start = Instant::now();
    let says = part()?;
    println!("{:4.0} s  {says}", start.elapsed().as_secs_f64());
    Ok(())
}

/// Those with features, one by one: together they would switch on each other's.
fn without_features(root: &Path, libraries: &[Library]) -> Result<String, String> {
    let mut names = Vec::new();
    for library in libraries.iter().filter(|library| library.has_features) {
        done(cargo(root).args(["check", "--quiet", "--release", "--no-default-features", "--package", &library.package]))?;
        names.push(library.folder.as_str());
    }
    Ok(format!("{} without their features", names.join(", ")))
}

fn by_the_oldest_rust(root: &Path, libraries: &[Library]) -> Result<String, String> {
    let version = oldest_rust(root)?;
    if !toolchain(&version) {
        return Ok(format!("skipped: Rust {version} is not here and rustup cannot get it"));
    }
    let mut check = Command::new("rustup");
    check.args(["run", &version, "cargo", "check", "--quiet", "--release"]).args(packages(libraries));
    done(check.current_dir(root).stdin(Stdio::null()))?;
    Ok(format!("all by Rust {version}"))
}

/// Whether a toolchain is there, or could be fetched.
fn toolchain(version: &str) -> bool {
    let quiet = |words: &[&str]| {
        let mut command = Command::new("rustup");
        command.args(words).stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null());
        command.status().is_ok_and(|status| status.success())
    };
    quiet(&["run", version, "rustc", "--version"]) || quiet(&["toolchain", "install", version, "--profile", "minimal"])
}

fn packages(libraries: &[Library]) -> Vec<&str> {
    libraries.iter().flat_map(|library| ["--package", library.package.as_str()]).collect()
}
