//! A scene is read and shown, before anything is solved.

use scene::{Document, Fault};
use serde_json::{Value, json};
use wearshape::Problem;

use crate::engine::Engine;

/// The drawing, the stages and notes.
pub(crate) fn check(engine: &Engine, name: &str, text: &str) -> Result<Value, Fault> {
    let (document, problem) = posed(engine, name, text, &[])?;
    Ok(json!({
        "title": problem.title(),
        "drawing": report::drawing(&problem),
        "notes": problem.remarks(),
        "unused": problem.unused_keys(),
        "stages": problem.plan().stages,
        // Whether the mesh follows from an accuracy, and a coarse one may be tried first.
        "adaptive": document.scene.mesh.is_none(),
    }))
}

/// The values that are written, with key and line.
pub(crate) fn written(name: &str, text: &str) -> Result<Value, Fault> {
    let values = scene::written(&file(name), text)?.into_iter();
    let values = values.map(|value| json!({ "key": value.key, "text": value.text, "line": value.line }));
    Ok(json!({ "written": values.collect::<Vec<_>>() }))
}

/// The problem that a text poses, with changes as of `--set`.
pub(crate) fn posed(engine: &Engine, name: &str, text: &str, settings: &[String]) -> Result<(Document, Problem), Fault> {
    let document = Document::read(&file(name), text, settings)?;
    let problem = Problem::new(&document, &|path| engine.file(path)).map_err(|fault| document.locate(fault))?;
    Ok((document, problem))
}

/// Name of the scene's file, from which the scene has its name.
fn file(name: &str) -> String {
    format!("{name}.toml")
}
