//! Pages on the keys of a scene, from its schema.

use super::examples::Examples;
use super::made::Made;
use super::play::Player;
use super::schema::{Key, Schema};

fn schema(player: &Player<'_>) -> Result<Schema, String> {
    let (code, text) = player.line(&player.runs.join("keys"), "wearshape schema")?;
    let value = serde_json::from_str(&text).map_err(|error| format!("wearshape schema ended with {code}: {error}"))?;
    Ok(Schema(value))
}

/// A page for each table of the scene. Both bodies have one.
pub(super) fn pages(player: &Player<'_>) -> Result<Vec<Made>, String> {
    let (schema, examples) = (schema(player)?, Examples::read(player)?);
    let mut pages = Vec::new();
    let mut bare = Vec::new();
    for top in schema.tops() {
        let keys = schema.keys(&top);
        if top == "body2" || !keys.iter().any(|key| key.is_table) {
            continue;
        }
        let title = if top == "body1" { "body1, body2".into() } else { top.clone() };
        let mut text = format!("# {title}\n");
        for key in &keys {
            text += &section(key, &examples, &mut bare);
        }
        pages.push(Made { title: format!("`{title}`"), path: format!("book/keys/{top}.md"), text });
    }
    if bare.is_empty() {
        return Ok(pages);
    }
    Err(format!("keys without an example in a built-in scene or in book/examples.toml: {}", bare.join(", ")))
}

/// The keys of the scene itself: those with a value, and the list of tables.
pub(super) fn top(player: &Player<'_>) -> Result<String, String> {
    let (schema, examples) = (schema(player)?, Examples::read(player)?);
    let mut bare = Vec::new();
    let (mut single, mut tables) = (String::new(), String::new());
    for top in schema.tops() {
        let keys = schema.keys(&top);
        if keys.iter().any(|key| key.is_table) {
            let page = if top == "body2" { "body1" } else { &top };
            tables += &format!("- [`{top}`](keys/{page}.md): {}\n", keys[0].meaning);
        } else {
            single += &keys.iter().map(|key| section(key, &examples, &mut bare)).collect::<String>().replace("../keys.md#", "#");
        }
    }
    if !bare.is_empty() {
        return Err(format!("keys without an example: {}", bare.join(", ")));
    }
    Ok(format!("## Tables\n\n{tables}\n## Keys outside of tables\n{single}"))
}

/// Quantities and their units.
pub(super) fn units(player: &Player<'_>) -> Result<String, String> {
    let rows = schema(player)?.quantities().into_iter().map(|[_, row]| {
        let (what, units) = row.split_once(" | ").unwrap_or((&row, ""));
        let units: Vec<String> = units.split(", ").map(|unit| format!("`{unit}`")).collect();
        format!("| {what} | {} | {} |\n", units.first().map_or("", String::as_str), units.join(", "))
    });
    let rows: String = rows.collect();
    Ok(format!("| quantity | of a bare number | in a text |\n|---|---|---|\n{rows}"))
}

/// What the book says of one key.
fn section(key: &Key, examples: &Examples, bare: &mut Vec<String>) -> String {
    let depth = "#".repeat((key.path.split('.').count() + 1).clamp(2, 4));
    let path = &key.path;
    let mut facts = vec![key.kind.clone()];
    facts.extend(key.required.then(|| "must be given".to_string()));
    facts.extend(key.default.as_ref().map(|default| format!("default: {default}")));
    facts.retain(|fact| !fact.is_empty());
    let mut text = format!("\n{depth} `{path}` {{#{path}}}\n\n{}\n\n*{}*\n", key.meaning, facts.join("; "));
    if key.words.iter().any(|[_, meaning]| !meaning.is_empty()) {
        text += "\n";
        text.extend(key.words.iter().map(|[word, meaning]| format!("- `{word}`: {meaning}\n")));
    } else if !key.words.is_empty() {
        let words: Vec<String> = key.words.iter().map(|[word, _]| format!("`{word}`")).collect();
        text += &format!("\nWords: {}.\n", words.join(", "));
    }
    match examples.of(&key.path) {
        Some(example) if example.scene.is_empty() => text += &format!("\n```toml\n{}\n```\n", example.line),
        Some(example) => text += &format!("\n```toml\n{}  # {}\n```\n", example.line, example.scene),
        // A table is shown by its keys.
        None if key.is_table => {}
        None => bare.push(key.path.clone()),
    }
    text
}
