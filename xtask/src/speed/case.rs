//! What is run: every built-in scene, and the cases of verify/speed.toml.

use std::fs;
use std::path::Path;
use toml::{Table, Value};

/// One call of the program.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Case {
    pub(crate) name: String,
    /// The command, `run` for most.
    pub(crate) command: String,
    pub(crate) scene: String,
    pub(crate) set: Vec<String>,
}

impl Case {
    /// A built-in scene as it is.
    fn built_in(name: &str) -> Case {
        Case { name: name.into(), command: "run".into(), scene: name.into(), set: Vec::new() }
    }

    /// Whether a body is a mesh of the user's.
    pub(crate) fn is_meshed(&self) -> bool {
        self.command == "run" && self.scene.contains('/')
    }

    /// Whether it is a built-in scene as it is.
    pub(crate) fn is_built_in(&self) -> bool {
        self.name == self.scene
    }

    /// The words of the call; a run writes into `folder`.
    pub(crate) fn words(&self, folder: &Path) -> Vec<String> {
        let mut words = vec![self.command.clone(), self.scene.clone()];
        self.set.iter().for_each(|change| words.extend(["--set".into(), change.clone()]));
        if self.command == "run" {
            words.extend(["-q", "--no-progress", "--threads", "1", "-o"].map(String::from));
            words.push(folder.to_string_lossy().into_owned());
        }
        words
    }
}

/// All cases: the built-in scenes by name, then those of the table.
pub(crate) fn all(root: &Path) -> Result<Vec<Case>, String> {
    let path = root.join("verify/speed.toml");
    let text = fs::read_to_string(&path).map_err(|error| format!("{}: {error}", path.display()))?;
    let mut cases = built_in(root)?;
    cases.extend(parse(&text).map_err(|message| format!("{}: {message}", path.display()))?);
    Ok(cases)
}

/// The cases with these names, or all of them if none are named.
pub(crate) fn named(cases: Vec<Case>, names: &[String]) -> Result<Vec<Case>, String> {
    if let Some(unknown) = names.iter().find(|name| cases.iter().all(|case| case.name != **name)) {
        let known: Vec<&str> = cases.iter().map(|case| case.name.as_str()).collect();
        return Err(format!("there is no case `{unknown}`; there are: {}", known.join(", ")));
    }
    Ok(cases.into_iter().filter(|case| names.is_empty() || names.contains(&case.name)).collect())
}

fn built_in(root: &Path) -> Result<Vec<Case>, String> {
    let folder = root.join("data/scenes");
    let entries = fs::read_dir(&folder).map_err(|error| format!("{}: {error}", folder.display()))?;
    let names = entries.filter_map(Result::ok).map(|entry| entry.file_name().to_string_lossy().into_owned());
    let mut names: Vec<String> = names.filter_map(|name| name.strip_suffix(".toml").map(String::from)).collect();
    names.sort();
    Ok(names.iter().map(|name| Case::built_in(name)).collect())
}

fn parse(text: &str) -> Result<Vec<Case>, String> {
    let table: Table = text.parse().map_err(|error| format!("{error}"))?;
    let list = table.get("case").and_then(Value::as_array).ok_or("no [[case]]")?;
    list.iter().map(case).collect()
}

fn case(value: &Value) -> Result<Case, String> {
    let word = |key: &str| value.get(key).and_then(Value::as_str).map(String::from);
    let needed = |key: &str| word(key).ok_or(format!("`{key}` is missing or no text"));
    let set = value.get("set").and_then(Value::as_array).map_or(&[][..], Vec::as_slice);
    Ok(Case {
        name: needed("name")?,
        command: word("command").unwrap_or_else(|| "run".into()),
        scene: needed("scene")?,
        set: set.iter().filter_map(Value::as_str).map(String::from).collect(),
    })
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    #[test]
    fn the_table_of_the_repository_is_read_after_the_built_in_scenes() {
        let cases = all(&Path::new(env!("CARGO_MANIFEST_DIR")).join("..")).unwrap();
        assert!(cases[0].is_built_in() && cases.iter().any(Case::is_meshed), "{cases:?}");
        let mut names: Vec<&String> = cases.iter().map(|case| &case.name).collect();
        names.sort();
        names.dedup();
        assert_eq!(names.len(), cases.len());
    }

    #[test]
    fn changes_stand_in_the_call_and_a_check_writes_no_folder() {
        let text = "[[case]]\nname='a'\nscene='s'\nset=['x=1','y=[z]']\n[[case]]\nname='b'\nscene='s'\ncommand='check'\n";
        let cases = parse(text).unwrap();
        let words = cases[0].words(Path::new("out")).join(" ");
        assert_eq!(words, "run s --set x=1 --set y=[z] -q --no-progress --threads 1 -o out");
        assert_eq!(cases[1].words(Path::new("out")).join(" "), "check s");
    }

    #[test]
    fn an_unknown_case_is_an_error_with_those_that_there_are() {
        let cases = vec![Case::built_in("cam")];
        assert!(named(cases.clone(), &["knob".into()]).is_err_and(|message| message.contains("cam")));
        assert_eq!(named(cases.clone(), &[]).unwrap(), cases);
    }
}
