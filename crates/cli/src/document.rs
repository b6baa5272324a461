//! A scene with its text, so that every later complaint can point into it.

use std::fs;
use std::path::{Path, PathBuf};

use serde::Deserialize;

use crate::builtin;
use crate::fault::{Fault, Place, did_you_mean};
use crate::flags;
use crate::read::Mismatch;
use crate::scene::Scene;
use crate::tree::{self, Node, Origin};

/// A scene as read, with where each key was written.
#[derive(Debug, Clone)]
pub(crate) struct Document {
    /// Short name: of the built-in scene, or of the file without folder and ending.
    pub(crate) name: String,
    /// The name in messages.
    file: String,
    /// Folder that relative paths in the scene are meant from.
    pub(crate) folder: PathBuf,
    text: String,
    tree: Node,
    settings: Vec<String>,
    /// The scene.
    pub(crate) scene: Scene,
}

impl Document {
    /// Reads a built-in scene or a file and applies the `--set` options.
    pub(crate) fn open(given: &str, settings: &[String]) -> Result<Document, Fault> {
        let (name, file, folder, text) = source(given)?;
        Document::read(name, file, folder, text, settings)
    }

    /// Reads a scene from its text.
    pub(crate) fn read(
        name: String,
        file: String,
        folder: PathBuf,
        text: String,
        settings: &[String],
    ) -> Result<Document, Fault> {
        let mut tree = tree::parse(&text).map_err(|(message, span)| Fault {
            place: Some(Place::file(&file, &text, span)),
            ..Fault::new("syntax", format!("this is not TOML: {message}"), "write `key = value`; text in double quotes")
        })?;
        if text.lines().all(|line| line.trim().is_empty() || line.trim().starts_with('#')) && settings.is_empty() {
            return Err(Fault {
                place: Some(Place::file(&file, &text, 0..0)),
                ..Fault::new(
                    "empty-scene",
                    "the scene is empty",
                    "begin with a template: `wearshape new drum-brake-block my-scene.toml`",
                )
            });
        }
        flags::apply(&mut tree, settings)?;
        let settings = settings.to_vec();
        let scene = match Scene::deserialize(&tree) {
            Ok(scene) => scene,
            Err(mismatch) => return Err(explain(mismatch, &file, &text, &settings)),
        };
        Ok(Document { name, file, folder, text, tree, settings, scene })
    }

    /// Whether a dotted key was written in the file or by a flag.
    pub(crate) fn has(&self, key: &str) -> bool {
        self.tree.find(key).is_some()
    }

    /// Gives a fault its place from its key.
    pub(crate) fn locate(&self, mut fault: Fault) -> Fault {
        if fault.place.is_none() {
            let origin = fault.key.as_deref().and_then(|key| self.tree.place_of(key));
            let origin = origin.unwrap_or(Origin::File(0..0));
            fault.place = Some(place(&origin, &self.file, &self.text, &self.settings));
        }
        fault
    }
}

fn source(given: &str) -> Result<(String, String, PathBuf, String), Fault> {
    let path = Path::new(given);
    let looks_like_path = given.contains(['/', '\\']) || given.ends_with(".toml") || path.exists();
    if let Some(scene) = builtin::find(given)
        && !path.is_file()
    {
        let file = format!("{given}.toml (built in)");
        return Ok((given.to_string(), file, PathBuf::from("."), scene.text.to_string()));
    }
    if !looks_like_path {
        let names: Vec<&str> = builtin::SCENES.iter().map(|scene| scene.name).collect();
        let message = format!("`{given}` is neither a file nor a built-in scene");
        return Err(Fault::new("no-scene", message, did_you_mean(given, &names)));
    }
    let bytes = fs::read(path).map_err(|error| Fault {
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
    let name = path.file_stem().map_or_else(|| given.to_string(), |stem| stem.to_string_lossy().into_owned());
    let folder = path.parent().map_or_else(|| PathBuf::from("."), Path::to_path_buf);
    Ok((name, given.to_string(), folder, text))
}

fn explain(mismatch: Mismatch, file: &str, text: &str, settings: &[String]) -> Fault {
    let origin = mismatch.origin.unwrap_or(Origin::File(0..0));
    let key = mismatch.path.join(".");
    let mut message = mismatch.message;
    if !key.is_empty() && !message.contains(&format!("`{key}`")) {
        message = format!("{key}: {message}");
    }
    let mut remedy = mismatch.remedy;
    if mismatch.code == "missing-key" && message.contains("`units`") {
        remedy = "add `units = \"N-mm\"`".into();
    }
    Fault { code: mismatch.code, message, key: Some(key), place: Some(place(&origin, file, text, settings)), remedy }
}

fn place(origin: &Origin, file: &str, text: &str, settings: &[String]) -> Place {
    match origin {
        Origin::File(span) => Place::file(file, text, span.clone()),
        Origin::Flag(number) => {
            let setting = settings.get(*number).map_or("", String::as_str);
            Place::Flag(format!("--set {setting}"))
        }
    }
}
