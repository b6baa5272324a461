//! A scene with its text, so that every later complaint can point into it.

use std::ops::Range;
use std::path::Path;

use serde::Deserialize;

use crate::fault::{Fault, Place};
use crate::flags;
use crate::read::{Mismatch, decimal_comma};
use crate::scene::Scene;
use crate::tree::{self, Node, Origin};

/// A scene as read, with where each key was written.
#[derive(Debug, Clone, PartialEq)]
pub struct Document {
    /// Short name: of the built-in scene, or of the file without folder and ending.
    pub name: String,
    /// The file's name as the user knows it, for messages.
    file: String,
    text: String,
    tree: Node,
    settings: Vec<String>,
    /// The scene.
    pub scene: Scene,
}

impl Document {
    /// Reads a scene from the text of a file and applies the `--set` options; `file` is its name or path in messages.
    ///
    /// # Errors
    /// What is wrong with the writing, with its place and a remedy.
    pub fn read(file: &str, text: &str, settings: &[String]) -> Result<Document, Fault> {
        let mut tree = tree::parse(text).map_err(|(message, span)| syntax(file, text, &message, span))?;
        if text.lines().all(|line| line.trim().is_empty() || line.trim().starts_with('#')) && settings.is_empty() {
            return Err(Fault {
                place: Some(Place::file(file, text, 0..0)),
                ..Fault::new(
                    "empty-scene",
                    "the scene is empty",
                    "begin with a template: `wearshape new drum-brake-block my-scene.toml`",
                )
            });
        }
        flags::apply(&mut tree, settings)?;
        let scene = Scene::deserialize(&tree).map_err(|mismatch| explain(*mismatch, file, text, settings))?;
        let name = Path::new(file).file_stem().map_or_else(|| file.to_string(), |stem| stem.to_string_lossy().into_owned());
        Ok(Document { name, file: file.to_string(), text: text.to_string(), tree, settings: settings.to_vec(), scene })
    }

    /// Whether a dotted key was written in the file or by a flag.
    pub fn has(&self, key: &str) -> bool {
        self.tree.find(key).is_some()
    }

    /// Gives a fault its place, if it has none yet: where its key was written, or the last of its parents that was; else the
    /// first line.
    pub fn locate(&self, mut fault: Fault) -> Fault {
        if fault.place.is_none() {
            let origin = fault.key.as_deref().and_then(|key| self.tree.place_of(key));
            let origin = origin.unwrap_or(Origin::File(0..0));
            fault.place = Some(place(&origin, &self.file, &self.text, &self.settings));
        }
        fault
    }
}

/// What the TOML reader did not understand.
pub(crate) fn syntax(file: &str, text: &str, message: &str, span: Range<usize>) -> Fault {
    let (message, remedy) = match comma_number(text, span.start) {
        Some((written, meant)) => {
            (format!("a decimal comma in `{written}`"), format!("write a decimal point, not a comma: {meant}"))
        }
        None if message.contains("mantissa") => {
            (message.to_string(), "write a digit before and after the decimal point, as in 0.5".to_string())
        }
        None => (message.to_string(), "write `key = value`; text in double quotes".to_string()),
    };
    Fault { place: Some(Place::file(file, text, span)), ..Fault::new("syntax", format!("this is not TOML: {message}"), remedy) }
}

/// A value next to a place of its line that is a number with a decimal comma: as written, and as meant.
fn comma_number(text: &str, at: usize) -> Option<(&str, String)> {
    let before = text.get(..at)?;
    let line = text[before.rfind('\n').map_or(0, |end| end + 1)..].lines().next()?;
    let place = at - before.rfind('\n').map_or(0, |end| end + 1);
    line.match_indices('=').find_map(|(equals, _)| {
        let rest = line[equals + 1..].trim_start();
        let end = rest.find(|c: char| !(c.is_ascii_digit() || "+-,eE".contains(c))).unwrap_or(rest.len());
        let written = rest[..end].trim_end_matches(',');
        let from = line.len() - rest.len();
        let meant = decimal_comma(written)?;
        (from..=from + end + 1).contains(&place).then_some((written, meant))
    })
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
