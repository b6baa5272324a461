//! What is wrong with the input, where it stands, and what to do about it.

use std::fmt;
use std::ops::Range;

use crate::numbers::with_short_numbers;

/// One error of the user's side: a sentence, its place and the remedy.
#[derive(Debug, Clone, PartialEq)]
pub struct Fault {
    /// Kind of error in one hyphenated word, for programs.
    pub code: &'static str,
    /// What is wrong, with the numbers in it.
    pub message: String,
    /// Dotted key of the scene that is to blame, from which the place is found.
    pub key: Option<String>,
    /// Where it stands: known at once for what cannot be read, else found from the key by `Document::locate`.
    pub place: Option<Place>,
    /// What to write instead.
    pub remedy: String,
}

/// Where the wrong input was written.
#[derive(Debug, Clone, PartialEq)]
pub enum Place {
    /// In a scene file.
    File(Box<Spot>),
    /// On the command line, as of `--set`; the flag as given.
    Flag(String),
}

/// A place in a text file, with the line itself for the picture.
#[derive(Debug, Clone, PartialEq)]
pub struct Spot {
    /// Name of the file as the user knows it.
    pub file: String,
    /// Line number from 1.
    pub line: usize,
    /// Column from 1, in characters.
    pub column: usize,
    /// Number of characters to underline.
    pub length: usize,
    /// The line.
    pub text: String,
}

impl Place {
    /// The place of a byte range in a file.
    pub fn file(file: &str, text: &str, span: Range<usize>) -> Place {
        Place::File(Box::new(Spot::new(file, text, span)))
    }
}

impl Spot {
    /// The place of a byte range in a text.
    fn new(file: &str, text: &str, span: Range<usize>) -> Self {
        let start = floor_boundary(text, span.start);
        let before = &text[..start];
        let line = before.matches('\n').count() + 1;
        let line_start = before.rfind('\n').map_or(0, |at| at + 1);
        let line_text = text[line_start..].lines().next().unwrap_or("");
        let column = text[line_start..start].chars().count() + 1;
        let end = floor_boundary(text, span.end).max(start);
        let on_line = text[start..end].lines().next().unwrap_or("");
        Spot { file: file.to_string(), line, column, length: on_line.chars().count().max(1), text: line_text.to_string() }
    }
}

fn floor_boundary(text: &str, at: usize) -> usize {
    let mut at = at.min(text.len());
    while !text.is_char_boundary(at) {
        at -= 1;
    }
    at
}

impl Fault {
    /// A fault of the whole input: no key, no place.
    pub fn new(code: &'static str, message: impl Into<String>, remedy: impl Into<String>) -> Self {
        Fault { code, message: with_short_numbers(&in_words(message.into())), key: None, place: None, remedy: remedy.into() }
    }

    /// A fault of one dotted key of the scene.
    pub fn at(key: impl Into<String>, code: &'static str, message: impl Into<String>, remedy: impl Into<String>) -> Self {
        Fault { key: Some(key.into()), ..Fault::new(code, message, remedy) }
    }
}

/// Names that a mesh gives its own boundaries, which no scene has, in words.
fn in_words(mut message: String) -> String {
    for (name, words) in [("@contact", "the contact edge"), ("@load", "the loaded edge"), ("@axis", "the axis")] {
        if message.contains(name) && !message.contains("begins with @") {
            // Among what is known to the user there is nothing to be told of them.
            for form in [format!(", {name}"), format!("boundary \"{name}\""), format!("\"{name}\""), name.to_string()] {
                message = message.replace(&form, if form.starts_with(',') { "" } else { words });
            }
        }
    }
    message
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message)
    }
}

impl std::error::Error for Fault {}

/// The nearest of some known words, when it is near enough to be meant.
fn nearest<'a>(word: &str, known: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let word = word.to_lowercase();
    let near = |candidate: &str| {
        let edits = strsim::osa_distance(&word, candidate);
        let alike = strsim::jaro_winkler(&word, candidate);
        (alike > 0.78 || edits <= (word.chars().count() / 3).max(1)).then_some((edits, alike))
    };
    known
        .into_iter()
        .filter_map(|candidate| near(candidate).map(|score| (score, candidate)))
        .min_by(|a, b| a.0.0.cmp(&b.0.0).then(b.0.1.total_cmp(&a.0.1)))
        .map(|(_, candidate)| candidate)
}

/// "did you mean `x`?", or the list of what is known.
pub fn did_you_mean(word: &str, known: &[&str]) -> String {
    match nearest(word, known.iter().copied()) {
        Some(near) => format!("did you mean `{near}`? known here: {}", known.join(", ")),
        None if known.is_empty() => "nothing is expected here: remove it".to_string(),
        None => format!("known here: {}", known.join(", ")),
    }
}
