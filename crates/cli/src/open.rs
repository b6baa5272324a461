//! A scene by its name or path: the one place where scene files are opened.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

use scene::{Document, Fault, Place, SCENES, builtin, did_you_mean};
use wearshape::Problem;

use crate::bounded;

/// The largest scene, and the largest mesh or profile beside one, bytes.
const LARGEST_SCENE: u64 = 16_000_000;
const LARGEST_BESIDE: u64 = 100_000_000;

/// A scene as it was read: its text, and the files beside it. Each is read once, however many problems are made of them, so that what becomes of them
/// on the disk meanwhile changes nothing.
pub(crate) struct Source {
    /// What the user gave.
    given: String,
    /// Name of the text in messages.
    file: String,
    text: String,
    beside: Beside,
}

/// Files beside a scene, by their paths as it has them. The folder of the scene is empty where it is the current one.
struct Beside {
    folder: PathBuf,
    read: Mutex<BTreeMap<String, Result<Vec<u8>, String>>>,
}

impl Beside {
    fn new(folder: PathBuf) -> Beside {
        Beside { folder, read: Mutex::default() }
    }

    /// The bytes of a file, or why there are none.
    fn read(&self, path: &str) -> Result<Vec<u8>, String> {
        let mut read = self.read.lock().unwrap_or_else(PoisonError::into_inner);
        let bytes = read.entry(path.to_string()).or_insert_with(|| {
            bounded::file(&self.folder.join(path), LARGEST_BESIDE).map_err(|error| {
                let found = self.found(path);
                if found == path { error } else { format!("{found}: {error}") }
            })
        });
        bytes.clone()
    }

    /// The path of a file as seen from the current folder.
    fn found(&self, path: &str) -> String {
        self.folder.join(path).display().to_string()
    }

    /// A fault inside a file beside the scene names the file as it is found from the current folder.
    fn named(&self, scene: &str, mut fault: Fault) -> Fault {
        if let Some(Place::File(spot)) = &mut fault.place
            && spot.file != scene
        {
            spot.file = self.found(&spot.file);
        }
        fault
    }
}

impl Source {
    /// Reads a built-in scene or a file.
    pub(crate) fn read(given: &str) -> Result<Source, Fault> {
        let path = Path::new(given);
        let looks_like_path = given.contains(['/', '\\']) || given.ends_with(".toml") || path.exists();
        let source = |file: &str, text: String, folder: PathBuf| Source {
            given: given.into(),
            file: file.into(),
            text,
            beside: Beside::new(folder),
        };
        if let Some(scene) = builtin(given)
            && !path.is_file()
        {
            return Ok(source(&scene.file(), scene.text.into(), PathBuf::new()));
        }
        if !looks_like_path {
            let names: Vec<&str> = SCENES.iter().map(|scene| scene.name).collect();
            let message = format!("`{given}` is neither a file nor a built-in scene");
            let place = Some(Place::Flag(given.to_string()));
            return Err(Fault { place, ..Fault::new("no-scene", message, did_you_mean(given, &names)) });
        }
        let bytes = bounded::whole(path, LARGEST_SCENE).map_err(|error| Fault {
            place: Some(Place::Flag(given.to_string())),
            ..Fault::new(
                "unreadable",
                format!("cannot read the scene {given}: {error}"),
                "give the path of a TOML file, or a name from `wearshape new --list`",
            )
        })?;
        let text = String::from_utf8(bytes).map_err(|error| Fault {
            place: Some(Place::Flag(given.to_string())),
            ..Fault::new("not-text", format!("{given} is not UTF-8 text: {error}"), "save the scene as UTF-8")
        })?;
        Ok(source(given, text, path.parent().unwrap_or(Path::new("")).to_path_buf()))
    }

    /// The scene with some `--set` options.
    pub(crate) fn document(&self, settings: &[String]) -> Result<Document, Fault> {
        Document::read(&self.file, &self.text, settings)
    }

    /// Whether there is a file of this path beside the scene.
    pub(crate) fn is_beside(&self, path: &str) -> bool {
        self.beside.folder.join(path).is_file()
    }

    /// The bytes of a file beside the scene, or why there are none.
    pub(crate) fn beside(&self, path: &str) -> Result<Vec<u8>, String> {
        self.beside.read(path)
    }

    /// The problem that a document of this scene poses.
    pub(crate) fn pose(&self, document: &Document) -> Result<Problem, Fault> {
        Problem::new(document, &|path| self.beside.read(path)).map_err(|fault| self.beside.named(&self.given, fault))
    }

    /// The scene with some `--set` options, checked: with its document, which knows where the keys stand.
    pub(crate) fn problem(&self, settings: &[String]) -> Result<(Document, Problem), Fault> {
        let document = self.document(settings)?;
        let problem = self.pose(&document)?;
        Ok((document, problem))
    }
}

/// A scene by its name or path, checked: with its document, which knows where the keys stand.
pub(crate) fn problem(given: &str, settings: &[String]) -> Result<(Document, Problem), Fault> {
    Source::read(given)?.problem(settings)
}
