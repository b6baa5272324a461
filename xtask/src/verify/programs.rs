//! Starting programs: wearshape, and the scripts in verify/.

use super::case::Case;
use serde_json::Value;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

/// Debian's own interpreter; another python3 on the PATH cannot import its packages.
pub(crate) const PYTHON: &str = "/usr/bin/python3";

/// Longest time a script may take.
const LIMIT: Duration = Duration::from_secs(600);

/// Builds wearshape and returns where it is.
pub(crate) fn build(root: &Path) -> Result<PathBuf, String> {
    build_one(root, "cli", "wearshape")
}

/// Builds a program of one of our packages, with the features it has beside wearshape, and returns where it is.
pub(crate) fn build_one(root: &Path, package: &str, name: &str) -> Result<PathBuf, String> {
    let cargo = std::env::var("CARGO").unwrap_or_else(|_| "cargo".into());
    let output = Command::new(cargo)
        .args(["build", "--release", "--package", "cli", "--package", package, "--bin", name])
        .arg("--message-format=json-render-diagnostics")
        .current_dir(root)
        .stderr(Stdio::inherit())
        .output()
        .map_err(|error| format!("cargo: {error}"))?;
    if !output.status.success() {
        return Err(format!("{name} does not build"));
    }
    let text = String::from_utf8_lossy(&output.stdout);
    let messages = text.lines().filter_map(|line| serde_json::from_str::<Value>(line).ok());
    let found = messages.filter_map(|message| message["executable"].as_str().map(PathBuf::from)).next_back();
    found.ok_or(format!("cargo built {name} and did not say where"))
}

/// Runs wearshape on the case's scene into `<folder>/ours`.
pub(crate) fn solve(root: &Path, wearshape: &Path, case: &Case, folder: &Path) -> Result<(), String> {
    if folder.exists() {
        fs::remove_dir_all(folder).map_err(|error| format!("{}: {error}", folder.display()))?;
    }
    fs::create_dir_all(folder).map_err(|error| format!("{}: {error}", folder.display()))?;
    let mut command = Command::new(wearshape);
    command.current_dir(root).args(["run", &case.scene, "-q", "--no-progress", "-o"]).arg(folder.join("ours"));
    for change in &case.set {
        command.args(["--set", change]);
    }
    if let Some(count) = case.sample {
        command.args(["--sample", &count.to_string()]);
    }
    let output = command.stdin(Stdio::null()).output().map_err(|error| format!("wearshape: {error}"))?;
    if output.status.success() {
        return Ok(());
    }
    let summary = super::tables::read_json(&folder.join("ours/summary.json")).unwrap_or_default();
    let words = String::from_utf8_lossy(&output.stderr);
    let words = summary["verdict"].as_str().unwrap_or(words.trim());
    Err(format!("wearshape ended with {}: {words}", output.status))
}

/// Debian's interpreter in an environment of its own: no paths of the user, one thread, caches
/// under target/.
pub(crate) fn python(root: &Path) -> Command {
    let mut command = Command::new(PYTHON);
    command
        .args(["-I", "-B"])
        .env_remove("PYTHONPATH")
        .env_remove("PYTHONHOME")
        .env("OMP_NUM_THREADS", "1")
        .env("OPENBLAS_NUM_THREADS", "1")
        .env("XDG_CACHE_HOME", root.join("target/verify/cache"))
        .stdin(Stdio::null());
    command
}

/// Runs a script on a case folder; it must leave an out.json.
pub(crate) fn script(root: &Path, script: &str, folder: &Path, fault: Option<&str>) -> Result<(), String> {
    let out = folder.join("out.json");
    if out.exists() {
        fs::remove_file(&out).map_err(|error| format!("{}: {error}", out.display()))?;
    }
    let log = folder.join("script.log");
    let file = fs::File::create(&log).map_err(|error| format!("{}: {error}", log.display()))?;
    let mut command = python(root);
    command.arg(root.join("verify").join(script)).arg(folder);
    if let Some(fault) = fault {
        command.args(["--fault", fault]);
    }
    let copy = file.try_clone().map_err(|error| format!("{}: {error}", log.display()))?;
    let mut child = command.stdout(copy).stderr(file).spawn().map_err(|error| format!("{PYTHON}: {error}"))?;
    let started = Instant::now();
    let ended = loop {
        if let Some(ended) = child.try_wait().map_err(|error| format!("{script}: {error}"))? {
            break ended;
        }
        if started.elapsed() > LIMIT {
            // It may just have ended by itself; either way it is gone after this.
            let _ = child.kill();
            let _ = child.wait();
            return Err(format!("{script} took more than {} s", LIMIT.as_secs()));
        }
        std::thread::sleep(Duration::from_millis(20));
    };
    if ended.success() && out.exists() {
        return Ok(());
    }
    let words = fs::read_to_string(&log).unwrap_or_default();
    let last = words.lines().rev().find(|line| !line.trim().is_empty()).unwrap_or("no message");
    Err(format!("{script} ended with {ended}: {last} (all of it in {})", log.display()))
}
