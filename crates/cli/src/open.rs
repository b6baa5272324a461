//! A scene by its name or path: the one place where scene files are opened.

use std::fs;
use std::path::{Path, PathBuf};

use scene::{Document, Fault, Place, SCENES, builtin, did_you_mean};

/// Reads a built-in scene or a file, with the `--set` options, and says from which folder relative paths in it are meant.
pub(crate) fn open(given: &str, settings: &[String]) -> Result<(Document, PathBuf), Fault> {
    let path = Path::new(given);
    let looks_like_path = given.contains(['/', '\\']) || given.ends_with(".toml") || path.exists();
    if let Some(scene) = builtin(given)
        && !path.is_file()
    {
        return Ok((Document::read(&scene.file(), scene.text, settings)?, PathBuf::from(".")));
    }
    if !looks_like_path {
        let names: Vec<&str> = SCENES.iter().map(|scene| scene.name).collect();
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
    let folder = path.parent().map_or_else(|| PathBuf::from("."), Path::to_path_buf);
    Ok((Document::read(given, &text, settings)?, folder))
}
