//! `cargo xtask builds`: the libraries as others build them: by the oldest Rust that is promised, without their features, and for a browser,
//! where a module computes the digits of the native example.

use std::path::Path;
use std::process::{Command, ExitCode, Stdio};
use std::time::Instant;

use super::packages::{Library, cargo, done, libraries, oldest_rust, printed};

const WASM: &str = "wasm32-unknown-unknown";
/// Degree at which the module and the native example are compared.
const DEGREE: &str = "10";

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
    timed(|| in_a_browser(root, &libraries))?;
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

fn in_a_browser(root: &Path, libraries: &[Library]) -> Result<String, String> {
    // Code is made of the one that runs here; `cargo xtask web` makes it of all, for its own module.
    done(cargo(root).args(["check", "--quiet", "--release", "--target", WASM]).args(packages(libraries)))?;
    done(cargo(root).args(["build", "--quiet", "--release", "--target", WASM, "--package", "tube"]))?;
    let built = std::env::var_os("CARGO_TARGET_DIR").map_or_else(|| root.join("target"), Into::into);
    let module = built.join(WASM).join("release/tube.wasm");
    let mut node = Command::new("node");
    let called = printed(node.arg(root.join("tests/wasm/tube.mjs")).arg(module).arg(DEGREE).stdin(Stdio::null()))?;
    let mut example = cargo(root);
    example.args(["run", "--quiet", "--release", "--package", "wearshape-hpfem", "--example", "thick_cylinder"]);
    let native = printed(&mut example)?;
    same_digits(&called, &native)?;
    Ok(format!("all for {WASM}; in node {}", called.trim()))
}

/// Whether the module printed the line of its degree as the native example did.
fn same_digits(module: &str, native: &str) -> Result<(), String> {
    let says = |text: &str| {
        let line = text.lines().find(|line| line.starts_with(&format!("degree {DEGREE}:")))?;
        line.split_whitespace().nth(4).map(|number| number.trim_end_matches(',').to_string())
    };
    match (says(module), says(native)) {
        (Some(a), Some(b)) if a == b => Ok(()),
        _ => Err(format!("the module says `{}`, the native example\n{native}", module.trim())),
    }
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn digits_of_the_module_are_those_of_the_native_example() {
        let native =
            "degree  8: u_r = 0.000453968255, relative error 1e-9\ndegree 10: u_r = 0.000453968254, relative error 1.3e-12\n";
        assert!(same_digits("degree 10: u_r = 0.000453968254 (0.00045396825396)", native).is_ok());
        assert!(same_digits("degree 10: u_r = 0.000453968255 (0.00045396825496)", native).is_err());
        assert!(same_digits("degree 10: u_r = NaN (NaN)", native).is_err());
        assert!(same_digits("", "").is_err());
    }
}
