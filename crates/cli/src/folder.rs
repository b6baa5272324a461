//! The output folder: written beside its place, renamed when complete.

use std::fs;
use std::path::{Path, PathBuf};

use report::SCHEMA_VERSION;
use scene::{Fault, Place, sha256};

/// File that marks a partial folder as ours; it is the first to be written.
const MARK: &str = "scene.resolved.toml";

/// A folder in the making: `<dir>.partial`, to become `<dir>`.
#[derive(Debug)]
pub(crate) struct Folder {
    target: PathBuf,
    partial: PathBuf,
}

impl Folder {
    /// Refuses a target that is not ours to replace.
    pub(crate) fn check(target: &Path) -> Result<(), Fault> {
        let shown = target.display();
        let refuse = |what: &str| {
            let message = format!("{shown} {what}, and is left as it is");
            Err(Fault {
                place: Some(Place::Flag(format!("-o {shown}"))),
                ..Fault::new("foreign-folder", message, "give another folder: -o DIR")
            })
        };
        if !target.exists() {
            return Ok(());
        }
        if !target.is_dir() {
            return refuse("is a file");
        }
        let empty = fs::read_dir(target).is_ok_and(|mut entries| entries.next().is_none());
        if empty || ours(target) { Ok(()) } else { refuse("holds files that wearshape did not write") }
    }

    /// Begins the partial folder, or with `resume` continues one.
    pub(crate) fn begin(target: &Path, resume: bool) -> Result<Folder, Fault> {
        Folder::check(target)?;
        let mut name = target.file_name().unwrap_or_default().to_os_string();
        name.push(".partial");
        let partial = target.with_file_name(name);
        let folder = Folder { target: target.to_path_buf(), partial };
        if folder.partial.exists() {
            let empty = fs::read_dir(&folder.partial).is_ok_and(|mut entries| entries.next().is_none());
            if !empty && !folder.partial.join(MARK).is_file() {
                let message = format!("{} holds files that wearshape did not write", folder.partial.display());
                return Err(Fault::new("foreign-folder", message, "remove it, or give another folder: -o DIR"));
            }
        }
        if folder.partial.exists() && !resume {
            fs::remove_dir_all(&folder.partial).map_err(|error| folder.unwritable(&folder.partial, &error))?;
        }
        fs::create_dir_all(&folder.partial).map_err(|error| folder.unwritable(&folder.partial, &error))?;
        Ok(folder)
    }

    /// Refuses to go on with another scene than the one that the partial folder was begun with.
    pub(crate) fn same_scene(&self, resolved: &str) -> Result<(), Fault> {
        let before = fs::read_to_string(self.partial.join(MARK)).unwrap_or_default();
        if before.is_empty() || before == resolved {
            return Ok(());
        }
        let changed = resolved.lines().find(|line| !before.lines().any(|other| other == *line)).unwrap_or("(a line less)");
        let message = format!(
            "{} was begun with another scene (sha256 {:.12} there, {:.12} here); here it says: {changed}",
            self.partial.display(),
            sha256(&before),
            sha256(resolved)
        );
        let remedy = "give the same scene and --set options as before, or leave out --resume to begin again";
        Err(Fault { place: Some(Place::Flag("--resume".into())), ..Fault::new("another-scene", message, remedy) })
    }

    /// The partial folder.
    pub(crate) fn path(&self) -> &Path {
        &self.partial
    }

    /// Writes one file of the folder, making folders on the way.
    pub(crate) fn write(&self, name: &str, text: &str) -> Result<(), Fault> {
        self.write_bytes(name, text.as_bytes())
    }

    /// Writes one file of the folder that is no text.
    pub(crate) fn write_bytes(&self, name: &str, content: &[u8]) -> Result<(), Fault> {
        let path = self.partial.join(name);
        let parent = path.parent().unwrap_or(&self.partial);
        fs::create_dir_all(parent).and_then(|()| fs::write(&path, content)).map_err(|error| self.unwritable(&path, &error))
    }

    /// Adds to the end of one file of the folder.
    pub(crate) fn append(&self, name: &str, text: &str) -> Result<(), Fault> {
        let path = self.partial.join(name);
        let file = fs::OpenOptions::new().append(true).create(true).open(&path);
        file.and_then(|mut file| std::io::Write::write_all(&mut file, text.as_bytes()))
            .map_err(|error| self.unwritable(&path, &error))
    }

    /// Takes the partial folder away: nothing was computed.
    pub(crate) fn discard(self) {
        let _ = fs::remove_dir_all(&self.partial);
    }

    /// Puts the finished folder in its place; returns that.
    pub(crate) fn finish(self) -> Result<PathBuf, Fault> {
        Folder::check(&self.target)?;
        let aside = self.target.with_extension("old");
        let replaced = self.target.exists();
        if replaced {
            if aside.exists() {
                fs::remove_dir_all(&self.target).map_err(|error| self.unwritable(&self.target, &error))?;
            } else {
                fs::rename(&self.target, &aside).map_err(|error| self.unwritable(&self.target, &error))?;
            }
        }
        fs::rename(&self.partial, &self.target).map_err(|error| self.unwritable(&self.target, &error))?;
        if replaced && ours(&aside) {
            fs::remove_dir_all(&aside).map_err(|error| self.unwritable(&aside, &error))?;
        }
        Ok(self.target)
    }

    /// Puts a folder without an answer in its place, or beside it, as `<dir>.failed`, where the run of before had one; returns where it is.
    pub(crate) fn finish_beside_good(mut self) -> Result<PathBuf, Fault> {
        let good = summary(&self.target)["status"].as_str().is_some_and(|status| matches!(status, "ok" | "accuracy-missed"));
        if good {
            let mut name = self.target.file_name().unwrap_or_default().to_os_string();
            name.push(".failed");
            self.target.set_file_name(name);
        }
        self.finish()
    }

    fn unwritable(&self, path: &Path, error: &std::io::Error) -> Fault {
        Fault {
            place: Some(Place::Flag(format!("-o {}", self.target.display()))),
            ..Fault::new(
                "unwritable",
                format!("cannot write {}: {error}", path.display()),
                "give a folder that can be written, with room on its disk: -o DIR",
            )
        }
    }
}

/// The summary in a folder; null without one.
fn summary(folder: &Path) -> serde_json::Value {
    let text = fs::read_to_string(folder.join("summary.json")).unwrap_or_default();
    serde_json::from_str(&text).unwrap_or_default()
}

/// Whether a folder holds a summary that this program wrote.
fn ours(folder: &Path) -> bool {
    let empty = fs::read_dir(folder).is_ok_and(|mut entries| entries.next().is_none());
    let summary = summary(folder);
    empty
        || summary["schema_version"].as_u64().is_some_and(|version| version <= u64::from(SCHEMA_VERSION))
            && summary["scene_sha256"].is_string()
}
