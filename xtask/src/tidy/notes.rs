//! Notes on scenes and results: each code has its section in `docs/lints.md`.

use super::finding::{Finding, TextFile};

/// Where the sections stand.
const SECTIONS: &str = "docs/lints.md";
/// Where notes are made.
const SOURCES: &str = "crates/wearshape/src/";
/// What stands before a code.
const SAID: [&str; 2] = ["say(", "Remark { code:"];

/// Codes without a section.
pub(super) fn check(files: &[TextFile]) -> Vec<Finding> {
    let Some(sections) = files.iter().find(|file| file.path == SECTIONS) else { return Vec::new() };
    let is_told = |code: &str| sections.text.lines().any(|line| line.strip_prefix("## ") == Some(code));
    let mut findings = Vec::new();
    for file in files.iter().filter(|file| file.path.starts_with(SOURCES) && file.path.ends_with(".rs")) {
        for (at, code) in codes(&file.text).filter(|(_, code)| !is_told(code)) {
            findings.push(Finding {
                file: file.path.clone(),
                line: 1 + file.text[..at].matches('\n').count(),
                problem: format!("the note `{code}` has no section"),
                remedy: format!("add `## {code}` to {SECTIONS}: one sentence, what is behind it, what to do"),
            });
        }
    }
    findings
}

/// Codes in a source, with their places.
fn codes(text: &str) -> impl Iterator<Item = (usize, &str)> {
    SAID.iter().flat_map(|said| text.match_indices(said)).filter_map(|(at, said)| {
        let word = text[at + said.len()..].trim_start().strip_prefix('"')?;
        Some((at, word.split('"').next()?))
    })
}

#[cfg(test)]
mod tests {
    use super::super::finding::file;
    use super::*;

    #[test]
    fn a_code_without_a_section_is_found_at_its_line() {
        let sections = file(SECTIONS, "# Notes\n\n## told\n\nWords.\n");
        let source = "fn f() {\n    say(\"told\", text);\n    say(\n        \"new\",\n        text,\n    );\n    Some(Remark { code: \"late\", message })\n}\n";
        let found = check(&[sections, file("crates/wearshape/src/notes.rs", source)]);
        let found: Vec<(usize, &str)> = found.iter().map(|finding| (finding.line, finding.problem.as_str())).collect();
        assert_eq!(found, [(3, "the note `new` has no section"), (7, "the note `late` has no section")]);
    }
}
