//! Rust source with comments, string contents and test items blanked out, so that a search for a
//! word finds code only. Lines keep their numbers.

/// `text` with comments, the contents of string and character literals, and everything under
/// `#[cfg(test)]` replaced by spaces.
pub(super) fn strip(text: &str) -> String {
    let without_words = blank_comments_and_strings(text);
    blank_test_items(&without_words)
}

/// Names of the modules declared as `#[cfg(test)] mod name;`, whose code stands in another file.
pub(super) fn test_modules(text: &str) -> Vec<String> {
    let text = blank_comments_and_strings(text);
    let mut names = Vec::new();
    for (at, _) in text.match_indices("#[cfg(test)]") {
        let item = text[at + "#[cfg(test)]".len()..].trim_start();
        if let Some(rest) = item.strip_prefix("mod ")
            && let Some((name, _)) = rest.split_once(';')
            && name.chars().all(|c| c.is_alphanumeric() || c == '_')
        {
            names.push(name.to_string());
        }
    }
    names
}

fn blank_comments_and_strings(text: &str) -> String {
    let chars: Vec<char> = text.chars().collect();
    let mut out: Vec<char> = Vec::with_capacity(chars.len());
    let mut at = 0;
    while at < chars.len() {
        let end = match (chars[at], chars.get(at + 1)) {
            ('/', Some('/')) => line_end(&chars, at),
            ('/', Some('*')) => block_comment_end(&chars, at),
            ('"', _) => string_end(&chars, at),
            ('r', Some('"' | '#')) if !in_word(&chars, at) => raw_string_end(&chars, at),
            ('\'', _) => char_literal_end(&chars, at),
            _ => at,
        };
        if end == at {
            out.push(chars[at]);
            at += 1;
        } else {
            out.extend(chars[at..end].iter().map(|&c| if c == '\n' { '\n' } else { ' ' }));
            at = end;
        }
    }
    out.into_iter().collect()
}

fn in_word(chars: &[char], at: usize) -> bool {
    at > 0 && (chars[at - 1].is_alphanumeric() || chars[at - 1] == '_') && chars[at - 1] != 'b'
}

fn line_end(chars: &[char], at: usize) -> usize {
    chars[at..].iter().position(|&c| c == '\n').map_or(chars.len(), |length| at + length)
}

/// End of a block comment; they nest.
fn block_comment_end(chars: &[char], at: usize) -> usize {
    let (mut depth, mut here) = (0, at);
    while here < chars.len() {
        match (chars[here], chars.get(here + 1)) {
            ('/', Some('*')) => (depth, here) = (depth + 1, here + 2),
            ('*', Some('/')) => (depth, here) = (depth - 1, here + 2),
            _ => here += 1,
        }
        if depth == 0 {
            return here;
        }
    }
    chars.len()
}

fn string_end(chars: &[char], at: usize) -> usize {
    let mut here = at + 1;
    while here < chars.len() {
        match chars[here] {
            '\\' => here += 2,
            '"' => return here + 1,
            _ => here += 1,
        }
    }
    chars.len()
}

/// End of `r#".."#`, or `at` when it is no raw string (a raw identifier, say).
fn raw_string_end(chars: &[char], at: usize) -> usize {
    let hashes = chars[at + 1..].iter().take_while(|&&c| c == '#').count();
    if chars.get(at + 1 + hashes) != Some(&'"') {
        return at;
    }
    let mut here = at + 2 + hashes;
    while here < chars.len() {
        if chars[here] == '"' && chars[here + 1..].iter().take_while(|&&c| c == '#').count() >= hashes {
            return here + 1 + hashes;
        }
        here += 1;
    }
    chars.len()
}

/// End of a character literal, or `at` for a lifetime.
fn char_literal_end(chars: &[char], at: usize) -> usize {
    match (chars.get(at + 1), chars.get(at + 2)) {
        (Some('\\'), Some(_)) => chars[at + 3..].iter().position(|&c| c == '\'').map_or(at, |length| at + 3 + length + 1),
        (Some(_), Some('\'')) => at + 3,
        _ => at,
    }
}

fn blank_test_items(text: &str) -> String {
    let mut bytes = text.as_bytes().to_vec();
    let mut from = 0;
    while let Some(found) = text[from..].find("#[cfg(test)]") {
        let start = from + found;
        let end = item_end(text, start + "#[cfg(test)]".len());
        for byte in &mut bytes[start..end] {
            if *byte != b'\n' {
                *byte = b' ';
            }
        }
        from = end;
    }
    String::from_utf8_lossy(&bytes).into_owned()
}

/// End of the item that begins at `from`: its closing brace, or its semicolon.
fn item_end(text: &str, from: usize) -> usize {
    let mut depth = 0_i32;
    for (at, c) in text[from..].char_indices() {
        match c {
            '{' | '(' | '[' => depth += 1,
            '}' | ')' | ']' => {
                depth -= 1;
                if depth == 0 && c == '}' {
                    return from + at + 1;
                }
            }
            ';' if depth == 0 => return from + at + 1,
            _ => {}
        }
    }
    text.len()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn comments_and_strings_are_blank_and_lines_stay() {
        let text = "// a.unwrap()\nlet x = \"panic!(\\\"\"; /* y\n /* z */ */ let c = '\"'; f.go();\nlet r = r#\"a \" b\"#;";
        let code = strip(text);
        assert_eq!(code.lines().count(), text.lines().count());
        assert!(!code.contains("unwrap") && !code.contains("panic") && !code.contains('z'));
        assert!(code.contains("f.go();") && code.contains("let r ="));
        assert!(!code.contains(" b"));
    }

    #[test]
    fn lifetimes_are_no_character_literals() {
        let code = strip("fn f<'a>(x: &'a str) -> &'a str { x.unwrap() }");
        assert!(code.contains("x.unwrap()"));
    }

    #[test]
    fn test_items_are_blank_and_what_follows_is_not() {
        let code = strip("#[cfg(test)]\nmod tests { fn a() { b.unwrap() } }\nfn c() { d.unwrap() }\n");
        assert!(!code.contains("b.unwrap()") && code.contains("d.unwrap()"));
        let code = strip("#[cfg(test)]\nuse x::Y;\nfn c() { d.unwrap() }\n");
        assert!(!code.contains("x::Y") && code.contains("d.unwrap()"));
    }

    #[test]
    fn test_modules_in_other_files_are_named() {
        assert_eq!(test_modules("#[cfg(test)]\nmod tests;\n#[cfg(test)]\nmod inline {}\n"), ["tests"]);
    }
}
