//! The schema of a scene as a list of keys in words.

use serde_json::Value;

/// One key.
pub(super) struct Key {
    /// Dotted, with a word in capitals for a name of the user's.
    pub path: String,
    /// What may be written.
    pub kind: String,
    /// What is taken where it is not written.
    pub default: Option<String>,
    pub required: bool,
    pub meaning: String,
    /// Allowed words, each with its meaning.
    pub words: Vec<[String; 2]>,
    /// Whether it is a table of keys that follow.
    pub is_table: bool,
}

/// The schema, whose references are followed.
pub(super) struct Schema(pub Value);

impl Schema {
    /// Names of the keys of the scene itself.
    pub(super) fn tops(&self) -> Vec<String> {
        self.0["properties"].as_object().map(|keys| keys.keys().cloned().collect()).unwrap_or_default()
    }

    /// Names, expected text and pattern of the quantities with units.
    pub(super) fn quantities(&self) -> Vec<[String; 2]> {
        let definitions = self.0["definitions"].as_object().into_iter().flatten();
        let quantity = |(name, schema): (&String, &Value)| {
            let (what, units) = units(schema)?;
            Some([name.clone(), format!("{what} | {units}")])
        };
        definitions.filter_map(quantity).collect()
    }

    /// A key of the scene itself and all keys below it.
    pub(super) fn keys(&self, top: &str) -> Vec<Key> {
        let mut keys = Vec::new();
        let required = required(&self.0, top);
        self.walk(top, &self.0["properties"][top], required, &mut keys);
        keys
    }

    fn walk(&self, path: &str, schema: &Value, required: bool, keys: &mut Vec<Key>) {
        let options = self.options(schema);
        let (meaning, default) = parted(self.meaning(schema));
        let tables: Vec<&Value> = options.iter().copied().filter(|option| is_table(option)).collect();
        let items = options.iter().filter(|option| option["items"].is_object()).flat_map(|list| self.options(&list["items"]));
        let words = options.iter().copied().chain(items).flat_map(words).collect();
        let kinds: Vec<String> = options.iter().filter_map(|option| self.kind(option, schema)).collect();
        let kind = joined(kinds) + &range(schema);
        keys.push(Key { path: path.into(), kind, default, required, meaning, words, is_table: !tables.is_empty() });
        for table in tables {
            for (name, inner) in table["properties"].as_object().into_iter().flatten() {
                let path = format!("{path}.{name}");
                if keys.iter().all(|key| key.path != path) {
                    self.walk(&path, inner, required_in(table, name), keys);
                }
            }
            if table["additionalProperties"].is_object() {
                self.walk(&format!("{path}.NAME"), &table["additionalProperties"], false, keys);
            }
        }
    }

    /// Whatever may stand for a schema, references followed and `null` left out.
    fn options<'a>(&'a self, schema: &'a Value) -> Vec<&'a Value> {
        let schema = self.followed(schema);
        for word in ["anyOf", "oneOf", "allOf"] {
            if let Some(options) = schema[word].as_array().filter(|_| units(schema).is_none()) {
                return options
                    .iter()
                    .filter(|option| option["type"] != "null")
                    .flat_map(|option| self.options(option))
                    .collect();
            }
        }
        vec![schema]
    }

    fn followed<'a>(&'a self, schema: &'a Value) -> &'a Value {
        match schema["$ref"].as_str().and_then(|name| name.rsplit('/').next()) {
            Some(name) => self.followed(&self.0["definitions"][name]),
            None => schema,
        }
    }

    /// What is said of a key: by itself, or by its type.
    fn meaning<'a>(&'a self, schema: &'a Value) -> &'a str {
        let own = schema["description"].as_str();
        let inner = || {
            let inner = self.followed(schema);
            inner["description"].as_str().filter(|_| units(inner).is_none())
        };
        own.filter(|_| units(schema).is_none()).or_else(inner).unwrap_or_default()
    }

    /// One option in words; none for a fixed word, which stands in the list of words.
    fn kind(&self, option: &Value, whole: &Value) -> Option<String> {
        if let Some((what, unit)) = units(option) {
            let unit = unit.split(',').next().unwrap_or_default();
            return Some(format!("[{what}](../keys.md#units) in {unit}"));
        }
        if option["const"].is_string() {
            return Some("one of the words below".into());
        }
        let kinds = option["type"].as_array().and_then(|kinds| kinds.first()).unwrap_or(&option["type"]);
        Some(match kinds.as_str() {
            Some("array") => self.list(option),
            Some("integer") => "whole number".into(),
            Some("boolean") => "`true` or `false`".into(),
            Some("object") if option["additionalProperties"].is_object() => "table with names of your own".into(),
            Some("object") => "table".into(),
            Some("string") if option["pattern"].is_string() => "number with unit".into(),
            Some("string") => "text".into(),
            Some(other) => format!("{other}{}", if std::ptr::eq(option, whole) { String::new() } else { range(option) }),
            None if option["enum"].is_array() => "one of the words below".into(),
            None => return None,
        })
    }

