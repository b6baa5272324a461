//! The sources of the workspace as syntax trees, parsed once for all rules that need more than a search for words.

use syn::spanned::Spanned;

use super::finding::{Finding, TextFile};
use super::source::test_files;

/// One source file below a `src` folder, without the files that hold tests.
pub(super) struct Parsed {
    /// Path from the root of the workspace, with `/` on every system.
    pub(super) path: String,
    /// Folder of its crate under `crates/`, or `xtask`.
    pub(super) krate: String,
    /// Path below the `src` folder.
    pub(super) inner: String,
    /// Lines of the file.
    pub(super) lines: usize,
    /// Its items.
    pub(super) tree: syn::File,
}

/// All sources of `crates/*/src` and `xtask/src`; a finding for each that is no Rust.
pub(super) fn parse(files: &[TextFile]) -> (Vec<Parsed>, Vec<Finding>) {
    let in_tests = test_files(files);
    let (mut parsed, mut findings) = (Vec::new(), Vec::new());
    for file in files.iter().filter(|file| !in_tests.contains(&file.path)) {
        let Some((krate, inner)) = place(&file.path) else {
            continue;
        };
        let (krate, inner) = (krate.to_string(), inner.to_string());
        match syn::parse_file(&file.text) {
            Ok(tree) => parsed.push(Parsed { path: file.path.clone(), krate, inner, lines: file.text.lines().count(), tree }),
            Err(error) => findings.push(Finding {
                file: file.path.clone(),
                line: error.span().start().line,
                problem: format!("is no Rust: {error}"),
                remedy: "mend it; `cargo check` says more".into(),
            }),
        }
    }
    (parsed, findings)
}

/// Crate and path below its `src`: `wearshape` and `steps/ends.rs` for `crates/wearshape/src/steps/ends.rs`.
fn place(path: &str) -> Option<(&str, &str)> {
    let path = path.strip_suffix(".rs").map(|_| path)?;
    match path.strip_prefix("crates/") {
        Some(rest) => {
            let (krate, rest) = rest.split_once('/')?;
            Some((krate, rest.strip_prefix("src/")?))
        }
        None => Some(("xtask", path.strip_prefix("xtask/src/")?)),
    }
}

/// Whether an item is compiled for tests only: `#[cfg(test)]`, `#[cfg(all(test, ..))]`.
pub(super) fn is_test(attributes: &[syn::Attribute]) -> bool {
    attributes.iter().any(|attribute| {
        attribute.path().is_ident("cfg")
            && attribute.meta.require_list().is_ok_and(|list| {
                let condition: String = list.tokens.to_string().split_whitespace().collect();
                condition == "test" || condition.starts_with("all(test,")
            })
    })
}

/// Attributes of an item.
pub(super) fn attributes(item: &syn::Item) -> &[syn::Attribute] {
    use syn::Item;
    match item {
        Item::Const(item) => &item.attrs,
        Item::Enum(item) => &item.attrs,
        Item::Fn(item) => &item.attrs,
        Item::Impl(item) => &item.attrs,
        Item::Macro(item) => &item.attrs,
        Item::Mod(item) => &item.attrs,
        Item::Static(item) => &item.attrs,
        Item::Struct(item) => &item.attrs,
        Item::Trait(item) => &item.attrs,
        Item::Type(item) => &item.attrs,
        Item::Use(item) => &item.attrs,
        _ => &[],
    }
}

/// Lines of a file that run outside tests: all but its items under `#[cfg(test)]`.
pub(super) fn production_lines(file: &Parsed) -> usize {
    let tests = file.tree.items.iter().filter(|item| is_test(attributes(item)));
    let in_tests: usize = tests.map(|item| item.span().end().line - item.span().start().line + 1).sum();
    file.lines - in_tests
}

#[cfg(test)]
mod tests {
    use super::super::finding::file;
    use super::*;

    #[test]
    fn only_sources_are_parsed_and_broken_ones_are_found() {
        let files = [
            file("crates/wearshape/src/steps/ends.rs", "mod a;\n"),
            file("crates/cli/src/record.rs", "#[cfg(test)]\nmod tests;\n"),
            file("crates/cli/src/record/tests.rs", "fn a() {}\n"),
            file("crates/cli/tests/it/main.rs", "fn a() {}\n"),
            file("xtask/src/main.rs", "fn main() {}\n"),
            file("crates/cli/src/broken.rs", "\nfn main( {}\n"),
        ];
        let (parsed, findings) = parse(&files);
        let places: Vec<_> = parsed.iter().map(|file| (file.krate.as_str(), file.inner.as_str())).collect();
        assert_eq!(places, [("wearshape", "steps/ends.rs"), ("cli", "record.rs"), ("xtask", "main.rs")]);
        assert_eq!(findings.iter().map(|f| (f.file.as_str(), f.line)).collect::<Vec<_>>(), [("crates/cli/src/broken.rs", 2)]);
    }

    #[test]
    fn lines_of_tests_are_not_counted() {
        let text = "fn a() {}\n\n#[cfg(test)]\nmod tests {\n    fn b() {}\n}\n";
        let (parsed, _) = parse(&[file("crates/wear/src/law.rs", text)]);
        assert_eq!(production_lines(&parsed[0]), 2);
    }
}
