//! `cargo xtask editor`: the schema that editors complete and check scenes by, held against scenes by the checker of an editor plug-in.
//!
//! taplo checks every built-in scene by the `#:schema` line at its head, as an editor does, and by the schema named; scenes with a slip must
//! be found fault with at the slip.

use crate::verify;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode, Stdio};

/// The checker, from npm.
const CHECKER: &str = "@taplo/cli@0.7.0";
const SCHEMA: &str = "wearshape.schema.json";
/// What a slip makes of drum-brake-block: text, and the text instead of it, which the checker must show.
const SLIPS: [[&str; 2]; 3] = [["friction = ", "frction = "], ["\"plane-stress\"", "\"plane-stres\""], ["units = ", "unit = "]];

/// Installs the checker unless it is there, and checks the scenes.
pub(crate) fn run(root: &Path) -> ExitCode {
    match check(root) {
        Ok(scenes) => {
            println!("editor: {scenes} scenes pass by their own schema line and by name, {} slips are found", SLIPS.len());
            ExitCode::SUCCESS
        }
        Err(message) => {
            eprintln!("editor: {message}");
            ExitCode::FAILURE
        }
    }
}

fn check(root: &Path) -> Result<usize, String> {
    let folder = root.join("target/editor");
    let scenes_folder = folder.join("scenes");
    fs::create_dir_all(&scenes_folder).map_err(|error| format!("{}: {error}", scenes_folder.display()))?;
    let taplo = folder.join("node_modules/.bin/taplo");
    if !taplo.exists() {
        let mut npm = Command::new("npm");
        npm.args(["install", "--no-audit", "--no-fund", "--loglevel=error", "--prefix"]).arg(&folder).arg(CHECKER);
        let done = npm.status().map_err(|error| format!("cannot start npm: {error}; install Node.js"))?;
        if !done.success() {
            return Err(format!("npm install {CHECKER} ended with {done}"));
        }
    }
    let schema = scenes_folder.join(SCHEMA);
    let written = Command::new(verify::programs::build(root)?).arg("schema").output().map_err(|error| error.to_string())?;
    write(&schema, &written.stdout)?;
    let mut scenes = Vec::new();
    for entry in fs::read_dir(root.join("crates/scene/scenes")).map_err(|error| format!("crates/scene/scenes: {error}"))? {
        let path = entry.map_err(|error| error.to_string())?.path();
        if let Some(name) = path.file_name().filter(|_| path.extension().is_some_and(|extension| extension == "toml")) {
            let copy = scenes_folder.join(name);
            write(&copy, &fs::read(&path).map_err(|error| format!("{}: {error}", path.display()))?)?;
            scenes.push(copy);
        }
    }
    scenes.sort();
    if scenes.is_empty() {
        return Err("there are no scenes in crates/scene/scenes".into());
    }
    for named in [None, Some(schema.as_path())] {
        let (sound, words) = lint(&taplo, named, &scenes)?;
        if !sound {
            return Err(format!("a scene does not pass:\n{words}"));
        }
    }
    let good = fs::read_to_string(scenes_folder.join("drum-brake-block.toml")).map_err(|error| error.to_string())?;
    let slipped = scenes_folder.join("slip.toml");
    for [text, slip] in SLIPS {
        if !good.contains(text) {
            return Err(format!("drum-brake-block has no `{text}` to slip at"));
        }
        write(&slipped, good.replace(text, slip).as_bytes())?;
        for named in [None, Some(schema.as_path())] {
            let (sound, words) = lint(&taplo, named, std::slice::from_ref(&slipped))?;
            if sound || !words.contains(slip) {
                return Err(format!("`{slip}` is not found fault with:\n{words}"));
            }
        }
    }
    fs::remove_file(&slipped).map_err(|error| error.to_string())?;
    Ok(scenes.len())
}

/// Whether the checker passes all files, and what it says.
fn lint(taplo: &Path, schema: Option<&Path>, files: &[PathBuf]) -> Result<(bool, String), String> {
    let mut command = Command::new(taplo);
    command.arg("lint").stdin(Stdio::null());
    if let Some(schema) = schema {
        command.arg("--schema").arg(format!("file://{}", schema.display()));
    }
    let output = command.args(files).output().map_err(|error| format!("{}: {error}", taplo.display()))?;
    Ok((output.status.success(), String::from_utf8_lossy(&output.stderr).into_owned()))
}

fn write(path: &Path, bytes: &[u8]) -> Result<(), String> {
    fs::write(path, bytes).map_err(|error| format!("cannot write {}: {error}", path.display()))
}
