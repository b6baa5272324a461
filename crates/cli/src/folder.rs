//! The output folder: written beside its place, put there when complete.
//!
//! One call at a time writes `<dir>.partial`; it holds a lock on it. Every name is written down before its file is made, so that what is ours can be
//! told from what is not, at any time: in the partial folder by a list of its own, in a finished one by the `manifest` of its summary. Nothing else is ever
//! taken away. A finished folder is on the disk before it takes its place, and takes it in one step where the system can.

mod exchange;
mod lock;
mod names;
mod sync;

use std::collections::{BTreeMap, BTreeSet};
use std::fs::{self, File};
use std::io;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};
use std::time::Instant;

use scene::{Fault, Place, sha256};
use serde_json::{Value, json};

use crate::bounded;
use crate::print::talk;
use exchange::exchange;
use lock::{Lock, lock};
use names::{LIST, SUMMARY};
pub(crate) use sync::INTERVAL;

/// The scene of a folder, the first of its files: a folder is of one scene.
const MARK: &str = "scene.resolved.toml";

/// A folder in the making: `<dir>.partial`, to become `<dir>`.
#[derive(Debug)]
pub(crate) struct Folder {
    target: PathBuf,
    partial: PathBuf,
    /// SHA-256 of the scene.
    mark: String,
    /// Held while the folder is written.
    _lock: Lock,
    /// Files of ours in the partial folder.
    names: Mutex<BTreeSet<String>>,
    /// When files that grow were last handed to the disk.
    synced: Mutex<BTreeMap<String, Instant>>,
}

impl Folder {
    /// Refuses a target that is not ours to replace.
    pub(crate) fn check(target: &Path) -> Result<(), Fault> {
        let target = place(target)?;
        if !target.exists() {
            return Ok(());
        }
        if !target.is_dir() {
            return Err(refused(&target, "is a file, and is left as it is".into()));
        }
        match names::foreign_in_finished(&target) {
            None => Ok(()),
            Some(name) => Err(foreign(&target, &target, &name)),
        }
    }

    /// Refuses a target that is a folder which the call reads: it would take its place.
    pub(crate) fn check_apart(target: &Path, read: &Path, what: &str) -> Result<(), Fault> {
        let same = fs::canonicalize(target).is_ok_and(|there| fs::canonicalize(read).is_ok_and(|read| read == there));
        if same { Err(refused(target, format!("is the folder of {what}, and is left as it is"))) } else { Ok(()) }
    }

    /// Begins the partial folder of a scene, or with `resume` continues one of the same scene.
    pub(crate) fn begin(target: &Path, scene: &str, resume: bool) -> Result<Folder, Fault> {
        Folder::check(target)?;
        let target = place(target)?;
        let partial = beside(&target, "", ".partial");
        let lock = lock(&partial).map_err(|error| match error.kind() {
            io::ErrorKind::WouldBlock => busy(&target, &partial),
            _ => unwritable(&target, &partial, &error),
        })?;
        if let Some(name) = names::foreign_in_partial(&partial) {
            return Err(foreign(&target, &partial, &name));
        }
        let before = bounded::result_text(&partial.join(MARK)).ok().filter(|_| resume);
        if let Some(before) = &before {
            same_scene(&partial, before, scene)?;
        }
        let mut held = names::known(&partial);
        if before.is_none() {
            names::remove(&partial, &held).map_err(|error| unwritable(&target, &partial, &error))?;
            held.clear();
        }
        names::write_list(&partial, &mut held).map_err(|error| unwritable(&target, &partial, &error))?;
        let (names, synced) = (Mutex::new(held), Mutex::default());
        let folder = Folder { target, partial, mark: sha256(scene), _lock: lock, names, synced };
        if before.is_none() {
            folder.write(MARK, scene)?;
        }
        Ok(folder)
    }

    /// The partial folder.
    pub(crate) fn path(&self) -> &Path {
        &self.partial
    }

    /// The path of a file that is going to be ours.
    pub(crate) fn own(&self, name: &str) -> Result<PathBuf, Fault> {
        let path = self.partial.join(name);
        let mut names = self.names.lock().unwrap_or_else(PoisonError::into_inner);
        if !names.contains(name) {
            append(&self.partial.join(LIST), &format!("{name}\n")).map_err(|error| self.unwritable(&path, &error))?;
            names.insert(name.into());
        }
        Ok(path)
    }

    /// Writes one file of the folder, making folders on the way.
    pub(crate) fn write(&self, name: &str, text: &str) -> Result<(), Fault> {
        self.write_bytes(name, text.as_bytes())
    }

