//! JSON for files.

/// Version of the summary's keys.
pub const SCHEMA_VERSION: u32 = 1;

/// JSON for a file.
pub fn pretty(value: &serde_json::Value) -> String {
    format!("{value:#}\n")
}

/// JSON in which no character acts on a terminal or turns the text of a page: such are written as escapes, as which they read back.
pub fn inert(json: String) -> String {
    if !json.contains(scene::acts) {
        return json;
    }
    json.chars().map(|c| if scene::acts(c) { format!("\\u{:04x}", u32::from(c)) } else { c.to_string() }).collect()
}