    fn list(&self, option: &Value) -> String {
        let kinds = self.options(&option["items"]);
        let item = joined(kinds.iter().filter_map(|kind| self.kind(kind, &Value::Null)).collect());
        match (option["minItems"].as_u64(), option["maxItems"].as_u64()) {
            (Some(least), Some(most)) if least == most => format!("list of {least}: {item}"),
            _ => format!("list: {item}"),
        }
    }
}

/// What a quantity is and its units, of a schema made of "a length as a number in mm, or a string with one of the units mm, m".
fn units(schema: &Value) -> Option<(&str, &str)> {
    let text = schema["description"].as_str()?;
    let (what, _) = text.split_once(" as a number in ")?;
    let (_, units) = text.split_once("with one of the units ")?;
    Some((what.trim_start_matches("a ").trim_start_matches("an "), units))
}

fn is_table(option: &Value) -> bool {
    option["properties"].is_object() || option["additionalProperties"].is_object()
}

fn required(schema: &Value, name: &str) -> bool {
    schema["required"].as_array().is_some_and(|names| names.iter().any(|other| other == name))
}

/// Whether a table needs a key; one that is the only key of an alternative is a choice.
fn required_in(table: &Value, name: &str) -> bool {
    required(table, name) && table["properties"].as_object().is_some_and(|keys| keys.len() > 1)
}

/// Allowed words of an option.
fn words(option: &Value) -> Vec<[String; 2]> {
    let one = option["const"].as_str().map(|word| [word.into(), option["description"].as_str().unwrap_or_default().into()]);
    let many = option["enum"].as_array().into_iter().flatten().filter_map(Value::as_str).map(|word| [word.into(), String::new()]);
    one.into_iter().chain(many).collect()
}

/// Limits of a number in words.
fn range(schema: &Value) -> String {
    let limits = [
        ("exclusiveMinimum", "greater than"),
        ("minimum", "at least"),
        ("exclusiveMaximum", "less than"),
        ("maximum", "at most"),
    ];
    let told = limits.iter().filter_map(|(key, words)| Some(format!(", {words} {}", schema[key].as_f64()?)));
    told.collect()
}

/// Options once each, with "or" between them.
fn joined(kinds: Vec<String>) -> String {
    let mut once: Vec<String> = Vec::new();
    for kind in kinds {
        if !once.contains(&kind) {
            once.push(kind);
        }
    }
    once.join(", or ")
}

/// A description without its sentence on the default, and that.
fn parted(text: &str) -> (String, Option<String>) {
    let text = text.replace('\n', " ");
    let Some((before, after)) = text.split_once("Default") else { return (text, None) };
    let end = after.find(". ").map_or(after.len(), |end| end + 1);
    let default = after[..end].trim_start_matches(':').trim().trim_end_matches('.').to_string();
    (format!("{}{}", before, after[end..].trim_start()).trim().to_string(), Some(default))
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    #[test]
    fn keys_have_kind_unit_default_and_words() {
        let schema = Schema(json!({
            "properties": { "contact": { "anyOf": [{ "$ref": "#/definitions/Contact" }, { "type": "null" }] } },
            "required": ["contact"],
            "definitions": {
                "Length": { "description": "a length as a number in mm, or a string with one of the units mm, m", "anyOf": [] },
                "Contact": { "type": "object", "description": "The contact.", "required": ["as"], "properties": {
                    "clearance": { "description": "Radial. Default 0.", "allOf": [{ "$ref": "#/definitions/Length" }], "minimum": 0 },
                    "as": { "oneOf": [{ "const": "rigid", "description": "A line." }] }
                } }
            }
        }));
        let keys = schema.keys("contact");
        let told: Vec<_> = keys.iter().map(|key| (key.path.as_str(), key.kind.as_str(), key.required)).collect();
        let length = "[length](../keys.md#units) in mm, at least 0";
        let expected =
            [("contact", "table", true), ("contact.as", "one of the words below", true), ("contact.clearance", length, false)];
        assert_eq!(told.len(), 3);
        assert!(expected.iter().all(|key| told.contains(key)), "{told:?}");
        let clearance = keys.iter().find(|key| key.path.ends_with("clearance")).expect("a key");
        assert_eq!((clearance.meaning.as_str(), clearance.default.as_deref()), ("Radial.", Some("0")));
        assert_eq!(keys.iter().flat_map(|key| &key.words).collect::<Vec<_>>(), [&["rigid".to_string(), "A line.".into()]]);
        assert_eq!(schema.quantities(), [["Length".to_string(), "length | mm, m".into()]]);
    }
}
