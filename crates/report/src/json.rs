//! JSON for files.

/// Version of the summary's keys.
pub const SCHEMA_VERSION: u32 = 1;

/// JSON for a file.
pub fn pretty(value: &serde_json::Value) -> String {
    serde_json::to_string_pretty(value).unwrap_or_default() + "\n"
}