    /// Writes one file of the folder that is no text.
    pub(crate) fn write_bytes(&self, name: &str, content: &[u8]) -> Result<(), Fault> {
        let path = self.own(name)?;
        let parent = path.parent().unwrap_or(&self.partial);
        fs::create_dir_all(parent).and_then(|()| fs::write(&path, content)).map_err(|error| self.unwritable(&path, &error))
    }

    /// Writes the files that the scene names. One that is there with another content is of another scene: it is not continued.
    pub(crate) fn write_files_of_scene(&self, files: Vec<(String, Vec<u8>)>) -> Result<(), Fault> {
        for (name, bytes) in files {
            match bounded::result(&self.partial.join(&name)) {
                Ok(before) if before == bytes => {}
                Ok(_) => {
                    let message = format!("{} was begun with another {name}", self.partial.display());
                    let remedy = "give the same files as before, or leave out --resume to begin again";
                    let place = Some(Place::Flag("--resume".into()));
                    return Err(Fault { place, ..Fault::new("another-scene", message, remedy) });
                }
                Err(_) => self.write_bytes(&name, &bytes)?,
            }
        }
        Ok(())
    }

    /// Puts a text in the place of a file of the folder, whole or not at all.
    pub(crate) fn replace(&self, name: &str, text: &str) -> Result<(), Fault> {
        let new = format!("{name}.new");
        self.write(&new, text)?;
        let path = self.own(name)?;
        fs::rename(self.partial.join(new), &path).map_err(|error| self.unwritable(&path, &error))
    }

    /// Adds to the end of one file of the folder; now and then the file is handed to the disk.
    pub(crate) fn append(&self, name: &str, text: &str) -> Result<(), Fault> {
        let path = self.own(name)?;
        let file = append(&path, text).map_err(|error| self.unwritable(&path, &error))?;
        let mut synced = self.synced.lock().unwrap_or_else(PoisonError::into_inner);
        let last = synced.entry(name.into()).or_insert_with(Instant::now);
        if last.elapsed() >= INTERVAL {
            file.sync_data().map_err(|error| self.unwritable(&path, &error))?;
            *last = Instant::now();
        }
        Ok(())
    }

    /// Cuts off what stands behind the first `length` bytes of a file: a row that was torn.
    pub(crate) fn cut(&self, name: &str, length: u64) -> Result<(), Fault> {
        let path = self.own(name)?;
        let whole = |file: &File| file.metadata().map(|data| data.len() <= length);
        let file = fs::OpenOptions::new().write(true).create(true).truncate(false).open(&path);
        let cut = file.and_then(|file| if whole(&file)? { Ok(()) } else { file.set_len(length) });
        cut.map_err(|error| self.unwritable(&path, &error))
    }

    /// Takes what was written away: nothing was computed.
    pub(crate) fn discard(self) {
        let _ = names::remove(&self.partial, &self.all_names()).and_then(|()| fs::remove_dir(&self.partial));
    }

    /// A summary with the names of all files as its `manifest`.
    pub(crate) fn listed(&self, summary: &Value) -> Value {
        let mut listed = summary.clone();
        let there = |name: &String| name == SUMMARY || self.partial.join(name).exists();
        let mut names = self.all_names();
        names.insert(SUMMARY.into());
        listed["manifest"] = json!(names.into_iter().filter(there).collect::<Vec<_>>());
        listed
    }

    /// Writes the summary, hands everything to the disk and puts the folder in its place. Returns the summary as it was written.
    pub(crate) fn finish(self, summary: &Value) -> Result<Value, Fault> {
        let target = self.target.clone();
        let listed = self.listed(summary);
        self.write(SUMMARY, &report::pretty(&listed))?;
        Folder::check(&target)?;
        if let Some(name) = names::foreign_in_partial(&self.partial) {
            return Err(foreign(&target, &self.partial, &name));
        }
        let there = bounded::result_text(&self.partial.join(MARK)).unwrap_or_default();
        if sha256(&there) != self.mark {
            let message = format!("{} was changed while it was written: its scene is another one", self.partial.display());
            let fault = Fault::new(
                "another-scene",
                message,
                "run it again; let nothing else write there, or give another folder: -o DIR",
            );
            return Err(Fault { place: Some(flag(&target)), ..fault });
        }
        let on_disk = fs::remove_file(self.partial.join(LIST)).and_then(|()| sync::folder(&self.partial, &self.all_names()));
        on_disk.map_err(|error| self.unwritable(&self.partial, &error))?;
        self.place().map_err(|error| self.unwritable(&target, &error))?;
        Ok(listed)
    }

    /// Finishes a folder without an answer, or beside its place, as `<dir>.failed`, where the call of before had one; returns that other place too.
    pub(crate) fn finish_beside_good(mut self, summary: &Value) -> Result<(Value, Option<PathBuf>), Fault> {
        let other = names::has_answer(&self.target).then(|| beside(&self.target, "", ".failed"));
        if let Some(other) = &other {
            self.target.clone_from(other);
        }
        Ok((self.finish(summary)?, other))
    }

