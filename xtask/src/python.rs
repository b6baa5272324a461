//! `cargo xtask python`: the package for Python, built and tested in an environment of its own below `target`; `cargo xtask wheel`: the file that others
//! install.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode};
use std::time::Instant;

use super::packages::done;
use super::verify;

/// Debian's package for environments.
const PACKAGES: [&str; 1] = ["python3-venv"];
/// The folder of the package.
const FOLDER: &str = "crates/python";

/// Builds the package, runs its tests and checks its types.
pub(crate) fn run(root: &Path, words: &[String]) -> ExitCode {
    ended("python", tested(root, words))
}

/// Makes a wheel for all Pythons of this system.
pub(crate) fn wheel(root: &Path, words: &[String]) -> ExitCode {
    ended("wheel", made(root, words))
}

fn ended(chore: &str, outcome: Result<(), String>) -> ExitCode {
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("{chore}: {message}");
            ExitCode::FAILURE
        }
    }
}

fn tested(root: &Path, words: &[String]) -> Result<(), String> {
    let environment = Environment::of(root, words)?;
    timed("install", || {
        environment.pip(&["maturin>=1.9,<2"])?;
        // With the maturin that is there, which builds into the target folder of the workspace.
        let package = format!("./{FOLDER}[test]");
        environment.pip(&["--no-build-isolation", &package])
    })?;
    timed("pytest", || done(environment.python().args(["-m", "pytest", "-q", "--durations=5", FOLDER])))?;
    timed("mypy", || {
        done(
            environment
                .python()
                .args(["-m", "mypy", "--strict", "python/wearshape", "tests", "benches"])
                .current_dir(root.join(FOLDER)),
        )?;
        // The installed package, whose stubs must say what its module has.
        done(environment.python().args(["-m", "mypy.stubtest", "wearshape._core"]))?;
        let notebooks = format!("{FOLDER}/examples");
        done(environment.python().args(["-m", "nbqa", "mypy", "--strict", &notebooks]))
    })?;
    println!("python: built, its tests and types pass");
    Ok(())
}

fn made(root: &Path, words: &[String]) -> Result<(), String> {
    let environment = Environment::of(root, words)?;
    environment.pip(&["maturin[zig]>=1.9,<2"])?;
    let mut maturin = environment.python();
    maturin.args(["-m", "maturin", "build", "--release", "--locked", "--out", "target/wheels"]);
    if cfg!(target_os = "linux") {
        // Linked by zig against the symbols of an old glibc, so that it can be installed on every Linux of the last ten years.
        maturin.args(["--zig", "--compatibility", "manylinux2014"]);
    }
    maturin.arg("--manifest-path");
    done(maturin.arg(format!("{FOLDER}/Cargo.toml")))
}

/// Does a part and prints its seconds.
fn timed(name: &str, part: impl FnOnce() -> Result<(), String>) -> Result<(), String> {
    let start = Instant::now();
    part()?;
    println!("{:4.0} s  {name}", start.elapsed().as_secs_f64());
    Ok(())
}

/// An environment of Python below `target`.
struct Environment<'a> {
    root: &'a Path,
    folder: PathBuf,
}

impl Environment<'_> {
    fn of<'a>(root: &'a Path, words: &[String]) -> Result<Environment<'a>, String> {
        match words {
            [] => {}
            [word] if word == "--install" => verify::debian::install_packages(&PACKAGES)?,
            _ => return Err("takes `--install` or nothing".into()),
        }
        let folder = root.join("target/python/venv");
        let environment = Environment { root, folder };
        if !environment.program("python").exists() {
            let parent = root.join("target/python");
            fs::create_dir_all(&parent).map_err(|error| format!("{}: {error}", parent.display()))?;
            done(Command::new(verify::programs::PYTHON).args(["-m", "venv"]).arg(&environment.folder))?;
        }
        Ok(environment)
    }

    fn program(&self, name: &str) -> PathBuf {
        self.folder.join("bin").join(name)
    }

    /// Its interpreter at the root of the workspace, with its programs before all others.
    fn python(&self) -> Command {
        let mut command = Command::new(self.program("python"));
        let before = std::env::var_os("PATH").unwrap_or_default();
        let paths = std::iter::once(self.folder.join("bin")).chain(std::env::split_paths(&before));
        command.env("PATH", std::env::join_paths(paths).unwrap_or(before)).env("VIRTUAL_ENV", &self.folder);
        // One memory of mypy's for all that it looks at: numpy, scipy and pandas are read once.
        command.env("MYPY_CACHE_DIR", self.root.join("target/python/mypy"));
        command.env_remove("PYTHONPATH").env_remove("PYTHONHOME").current_dir(self.root).stdin(std::process::Stdio::null());
        command
    }

    fn pip(&self, what: &[&str]) -> Result<(), String> {
        done(self.python().args(["-m", "pip", "install", "-q", "--disable-pip-version-check"]).args(what))
    }
}
