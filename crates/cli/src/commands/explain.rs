//! `wearshape explain`: the page behind a note.

use scene::{Fault, Place, did_you_mean};

use crate::exit::Exit;
use crate::print::print_out;

/// All notes, a section each.
const PAGE: &str = include_str!("../../../../docs/lints.md");

/// Prints the section of a code, or the list of codes.
pub(crate) fn run(code: Option<&str>) -> Result<Exit, Fault> {
    let codes: Vec<&str> = sections().map(|(code, _)| code).collect();
    let Some(wanted) = code else {
        print_out(&format!("notes: {}\n", codes.join(", ")));
        return Ok(Exit::Done);
    };
    let Some((code, text)) = sections().find(|(code, _)| *code == wanted) else {
        return Err(Fault {
            place: Some(Place::Flag(wanted.to_string())),
            ..Fault::new("no-note", format!("there is no note `{wanted}`"), did_you_mean(wanted, &codes))
        });
    };
    print_out(&format!("{code}\n\n{text}\n"));
    Ok(Exit::Done)
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
        let source = concat!(
            include_str!("../../../wearshape/src/setup/remarks.rs"),
            include_str!("../../../wearshape/src/hindsight.rs"),
            include_str!("../../../wearshape/src/steps/sharp_edges.rs"),
        );
        let is_code = |word: &&str| word.contains('-') && word.bytes().all(|c| c.is_ascii_lowercase() || c == b'-');
        for code in source.split('"').skip(1).step_by(2).filter(is_code) {
            assert!(sections().any(|(known, _)| known == code), "no section for {code}");
        }
        for (code, _) in sections() {
            assert!(source.contains(&format!("\"{code}\"")), "no note {code}");
        }
    }
}
