//! Which files of a folder are ours.

use std::collections::BTreeSet;
use std::fs;
use std::io;
use std::path::Path;

use report::SCHEMA_VERSION;
use serde_json::Value;

use crate::bounded;

/// Names of the files of a partial folder, one a line; it is not among them.
pub(super) const LIST: &str = ".wearshape-files";
/// The list on its way to its name.
const NEW_LIST: &str = ".wearshape-files.new";
/// The summary; in a finished folder it has the names of all files.
pub(super) const SUMMARY: &str = "summary.json";

/// Files that any folder of ours may have: those of every command, and those that are on the way to their own name.
const ALWAYS: [&str; 7] = [SUMMARY, LIST, NEW_LIST, "scene.resolved.toml", "timing.json", "report.html", "run.mcap.new"];
/// What folders that have no list of their files may have besides.
const WITHOUT_LIST: [&str; 16] = [
    "contact.csv",
    "history.csv",
    "run.mcap",
    "run.layout.json",
    "profile.csv",
    "profile-spline.csv",
    "profile.dxf",
    "fields.pvd",
    "sweep.csv",
    "sweep.jsonl",
    "curves.csv",
    "study.csv",
    "study.json",
    "study.svg",
    "rows.csv",
    "commands.txt",
];
/// Folders in them.
const FOLDERS_WITHOUT_LIST: [&str; 2] = ["plots/", "fields/"];

/// The files in a folder that are ours; those that its lists name, or without any list those of the known names.
pub(super) fn known(folder: &Path) -> BTreeSet<String> {
    let summary = summary(folder);
    let list = bounded::result_text(&folder.join(LIST)).ok();
    let manifest = summary["manifest"].as_array();
    let listed = manifest.into_iter().flatten().filter_map(Value::as_str).chain(list.iter().flat_map(|list| list.lines()));
    let listed: BTreeSet<&str> = listed.collect();
    let without = list.is_none() && manifest.is_none();
    let ours = |name: &String| {
        let usual = WITHOUT_LIST.contains(&name.as_str()) || FOLDERS_WITHOUT_LIST.iter().any(|folder| name.starts_with(folder));
        ALWAYS.contains(&name.as_str()) || listed.contains(name.as_str()) || (without && usual)
    };
    entries(folder).into_iter().filter(ours).collect()
}

/// The first file of a finished folder that is not ours.
pub(super) fn foreign_in_finished(folder: &Path) -> Option<String> {
    let summary = summary(folder);
    let version = summary["schema_version"].as_u64();
    let finished = version.is_some_and(|version| version <= u64::from(SCHEMA_VERSION)) && summary["scene_sha256"].is_string();
    let known = if finished { known(folder) } else { BTreeSet::new() };
    entries(folder).into_iter().find(|name| !known.contains(name))
}

/// The first file of a partial folder that is not ours.
pub(super) fn foreign_in_partial(folder: &Path) -> Option<String> {
    let begun = ["scene.resolved.toml", LIST, NEW_LIST].iter().any(|name| folder.join(name).is_file());
    let known = if begun { known(folder) } else { BTreeSet::new() };
    entries(folder).into_iter().find(|name| !known.contains(name))
}

/// Writes the list of a partial folder, whole or not at all, and takes it out of the names.
pub(super) fn write_list(folder: &Path, names: &mut BTreeSet<String>) -> io::Result<()> {
    names.retain(|name| name != LIST && name != NEW_LIST);
    let text: String = names.iter().map(|name| format!("{name}\n")).collect();
    fs::write(folder.join(NEW_LIST), text)?;
    fs::rename(folder.join(NEW_LIST), folder.join(LIST))
}

/// Takes files of ours away, those that tell what is ours last, and folders in which nothing is left.
pub(super) fn remove(folder: &Path, names: &BTreeSet<String>) -> io::Result<()> {
    let last = ["scene.resolved.toml", SUMMARY, LIST];
    let first = names.iter().map(String::as_str).filter(|name| !last.contains(name));
    for name in first.chain(last) {
        match fs::remove_file(folder.join(name)) {
            Err(error) if error.kind() != io::ErrorKind::NotFound => return Err(error),
            _ => {}
        }
    }
    remove_empty(folder);
    Ok(())
}

/// Takes the folders in a folder away that hold nothing.
fn remove_empty(folder: &Path) {
    for entry in fs::read_dir(folder).into_iter().flatten().flatten() {
        if entry.file_type().is_ok_and(|kind| kind.is_dir()) {
            remove_empty(&entry.path());
            let _ = fs::remove_dir(entry.path());
        }
    }
}

/// The summary in a folder; null without one.
pub(super) fn summary(folder: &Path) -> Value {
    let text = bounded::result_text(&folder.join(SUMMARY)).unwrap_or_default();
    serde_json::from_str(&text).unwrap_or_default()
}

/// Whether a finished folder holds an answer; that of a sweep at one point at least.
pub(super) fn has_answer(folder: &Path) -> bool {
    let summary = summary(folder);
    let some = summary["points"].as_u64().zip(summary["failed"].as_u64()).is_some_and(|(points, failed)| failed < points);
    some || matches!(summary["status"].as_str(), Some("ok" | "accuracy-missed"))
}

/// Everything in a folder but folders, by its path from there with `/` between the parts; sorted.
fn entries(folder: &Path) -> BTreeSet<String> {
    let mut found = BTreeSet::new();
    let mut open = vec![String::new()];
    while let Some(prefix) = open.pop() {
        for entry in fs::read_dir(folder.join(&prefix)).into_iter().flatten().flatten() {
            let name = format!("{prefix}{}", entry.file_name().to_string_lossy());
            if entry.file_type().is_ok_and(|kind| kind.is_dir()) {
                open.push(name + "/");
            } else {
                found.insert(name);
            }
        }
    }
    found
}
