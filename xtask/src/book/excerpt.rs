//! Pieces of files of the repository, found by a line of theirs.

/// The piece that begins at the first line with `start`, and the comments above it.
///
/// A line that opens a bracket goes to the line of the same indent that closes it; a table of TOML to the next empty line; any other line stands alone.
pub(super) fn of(text: &str, start: &str) -> Option<String> {
    let lines: Vec<&str> = text.lines().collect();
    let found = lines.iter().position(|line| line.contains(start))?;
    // A key at the head of a table stands for all of it.
    let at = if found > 0 && lines[found - 1].starts_with('[') { found - 1 } else { found };
    let indent = indent(lines[at]);
    let comment = |line: &str| ["///", "#["].iter().any(|mark| line.trim_start().starts_with(mark));
    let above = lines[..at].iter().rev().take_while(|line| comment(line)).count();
    let after = &lines[at + 1..];
    let closes = |line: &&str| self::indent(line) == indent && line.trim_start().starts_with([')', ']', '}']);
    let below = match lines[at].trim_end() {
        line if line.ends_with(['{', '(', '[']) => after.iter().position(closes).map_or(0, |end| end + 1),
        line if line.trim_start().starts_with('[') => after.iter().take_while(|line| !line.is_empty()).count(),
        _ => 0,
    };
    let piece = &lines[at - above..=at + below];
    Some(piece.iter().map(|line| line.get(indent..).unwrap_or_default()).collect::<Vec<_>>().join("\n"))
}

fn indent(line: &str) -> usize {
    line.len() - line.trim_start().len()
}

#[cfg(test)]
mod tests {
    use super::of;

    #[test]
    fn a_piece_has_its_comments_and_its_end() {
        let text = "use a;\n\n/// Rules.\n#[derive(Debug)]\npub enum Rule {\n    /// One.\n    One { a: f64 },\n}\n\nconst N: usize = 3;\n";
        let rule = "/// Rules.\n#[derive(Debug)]\npub enum Rule {\n    /// One.\n    One { a: f64 },\n}";
        assert_eq!(of(text, "enum Rule").as_deref(), Some(rule));
        assert_eq!(of(text, "One {").as_deref(), Some("/// One.\nOne { a: f64 },"));
        assert_eq!(of(text, "const N").as_deref(), Some("const N: usize = 3;"));
        assert_eq!(of(text, "fn missing"), None);
    }

    #[test]
    fn a_table_is_found_by_its_head_and_ends_at_an_empty_line() {
        let text = "[[case]]\nname = \"a\"\nset = []\n\n[[case]]\nname = \"b\"\n";
        assert_eq!(of(text, "[[case]]").as_deref(), Some("[[case]]\nname = \"a\"\nset = []"));
        assert_eq!(of(text, "name = \"b\"").as_deref(), Some("[[case]]\nname = \"b\""));
    }
}
