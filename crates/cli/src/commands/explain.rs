//! `wearshape explain`: the page behind a note.

use scene::{Fault, Place, did_you_mean};

use crate::exit::Exit;
use crate::print::print_out;

/// All notes, a section each.
const PAGE: &str = include_str!("../../../../docs/lints.md");

/// Longest line of the list, and of a page.
const LINE: usize = 100;
const WIDTH: usize = 80;

/// Prints the section of a code, or the list of codes with what each says.
pub(crate) fn run(code: Option<&str>) -> Result<Exit, Fault> {
    let Some(wanted) = code else {
        let lines = sections().map(|(code, text)| format!("{code:<22} {}\n", first_sentence(text)));
        print_out(&(lines.collect::<String>() + "\nmore: wearshape explain CODE\n"));
        return Ok(Exit::Done);
    };
    let Some((code, text)) = sections().find(|(code, _)| *code == wanted) else {
        return Err(Fault {
            place: Some(Place::Flag(wanted.to_string())),
            ..Fault::new("no-note", format!("there is no note `{wanted}`"), meant(wanted))
        });
    };
    print_out(&format!("{code}\n\n{}", wrapped(text)));
    Ok(Exit::Done)
}

/// Paragraphs in lines that fit a terminal.
fn wrapped(text: &str) -> String {
    let mut out = String::new();
    for (number, paragraph) in text.split("\n\n").enumerate() {
        out += if number > 0 { "\n" } else { "" };
        let mut line = String::new();
        for word in paragraph.split_whitespace() {
            if !line.is_empty() && line.chars().count() + 1 + word.chars().count() > WIDTH {
                out += &format!("{line}\n");
                line.clear();
            }
            line += if line.is_empty() { "" } else { " " };
            line += word;
        }
        out += &format!("{line}\n");
    }
    out
}

/// The codes of all notes.
pub(crate) fn codes() -> Vec<&'static str> {
    sections().map(|(code, _)| code).collect()
}

/// What may be meant by a word that is no code: the nearest one, or the notes that speak of it.
fn meant(word: &str) -> String {
    let near = did_you_mean(word, &codes());
    if let Some((near, _)) = near.split_once(" known here").filter(|_| near.starts_with("did you mean")) {
        return format!("{near} `wearshape explain` lists all notes");
    }
    let word = word.to_lowercase();
    let speak = sections().filter(|(code, text)| code.contains(&word) || text.to_lowercase().contains(&word));
    let speak: Vec<&str> = speak.map(|(code, _)| code).take(4).collect();
    match speak.as_slice() {
        [] => "`wearshape explain` lists all notes".into(),
        some => format!("notes that speak of it: {}; `wearshape explain` lists all", some.join(", ")),
    }
}

/// The first sentence of a section in one line, without marks.
fn first_sentence(text: &str) -> String {
    let paragraph = text.split("\n\n").next().unwrap_or("").replace('\n', " ").replace('`', "");
    let sentence = paragraph.split(". ").next().unwrap_or("").trim_end_matches('.').to_string();
    let room = LINE - 23;
    if sentence.chars().count() <= room {
        return sentence;
    }
    let cut: String = sentence.chars().take(room - 3).collect();
    format!("{}...", cut.rsplit_once(' ').map_or(cut.as_str(), |(whole, _)| whole))
}

/// Code and text of every section.
fn sections() -> impl Iterator<Item = (&'static str, &'static str)> {
    PAGE.split("\n## ").skip(1).filter_map(|section| section.split_once('\n')).map(|(code, text)| (code, text.trim()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_note_of_the_program_has_its_section_and_every_section_its_note() {
        let files = [
            include_str!("../../../wearshape/src/setup/remarks.rs"),
            include_str!("../../../wearshape/src/hindsight.rs"),
            include_str!("../../../wearshape/src/hot_hindsight.rs"),
            include_str!("../../../wearshape/src/steps/sharp_edges.rs"),
        ];
        let source: String = files.iter().filter_map(|file| file.split("#[cfg(test)]").next()).collect();
        let is_code = |word: &&str| word.contains('-') && word.bytes().all(|c| c.is_ascii_lowercase() || c == b'-');
        for code in source.split('"').skip(1).step_by(2).filter(is_code) {
            assert!(sections().any(|(known, _)| known == code), "no section for {code}");
        }
        for (code, _) in sections() {
            assert!(source.contains(&format!("\"{code}\"")), "no note {code}");
        }
    }
}
