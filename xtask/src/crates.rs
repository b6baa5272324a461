//! `cargo xtask crates`: whether each library crate packs all that it needs.
//!
//! The files that a crate lists are copied beside those of the others, into a workspace that has nothing else. There all of them must
//! compile, and `cargo package` must make of each what a registry would take: with a version for each crate of ours that it builds on.
//! None need be published for that: each finds the packages of the others beside it. The names that each offers must be those of its list in
//! `docs/api`.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use toml::{Table, Value};

use super::api;
use super::packages::{Library, cargo, done, libraries, printed};

/// Files that cargo adds to a package.
const ADDED: [&str; 3] = ["Cargo.lock", "Cargo.toml.orig", ".cargo_vcs_info.json"];

/// Files that every package brings along.
const WANTED: [&str; 5] = ["Cargo.toml", "README.md", "LICENSE-APACHE", "LICENSE-MIT", "src/lib.rs"];

/// Compares the lists of names (or writes them, by `--write`), then copies, compiles and packs.
pub(crate) fn run(root: &Path, words: &[String]) -> ExitCode {
    let write = match words {
        [] => false,
        [word] if word == "--write" => true,
        _ => {
            eprintln!("crates: takes `--write` or nothing");
            return ExitCode::from(2);
        }
    };
    match check(root, write) {
        Ok(names) => {
            println!("crates: {} list all that they need and can be packed", names.join(", "));
            ExitCode::SUCCESS
        }
        Err(message) => {
            eprintln!("crates: {message}");
            ExitCode::FAILURE
        }
    }
}

fn check(root: &Path, write: bool) -> Result<Vec<String>, String> {
    let libraries = libraries(root)?;
    let names: Vec<String> = libraries.iter().map(|library| library.folder.clone()).collect();
    let copy = root.join("target/crates");
    if copy.exists() {
        fs::remove_dir_all(&copy).map_err(|error| format!("{}: {error}", copy.display()))?;
    }
    for Library { folder, package, .. } in &libraries {
        let offered = api::listed(root, folder, write)?;
        let files = listed(root, package)?;
        if let Some(missing) = WANTED.iter().find(|wanted| files.iter().all(|file| file != *wanted)) {
            return Err(format!("the package of {package} has no {missing}"));
        }
        for file in files.iter().filter(|file| !ADDED.contains(&file.as_str())) {
            copied(&root.join("crates").join(folder).join(file), &copy.join(folder).join(file))?;
        }
        println!("{package:<20} {} files, {offered} public names", files.len());
    }
    for file in ["Cargo.toml", "Cargo.lock"] {
        copied(&root.join(file), &copy.join(file))?;
    }
    changed(&copy.join("Cargo.toml"), |manifest| workspace_of(manifest, &names))?;
    let built = std::env::var_os("CARGO_TARGET_DIR").map_or_else(|| root.join("target"), PathBuf::from);
    let run = |words: &[&str]| done(cargo(&copy).args(words).env("CARGO_TARGET_DIR", &built));
    run(&["check", "--quiet", "--workspace", "--release"])?;
    // Offline, so that the registry is not asked for ours.
    run(&["package", "--quiet", "--workspace", "--no-verify", "--allow-dirty", "--offline"])?;
    Ok(names)
}

/// Paths of the files of a package, relative to its folder.
fn listed(root: &Path, package: &str) -> Result<Vec<String>, String> {
    let files = printed(cargo(root).args(["package", "--quiet", "--list", "--allow-dirty", "--package", package]))?;
    Ok(files.lines().map(|line| line.replace('\\', "/")).collect())
}

fn copied(from: &Path, to: &Path) -> Result<(), String> {
    let folder = to.parent().unwrap_or(to);
    let done = fs::create_dir_all(folder).and_then(|()| fs::copy(from, to));
    done.map(|_| ()).map_err(|error| format!("{} to {}: {error}", from.display(), to.display()))
}

/// Changes a manifest in its place.
fn changed(path: &Path, change: impl Fn(&mut Table)) -> Result<(), String> {
    let text = fs::read_to_string(path).map_err(|error| format!("{}: {error}", path.display()))?;
    let mut manifest: Table = text.parse().map_err(|error| format!("{}: {error}", path.display()))?;
    change(&mut manifest);
    fs::write(path, manifest.to_string()).map_err(|error| format!("{}: {error}", path.display()))
}

/// The manifest of a workspace of `names` alone, which lie beside it.
fn workspace_of(manifest: &mut Table, names: &[String]) {
    let Some(workspace) = manifest.get_mut("workspace").and_then(Value::as_table_mut) else {
        return;
    };
    workspace.remove("default-members");
    workspace.insert("members".into(), names.iter().cloned().map(Value::String).collect::<Vec<_>>().into());
    let dependencies = workspace.get_mut("dependencies").and_then(Value::as_table_mut);
    for (name, dependency) in dependencies.into_iter().flatten() {
        if let Some(path) = dependency.get_mut("path") {
            *path = Value::String(name.clone());
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_manifest_is_changed_to_a_workspace_of_libraries() {
        let text = "[workspace]\nmembers = [\"crates/*\", \"xtask\"]\ndefault-members = [\"crates/cli\"]\n[workspace.dependencies]\n\
                    wear = { path = \"crates/wear\", version = \"0.1.0\" }\nrayon = \"1\"\n";
        let mut manifest: Table = text.parse().expect("TOML");
        workspace_of(&mut manifest, &["wear".to_string()]);
        let expected = "[workspace]\nmembers = [\"wear\"]\n[workspace.dependencies]\n\
                        wear = { path = \"wear\", version = \"0.1.0\" }\nrayon = \"1\"\n";
        assert_eq!(Ok(manifest), expected.parse());
    }
}
