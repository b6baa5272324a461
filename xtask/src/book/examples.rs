//! Examples of keys: from the built-in scenes, and where none has the key from `book/examples.toml`.

use std::collections::BTreeMap;
use std::fs;
use toml::Value;
use toml::de::DeTable;

use super::files::read;
use super::gallery;
use super::play::Player;

/// Where the keys stand that no built-in scene has.
const MORE: &str = "book/examples.toml";

/// Letters of a line.
const LINE: usize = 70;

/// An example of a key.
pub(super) struct Example {
    /// Key and value, as they are written.
    pub line: String,
    /// Where it is from.
    pub scene: String,
}

/// An example of each key that has one.
pub(super) struct Examples {
    found: Vec<(Vec<String>, Example)>,
}

impl Examples {
    /// Reads the built-in scenes and the other examples.
    pub(super) fn read(player: &Player<'_>) -> Result<Examples, String> {
        let mut found = Vec::new();
        for scene in gallery::scenes(player)? {
            let table = DeTable::parse(&scene.text).map_err(|error| format!("{}: {error}", scene.name))?;
            collect(&mut Vec::new(), table.get_ref(), &scene.text, &mut |path, value| {
                let line = format!("{} = {value}", path.join("."));
                found.push((path.to_vec(), Example { line, scene: scene.name.clone() }));
            });
        }
        for more in more(player)? {
            let path = more.key.split('.').map(String::from).collect();
            found.push((path, Example { line: format!("{} = {}", more.key, more.value), scene: String::new() }));
        }
        Ok(Examples { found })
    }

    /// The example of a key of the schema, whose names of the user's are words in capitals: the first that fits into a line, or the shortest.
    pub(super) fn of(&self, key: &str) -> Option<&Example> {
        let parts: Vec<&str> = key.split('.').collect();
        let fits = |path: &[String]| {
            path.len() == parts.len() && path.iter().zip(&parts).all(|(have, want)| *want == "NAME" || have == want)
        };
        let found: Vec<&Example> = self.found.iter().filter(|(path, _)| fits(path)).map(|(_, example)| example).collect();
        let short = found.iter().find(|example| example.line.len() <= LINE);
        short.or_else(|| found.iter().min_by_key(|example| example.line.len())).copied()
    }
}

/// Every key of a table with its value as it is written, tables in braces too.
fn collect(path: &mut Vec<String>, table: &DeTable<'_>, text: &str, tell: &mut impl FnMut(&[String], &str)) {
    for (name, value) in table.iter() {
        path.push(name.get_ref().to_string());
        let inner = value.get_ref().as_table();
        let written = text.get(value.span()).unwrap_or_default();
        if inner.is_none() || written.starts_with('{') {
            tell(path, &written.split_whitespace().collect::<Vec<_>>().join(" "));
        }
        if let Some(inner) = inner {
            collect(path, inner, text, tell);
        }
        path.pop();
    }
}

/// A key and a value with a scene that takes it.
struct More {
    key: String,
    value: String,
    scene: String,
    set: Vec<String>,
}

fn more(player: &Player<'_>) -> Result<Vec<More>, String> {
    let tables: BTreeMap<String, Value> =
        toml::from_str(&read(&player.root.join(MORE))?).map_err(|error| format!("{MORE}: {error}"))?;
    let one = |(key, table): (String, Value)| {
        let text = |word: &str| table.get(word).and_then(Value::as_str).map(String::from);
        let set = table.get("with").and_then(Value::as_array).into_iter().flatten();
        let set = set.filter_map(Value::as_str).map(String::from).collect();
        let missing = || format!("{MORE}: `{key}` needs `value` and `scene`");
        Ok(More { value: text("value").ok_or_else(missing)?, scene: text("scene").ok_or_else(missing)?, set, key })
    };
    tables.into_iter().map(one).collect()
}

/// Holds the examples that no built-in scene has against the program; how many they are.
pub(super) fn checked(player: &Player<'_>) -> Result<usize, String> {
    let folder = player.runs.join("examples");
    fs::create_dir_all(&folder).map_err(|error| format!("{}: {error}", folder.display()))?;
    fs::write(folder.join("profile.csv"), "s_mm,gap_um\n-60,0\n0,1\n60,0\n").map_err(|error| format!("profile.csv: {error}"))?;
    let examples = more(player)?;
    for More { key, value, scene, set } in &examples {
        let setting = |set: &String| format!(" --set '{set}'");
        let sets: String = set.iter().chain([&format!("{key}={value}")]).map(setting).collect();
        let (code, words) = player.line(&folder, &format!("wearshape check {scene}{sets}"))?;
        if code != 0 {
            return Err(format!("{MORE}: `{key} = {value}` is refused with {code}:\n{words}"));
        }
    }
    Ok(examples.len())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_are_shown_as_they_are_written() {
        let text = "accuracy = 1e-6\n[body1]\nsupport = { left = [\"x\"] }\ngeometry.ring.inner = \"2 cm\"\n";
        let mut lines = Vec::new();
        let table = DeTable::parse(text).expect("TOML");
        collect(&mut Vec::new(), table.get_ref(), text, &mut |path, value| lines.push(format!("{} = {value}", path.join("."))));
        lines.sort();
        let support = "body1.support = { left = [\"x\"] }";
        assert_eq!(lines, ["accuracy = 1e-6", "body1.geometry.ring.inner = \"2 cm\"", support, "body1.support.left = [\"x\"]"]);
    }

    #[test]
    fn a_name_of_the_users_stands_for_any() {
        let example = |path: &str, line: &str| {
            (path.split('.').map(String::from).collect(), Example { line: line.into(), scene: "a".into() })
        };
        let long = "x".repeat(LINE + 1);
        let found =
            vec![example("body1.support.left", &long), example("body1.support.top", "top"), example("body1.support", "all")];
        let examples = Examples { found };
        assert_eq!(examples.of("body1.support.NAME").map(|example| example.line.as_str()), Some("top"));
        assert!(examples.of("body1.support.NAME.pin").is_none());
    }
}
