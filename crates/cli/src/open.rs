//! A scene by its name or path: the one place where scene files are opened.

use std::fs;
use std::path::{Path, PathBuf};

use scene::{Document, Fault, Place, SCENES, builtin, did_you_mean};
use wearshape::Problem;

/// Files beside a scene, by their paths as it has them. The folder of the scene is empty where it is the current one.
pub(crate) struct Beside(PathBuf);

impl Beside {
    /// The bytes of a file, or why there are none.
    pub(crate) fn read(&self, path: &str) -> Result<Vec<u8>, String> {
        fs::read(self.0.join(path)).map_err(|error| {
            let found = self.found(path);
            if found == path { error.to_string() } else { format!("{found}: {error}") }
        })
    }

    /// The path of a file as seen from the current folder.
    fn found(&self, path: &str) -> String {
        self.0.join(path).display().to_string()
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

/// A scene by its name or path, checked: with its document, which knows where the keys stand.
pub(crate) fn problem(given: &str, settings: &[String]) -> Result<(Document, Problem), Fault> {
    let (document, beside) = open(given, settings)?;
    let problem = Problem::new(&document, &|path| beside.read(path)).map_err(|fault| beside.named(given, fault))?;
    Ok((document, problem))
}

/// Reads a built-in scene or a file, with the `--set` options, and the place of the files beside it.
pub(crate) fn open(given: &str, settings: &[String]) -> Result<(Document, Beside), Fault> {
    let path = Path::new(given);
    let looks_like_path = given.contains(['/', '\\']) || given.ends_with(".toml") || path.exists();
    if let Some(scene) = builtin(given)
        && !path.is_file()
    {
        return Ok((Document::read(&scene.file(), scene.text, settings)?, Beside(PathBuf::new())));
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
    let folder = path.parent().unwrap_or(Path::new("")).to_path_buf();
    Ok((Document::read(given, &text, settings)?, Beside(folder)))
}
