//! The packages of the workspace: a folder below `crates`, the name it has in a registry, and how cargo is started.

use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};
use toml::Table;

/// A library crate.
pub(crate) struct Library {
    /// Folder below `crates`, the name of the library too.
    pub(crate) folder: String,
    /// Name of the package.
    pub(crate) package: String,
    /// Whether there are features to leave out.
    pub(crate) has_features: bool,
    /// Whether it is a module for another language.
    for_others: bool,
}

/// Folders below `crates` with a library for Rust and no program; the module for Python is none.
pub(crate) fn libraries(root: &Path) -> Result<Vec<Library>, String> {
    let folder = root.join("crates");
    let entries = fs::read_dir(&folder).map_err(|error| format!("{}: {error}", folder.display()))?;
    let mut folders: Vec<String> = entries
        .filter_map(Result::ok)
        .filter(|entry| entry.path().join("src/lib.rs").exists() && !entry.path().join("src/main.rs").exists())
        .map(|entry| entry.file_name().to_string_lossy().into_owned())
        .collect();
    folders.sort();
    if folders.is_empty() {
        return Err(format!("no library in {}", folder.display()));
    }
    let libraries = folders.into_iter().map(|folder| library(root, folder));
    libraries.filter(|library| !library.as_ref().is_ok_and(|library| library.for_others)).collect()
}

fn library(root: &Path, folder: String) -> Result<Library, String> {
    let manifest = manifest(&root.join("crates").join(&folder).join("Cargo.toml"))?;
    let package = name(&manifest).ok_or_else(|| format!("crates/{folder}/Cargo.toml names no package"))?;
    let kinds = manifest.get("lib").and_then(|lib| lib.get("crate-type")).and_then(toml::Value::as_array);
    let for_others = kinds.is_some_and(|kinds| kinds.iter().all(|kind| kind.as_str() == Some("cdylib")));
    Ok(Library { package, has_features: manifest.contains_key("features"), for_others, folder })
}

/// Name of the package in a folder below `crates`.
pub(crate) fn package_of(root: &Path, folder: &str) -> Result<String, String> {
    library(root, folder.into()).map(|library| library.package)
}

/// The oldest Rust that the workspace promises to build with.
pub(crate) fn oldest_rust(root: &Path) -> Result<String, String> {
    let manifest = manifest(&root.join("Cargo.toml"))?;
    let version = manifest.get("workspace").and_then(|w| w.get("package")).and_then(|p| p.get("rust-version"));
    version.and_then(toml::Value::as_str).map(String::from).ok_or_else(|| "the workspace has no rust-version".into())
}

fn manifest(path: &Path) -> Result<Table, String> {
    let text = fs::read_to_string(path).map_err(|error| format!("{}: {error}", path.display()))?;
    text.parse().map_err(|error| format!("{}: {error}", path.display()))
}

fn name(manifest: &Table) -> Option<String> {
    manifest.get("package")?.get("name")?.as_str().map(String::from)
}

/// Cargo in a folder, without input.
pub(crate) fn cargo(folder: &Path) -> Command {
    let mut command = Command::new(std::env::var("CARGO").unwrap_or_else(|_| "cargo".into()));
    command.current_dir(folder).stdin(Stdio::null());
    command
}

/// Runs a command to its end.
pub(crate) fn done(command: &mut Command) -> Result<(), String> {
    let status = command.status().map_err(|error| format!("{}: {error}", shown(command)))?;
    if status.success() { Ok(()) } else { Err(format!("{} ended with {status}", shown(command))) }
}

/// Runs a command to its end and gives what it printed.
pub(crate) fn printed(command: &mut Command) -> Result<String, String> {
    let output = command.stderr(Stdio::inherit()).output().map_err(|error| format!("{}: {error}", shown(command)))?;
    if !output.status.success() {
        return Err(format!("{} ended with {}", shown(command), output.status));
    }
    Ok(String::from_utf8_lossy(&output.stdout).into_owned())
}

/// Program and arguments, without folders before the program.
fn shown(command: &Command) -> String {
    let program = Path::new(command.get_program()).file_name().unwrap_or_default().to_string_lossy();
    let words = command.get_args().map(|word| word.to_string_lossy());
    std::iter::once(program).chain(words).collect::<Vec<_>>().join(" ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_command_is_shown_as_it_is_typed() {
        let mut command = Command::new(Path::new("bin").join("cargo"));
        assert_eq!(shown(command.args(["check", "--release"])), "cargo check --release");
    }
}
