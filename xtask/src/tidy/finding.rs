//! A file that is checked, and what is found in it.

use std::fmt;

/// One broken rule at one place.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Finding {
    /// Path from the root of the workspace, with `/` on every system.
    pub(super) file: String,
    /// Line, counted from 1.
    pub(super) line: usize,
    /// What is wrong.
    pub(super) problem: String,
    /// What to do instead.
    pub(super) remedy: String,
}

impl fmt::Display for Finding {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:{}: {}\n    remedy: {}", self.file, self.line, self.problem, self.remedy)
    }
}

/// A text file of the workspace.
pub(super) struct TextFile {
    /// Path from the root of the workspace, with `/` on every system.
    pub(super) path: String,
    /// Its content.
    pub(super) text: String,
}

#[cfg(test)]
pub(super) fn file(path: &str, text: &str) -> TextFile {
    TextFile { path: path.into(), text: text.into() }
}
