//! `cargo xtask package`: the static program, its manual pages and completions, and the Debian package.

use std::path::Path;
use std::process::{Command, ExitCode};
use std::time::Instant;

use crate::supply;

const TARGET: &str = "x86_64-unknown-linux-gnu";
/// Starts that are timed; the fastest counts.
const STARTS: usize = 20;

/// Builds everything and says sizes and the start-up time.
pub(crate) fn run(root: &Path) -> ExitCode {
    match package(root) {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("package: {message}");
            ExitCode::FAILURE
        }
    }
}

fn package(root: &Path) -> Result<(), String> {
    let arguments = ["build", "--profile", "dist", "-p", "cli", "--target", TARGET];
    // The C library is linked in, so that the program runs on any Linux of this processor.
    start(Command::new("cargo").args(arguments).env("RUSTFLAGS", "-C target-feature=+crt-static").current_dir(root))?;
    let program = root.join("target").join(TARGET).join("dist/wearshape");
    let folder = root.join("target/package");
    std::fs::create_dir_all(&folder).map_err(|error| format!("cannot make {}: {error}", folder.display()))?;
    start(Command::new(&program).arg("man").arg(folder.join("man")))?;
    for (shell, file) in [("bash", "wearshape.bash"), ("zsh", "_wearshape"), ("fish", "wearshape.fish")] {
        let script = start(Command::new(&program).args(["completions", shell]))?;
        std::fs::write(folder.join(file), script).map_err(|error| format!("cannot write {file}: {error}"))?;
    }
    println!("notices  of {} packages", supply::write(root, TARGET, &folder)?);
    let bytes = std::fs::metadata(&program).map_err(|error| error.to_string())?.len();
    println!("program  {} ({:.1} MB)", program.display(), bytes as f64 / 1e6);
    println!("start    {:.1} ms", 1e3 * fastest_start(&program)?);
    if Command::new("cargo").args(["deb", "--version"]).output().is_ok_and(|output| output.status.success()) {
        let arguments = ["deb", "-p", "cli", "--target", TARGET, "--profile", "dist", "--no-build", "--no-strip", "-q"];
        let made = start(Command::new("cargo").args(arguments).current_dir(root))?;
        println!("debian   {}", made.trim());
        Ok(())
    } else {
        Err("no Debian package without cargo-deb: `cargo install cargo-deb`".into())
    }
}

/// Runs a program to its end and returns what it printed.
fn start(command: &mut Command) -> Result<String, String> {
    let shown = format!("{command:?}");
    let output = command.stderr(std::process::Stdio::inherit()).output().map_err(|error| format!("{shown}: {error}"))?;
    if output.status.success() {
        Ok(String::from_utf8_lossy(&output.stdout).into_owned())
    } else {
        Err(format!("{shown} ended with {}", output.status))
    }
}

fn fastest_start(program: &Path) -> Result<f64, String> {
    let mut fastest = f64::INFINITY;
    for _ in 0..STARTS {
        let begin = Instant::now();
        start(Command::new(program).arg("--version"))?;
        fastest = fastest.min(begin.elapsed().as_secs_f64());
    }
    Ok(fastest)
}
