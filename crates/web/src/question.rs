//! The questions that the page may ask.

use serde_json::{Map, Value, json};

use crate::check::{check, posed, written};
use crate::engine::Engine;
use crate::fault::fault;
use crate::solve::solve;

/// Answers a question: `{ "ask": .. }` with what it needs. The answer of a scene with a mistake is `{ "fault": .. }`.
pub(crate) fn answered(engine: &mut Engine, question: &[u8]) -> Value {
    // As text, which the library reads JSON from too: reading it from bytes is a second reader in the module.
    let question = std::str::from_utf8(question).unwrap_or_default();
    let question: Value = serde_json::from_str(question).unwrap_or_default();
    let text = |key: &str| question[key].as_str().unwrap_or("");
    let settings: Vec<String> =
        question["settings"].as_array().into_iter().flatten().filter_map(Value::as_str).map(String::from).collect();
    let answer = match text("ask") {
        "known" => Ok(known()),
        "written" => written(text("name"), text("text")),
        "check" => check(engine, text("name"), text("text")),
        "keep" => Ok(kept(engine, &question["files"])),
        "edit" => edited(text("text"), &question["edits"]),
        "solve" => posed(engine, text("name"), text("text"), &settings).and_then(|(document, problem)| {
            solve(engine, problem, question["coarse"] == true).map_err(|fault| document.locate(fault))
        }),
        "files" => Ok(files(engine)),
        other => Ok(json!({ "unknown": other })),
    };
    answer.unwrap_or_else(|wrong| json!({ "fault": fault(wrong) }))
}

/// Scenes and materials.
fn known() -> Value {
    let scenes = scene::SCENES.iter().map(|scene| json!({ "name": scene.name, "title": scene.title(), "text": scene.text }));
    let materials = scene::known_materials();
    let materials = materials.iter().map(|material| {
        json!({ "name": material.name, "young_GPa": material.young, "poisson": material.poisson, "source": material.source, "about": material.about })
    });
    json!({
        "version": env!("CARGO_PKG_VERSION"),
        "scenes": scenes.collect::<Vec<_>>(),
        "materials": materials.collect::<Vec<_>>(),
    })
}

/// The text with other values: `[[key, value], ..]`, the values as TOML.
fn edited(text: &str, edits: &Value) -> Result<Value, scene::Fault> {
    let pairs = edits.as_array().into_iter().flatten();
    let mut pairs = pairs.filter_map(|pair| Some((pair[0].as_str()?, pair[1].as_str()?)));
    let changed = pairs.try_fold(text.to_string(), |text, (key, value)| scene::rewritten(&text, key, value))?;
    Ok(json!({ "text": changed }))
}

/// Files that scenes may name from now on: `[[name, text], ..]`, one character a byte.
fn kept(engine: &mut Engine, files: &Value) -> Value {
    let bytes = |text: &str| text.chars().map(|letter| u8::try_from(letter).ok()).collect::<Option<Vec<u8>>>();
    let read = |file: &Value| Some((file[0].as_str()?.to_string(), bytes(file[1].as_str()?)?));
    engine.files.clear();
    engine.files.extend(files.as_array().into_iter().flatten().filter_map(read));
    json!({ "kept": engine.files.keys().collect::<Vec<_>>() })
}

/// The files of the last solve: name and content.
fn files(engine: &Engine) -> Value {
    let Some((problem, solution)) = &engine.solved else { return json!({ "files": {} }) };
    let files = report::files(problem, solution).into_iter();
    // A page knows no meshes, the only files that are no text.
    let texts: Map<String, Value> =
        files.filter_map(|(name, bytes)| Some((name, json!(String::from_utf8(bytes).ok()?)))).collect();
    json!({ "files": texts })
}
