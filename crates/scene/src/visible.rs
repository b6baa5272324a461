//! Texts from others on the way to a terminal, a picture or a page: nothing in them acts.

use std::borrow::Cow;

/// Most characters of a word and of a whole message that are shown, and how many of them stand in front of what is left out.
const WORD: [usize; 2] = [300, 220];
const MESSAGE: [usize; 2] = [2000, 1500];

/// Whether a character acts instead of being seen: controls but for the end of a line and the tab, the marks that turn the direction of
/// writing, and the two that no XML may hold.
pub fn acts(c: char) -> bool {
    let turns = matches!(c, '\u{200e}' | '\u{200f}' | '\u{2028}'..='\u{202e}' | '\u{2066}'..='\u{2069}');
    turns || matches!(c, '\u{fffe}' | '\u{ffff}') || (c.is_control() && c != '\n' && c != '\t')
}

/// The text with every character that acts written as what it is: `\u{1b}`.
pub fn visible(text: &str) -> Cow<'_, str> {
    if !text.contains(acts) {
        return Cow::Borrowed(text);
    }
    Cow::Owned(text.chars().fold(String::with_capacity(text.len() + 16), |mut out, c| {
        if acts(c) {
            out.extend(c.escape_unicode())
        } else {
            out.push(c)
        }
        out
    }))
}

/// A message of bounded length: of a very long word, and of a very long message, begin and end are kept.
pub fn bounded(text: &str) -> Cow<'_, str> {
    if text.len() <= WORD[0] {
        return Cow::Borrowed(text);
    }
    let words: String = text.split_inclusive(char::is_whitespace).map(|word| ends(word, WORD)).collect();
    Cow::Owned(ends(&words, MESSAGE).into_owned())
}

/// The first and the last characters of a text with more than so many.
fn ends(text: &str, [most, first]: [usize; 2]) -> Cow<'_, str> {
    if text.chars().nth(most).is_none() {
        return Cow::Borrowed(text);
    }
    let head = text.char_indices().nth(first).map_or(text.len(), |(at, _)| at);
    let tail = text.char_indices().rev().nth(most - first - 2).map_or(text.len(), |(at, _)| at);
    Cow::Owned(format!("{}\u{2026}{}", &text[..head], &text[tail..]))
}

#[cfg(test)]
mod tests {
    use super::{bounded, visible};

    #[test]
    fn characters_that_act_are_written_as_what_they_are() {
        assert_eq!(visible("a\u{1b}]0;x\u{7}\u{9b}\r\u{202e}b"), "a\\u{1b}]0;x\\u{7}\\u{9b}\\u{d}\\u{202e}b");
        assert_eq!(visible("\u{b5}m\tand\n\u{5f62}"), "\u{b5}m\tand\n\u{5f62}");
    }

    #[test]
    fn long_words_and_long_messages_keep_their_ends() {
        let word = bounded(&format!("unknown key `{}`; remove it", "k".repeat(1 << 20))).into_owned();
        assert!(word.starts_with("unknown key `kkk") && word.ends_with("k`; remove it") && word.chars().count() < 340, "{word}");
        let list = bounded(&format!("known here: {}end", "name, ".repeat(100_000))).into_owned();
        assert!(list.ends_with("name, end") && list.chars().count() <= 2000, "{list}");
        assert_eq!(bounded("short"), "short");
    }
}