    /// Puts the partial folder in the place of the target; what was there is taken away afterwards.
    fn place(&self) -> io::Result<()> {
        let occupied = fs::read_dir(&self.target).is_ok_and(|mut entries| entries.next().is_some());
        if !occupied {
            fs::rename(&self.partial, &self.target)?;
            return sync::parent(&self.target);
        }
        // The folder that is there is held as well: after the exchange it has the name that the next call will want to write to.
        let _old = lock(&self.target).ok();
        let aside = beside(&self.target, ".", &format!(".replaced-{}", std::process::id()));
        if exchange(&self.partial, &self.target).is_ok() {
            fs::rename(&self.partial, &aside)?;
        } else {
            fs::rename(&self.target, &aside)?;
            if let Err(error) = fs::rename(&self.partial, &self.target) {
                fs::rename(&aside, &self.target)?;
                return Err(error);
            }
        }
        sync::parent(&self.target)?;
        let old = names::known(&aside);
        if names::remove(&aside, &old).and_then(|()| fs::remove_dir(&aside)).is_err() {
            talk(&format!("what {} held before is left in {}", self.target.display(), aside.display()));
        }
        Ok(())
    }

    fn all_names(&self) -> BTreeSet<String> {
        self.names.lock().unwrap_or_else(PoisonError::into_inner).clone()
    }

    fn unwritable(&self, path: &Path, error: &io::Error) -> Fault {
        unwritable(&self.target, path, error)
    }
}

/// Where a folder goes: behind links; refused if it has no name there.
fn place(target: &Path) -> Result<PathBuf, Fault> {
    let link = fs::symlink_metadata(target).is_ok_and(|data| data.is_symlink());
    let place = if link { fs::canonicalize(target).ok() } else { Some(target.to_path_buf()) };
    match place {
        None => Err(refused(target, "is a link to nothing".into())),
        Some(place) if place.file_name().is_none() => Err(refused(target, "is no name for a folder of results".into())),
        Some(place) => Ok(place),
    }
}

/// The path beside another one whose name has something before and after.
fn beside(path: &Path, before: &str, after: &str) -> PathBuf {
    let mut name = std::ffi::OsString::from(before);
    name.push(path.file_name().unwrap_or_default());
    name.push(after);
    path.with_file_name(name)
}

fn append(path: &Path, text: &str) -> io::Result<File> {
    let mut file = fs::OpenOptions::new().append(true).create(true).open(path)?;
    io::Write::write_all(&mut file, text.as_bytes())?;
    Ok(file)
}

/// Refuses to continue a partial folder of another scene.
fn same_scene(partial: &Path, before: &str, scene: &str) -> Result<(), Fault> {
    if before == scene {
        return Ok(());
    }
    let changed = scene.lines().find(|line| !before.lines().any(|other| other == *line)).unwrap_or("(a line less)");
    let message = format!(
        "{} was begun with another scene (sha256 {:.12} there, {:.12} here); here it says: {changed}",
        partial.display(),
        sha256(before),
        sha256(scene)
    );
    let remedy = "give the same scene, files and --set options as before, or leave out --resume to begin again";
    Err(Fault { place: Some(Place::Flag("--resume".into())), ..Fault::new("another-scene", message, remedy) })
}

fn flag(target: &Path) -> Place {
    Place::Flag(format!("-o {}", target.display()))
}

fn refused(target: &Path, what: String) -> Fault {
    let message = format!("{} {what}", target.display());
    Fault { place: Some(flag(target)), ..Fault::new("foreign-folder", message, "give another folder: -o DIR") }
}

/// A file in `folder` that is not ours.
fn foreign(target: &Path, folder: &Path, name: &str) -> Fault {
    let message = format!("{} holds {name}, which wearshape did not write; the folder is left as it is", folder.display());
    Fault { place: Some(flag(target)), ..Fault::new("foreign-folder", message, "move that away, or give another folder: -o DIR") }
}

fn busy(target: &Path, partial: &Path) -> Fault {
    let message = format!("{} is being written by another wearshape", partial.display());
    Fault {
        place: Some(flag(target)),
        ..Fault::new("folder-in-use", message, "wait until that has ended, or give another folder: -o DIR")
    }
}

fn unwritable(target: &Path, path: &Path, error: &io::Error) -> Fault {
    let message = format!("cannot write {}: {error}", path.display());
    let remedy = "give a folder that can be written, with room on its disk: -o DIR";
    Fault { place: Some(flag(target)), ..Fault::new("unwritable", message, remedy) }
}
