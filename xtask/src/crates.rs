//! `cargo xtask crates`: whether each library crate packs all that it needs.
//!
//! The files that a crate lists are copied beside those of the others, into a workspace that has nothing else. There all of them must
//! compile, and `cargo package` must make of each what a registry would take: with a version for each crate of ours that it builds on.
//! None need be published for that: each finds the packages of the others beside it.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode, Stdio};
use toml::{Table, Value};

/// Files that cargo adds to a package.
const ADDED: [&str; 3] = ["Cargo.lock", "Cargo.toml.orig", ".cargo_vcs_info.json"];

/// Files that every package brings along.
const WANTED: [&str; 3] = ["Cargo.toml", "README.md", "src/lib.rs"];

/// Lists, copies, compiles and packs.
pub(crate) fn run(root: &Path) -> ExitCode {
    match check(root) {
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

fn check(root: &Path) -> Result<Vec<String>, String> {
    let names = libraries(root)?;
    let copy = root.join("target/crates");
    if copy.exists() {
        fs::remove_dir_all(&copy).map_err(|error| format!("{}: {error}", copy.display()))?;
    }
    for name in &names {
        let files = listed(root, name)?;
        if let Some(missing) = WANTED.iter().find(|wanted| files.iter().all(|file| file != *wanted)) {
            return Err(format!("the package of {name} has no {missing}"));
        }
        for file in files.iter().filter(|file| !ADDED.contains(&file.as_str())) {
            copied(&root.join("crates").join(name).join(file), &copy.join(name).join(file))?;
        }
        changed(&copy.join(name).join("Cargo.toml"), publishable)?;
        println!("{name:<10} {} files", files.len());
    }
    for file in ["Cargo.toml", "Cargo.lock"] {
        copied(&root.join(file), &copy.join(file))?;
    }
    changed(&copy.join("Cargo.toml"), |manifest| workspace_of(manifest, &names))?;
    let built = std::env::var_os("CARGO_TARGET_DIR").map_or_else(|| root.join("target"), PathBuf::from);
    cargo(&copy, &built, &["check", "--quiet", "--workspace", "--release"])?;
    // Offline, so that a crate of the same name in the registry is not asked for.
    cargo(&copy, &built, &["package", "--quiet", "--workspace", "--no-verify", "--allow-dirty", "--offline"])?;
    Ok(names)
}

/// Folders below `crates` with a library and no program.
fn libraries(root: &Path) -> Result<Vec<String>, String> {
    let folder = root.join("crates");
    let entries = fs::read_dir(&folder).map_err(|error| format!("{}: {error}", folder.display()))?;
    let mut names: Vec<String> = entries
        .filter_map(Result::ok)
        .filter(|entry| entry.path().join("src/lib.rs").exists() && !entry.path().join("src/main.rs").exists())
        .map(|entry| entry.file_name().to_string_lossy().into_owned())
        .collect();
    names.sort();
    if names.is_empty() { Err(format!("no library in {}", folder.display())) } else { Ok(names) }
}

/// Paths of the files of a package, relative to its folder.
fn listed(root: &Path, name: &str) -> Result<Vec<String>, String> {
    let mut command = Command::new(program());
    command.args(["package", "--quiet", "--list", "--allow-dirty", "--package", name]).current_dir(root);
    let output = command.stdin(Stdio::null()).stderr(Stdio::inherit()).output().map_err(|error| format!("cargo: {error}"))?;
    if !output.status.success() {
        return Err(format!("cargo package --list --package {name} ended with {}", output.status));
    }
    Ok(String::from_utf8_lossy(&output.stdout).lines().map(|line| line.replace('\\', "/")).collect())
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

/// The packages of those that may not be published are not found beside the others.
fn publishable(manifest: &mut Table) {
    if let Some(package) = manifest.get_mut("package").and_then(Value::as_table_mut) {
        package.remove("publish");
    }
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

fn cargo(folder: &Path, built: &Path, arguments: &[&str]) -> Result<(), String> {
    let mut command = Command::new(program());
    command.args(arguments).current_dir(folder).env("CARGO_TARGET_DIR", built).stdin(Stdio::null());
    let status = command.status().map_err(|error| format!("cargo: {error}"))?;
    if status.success() {
        Ok(())
    } else {
        Err(format!("cargo {} ended with {status} in {}", arguments.join(" "), folder.display()))
    }
}

fn program() -> String {
    std::env::var("CARGO").unwrap_or_else(|_| "cargo".into())
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

    #[test]
    fn a_crate_is_packed_although_it_may_not_be_published() {
        let mut manifest: Table = "[package]\nname = \"wear\"\npublish = false\n".parse().expect("TOML");
        publishable(&mut manifest);
        assert_eq!(Ok(manifest), "[package]\nname = \"wear\"\n".parse());
    }
}
