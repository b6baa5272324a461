//! The modules of one crate and what the paths in them stand for.
//!
//! A name passed on by `pub use` belongs to the module that defines it, so `use crate::steps::Answer` is an import of `steps::answer`
//! where `steps` says `pub(crate) use answer::Answer`.

use std::collections::BTreeMap;

use super::names::{Form, Import, Mention, Names, names};
use super::parsed::Parsed;

/// Longest chain of names passed on; a longer one is a circle of `use` lines.
const LONGEST_CHAIN: usize = 32;

/// The modules of a crate; the first is its root.
pub(super) struct Modules<'a> {
    modules: Vec<Module>,
    /// The files, each a node of the graph of imports.
    pub(super) files: Vec<&'a Parsed>,
}

struct Module {
    /// Position of its file in `files`; modules written out in a file share it.
    file: usize,
    parent: usize,
    children: BTreeMap<String, usize>,
    names: Names,
}

/// What a path stands for.
enum Meaning {
    /// An item defined in a module.
    Item(usize),
    /// A module itself.
    Module(usize),
}

/// Imports between the files of a crate: from, to (positions in `files`), and the first line that says so.
pub(super) type Edges = BTreeMap<(usize, usize), usize>;

impl<'a> Modules<'a> {
    /// The modules of a crate below its `lib.rs`, or `main.rs` where there is no library.
    pub(super) fn new(files: &[&'a Parsed]) -> Option<Self> {
        let root = ["lib.rs", "main.rs"].iter().find_map(|name| files.iter().find(|file| file.inner == *name))?;
        let mut all = Self { modules: Vec::new(), files: Vec::new() };
        all.add(root, "", 0, files);
        Some(all)
    }

    /// Adds a file and the files of its modules, which stand in `folder`.
    fn add(&mut self, file: &'a Parsed, folder: &str, parent: usize, files: &[&'a Parsed]) -> usize {
        self.files.push(file);
        self.add_names(names(&file.tree), folder, (self.files.len() - 1, parent), files)
    }

    fn add_names(&mut self, mut names: Names, folder: &str, (file, parent): (usize, usize), files: &[&'a Parsed]) -> usize {
        let inline = std::mem::take(&mut names.inline);
        let declared = names.files.clone();
        let this = self.modules.len();
        self.modules.push(Module { file, parent, children: BTreeMap::new(), names });
        for name in declared {
            let places = [format!("{folder}{name}.rs"), format!("{folder}{name}/mod.rs")];
            if let Some(found) = files.iter().find(|file| places.contains(&file.inner)) {
                let child = self.add(found, &format!("{folder}{name}/"), this, files);
                self.modules[this].children.insert(name, child);
            }
        }
        for (name, inside) in inline {
            let child = self.add_names(inside, &format!("{folder}{name}/"), (file, this), files);
            self.modules[this].children.insert(name, child);
        }
        this
    }

    /// Imports between files; the root is no module and has none.
    pub(super) fn edges(&self) -> Edges {
        let mut edges = Edges::new();
        for (at, module) in self.modules.iter().enumerate() {
            let mut edge = |to: usize, line: usize| {
                let to = self.modules[to].file;
                if to != module.file && to != 0 && module.file != 0 {
                    let first = edges.entry((module.file, to)).or_insert(line);
                    *first = line.min(*first);
                }
            };
            for import in &module.names.imports {
                if let Some(to) = self.import(at, import) {
                    edge(to, import.line);
                }
            }
            for mention in &module.names.mentions {
                if let Some(to) = self.mention(at, mention) {
                    edge(to, mention.line);
                }
            }
        }
        edges
    }

    /// The module that a `use` imports from. A module's own name is an alias: what is taken through it counts.
    fn import(&self, at: usize, import: &Import) -> Option<usize> {
        if import.name == "*" {
            let (Meaning::Item(to) | Meaning::Module(to)) = self.meaning(at, &import.path, 0)?;
            return (!(import.passed_on && self.is_below(to, at))).then_some(to);
        }
        match self.meaning(at, &import.path, 0)? {
            Meaning::Item(to) if import.passed_on && self.is_below(to, at) => None,
            Meaning::Item(to) => Some(to),
            Meaning::Module(_) => None,
        }
    }

    /// The module that a path in the code leads to.
    fn mention(&self, at: usize, mention: &Mention) -> Option<usize> {
        if let [word] = &mention.path[..] {
            // A lone word in small letters is a variable unless it is called.
            let variable = mention.form == Form::Plain && !word.starts_with(char::is_uppercase);
            let imported = self.modules[at].names.imports.iter().any(|import| import.name == *word);
            if variable || !imported || self.modules[at].names.defined.contains(word) {
                return None;
            }
        }
        match self.meaning(at, &mention.path, 0)? {
            Meaning::Item(to) => Some(to),
            Meaning::Module(_) => None,
        }
    }

    fn is_below(&self, module: usize, above: usize) -> bool {
        let mut here = module;
        while here != 0 {
            here = self.modules[here].parent;
            if here == above {
                return true;
            }
        }
        false
    }

    /// What `path` stands for in module `at`; `None` for other crates and for what macros make.
    fn meaning(&self, at: usize, path: &[String], depth: usize) -> Option<Meaning> {
        let (first, rest) = path.split_first()?;
        if depth > LONGEST_CHAIN {
            return None;
        }
        match first.as_str() {
            "crate" => self.within(0, rest, depth),
            "self" => self.within(at, rest, depth),
            "super" => self.above(self.modules[at].parent, rest, depth),
            _ => self.known(at, path, depth),
        }
    }

    fn above(&self, at: usize, path: &[String], depth: usize) -> Option<Meaning> {
        match path.split_first() {
            Some((first, rest)) if first == "super" => self.above(self.modules[at].parent, rest, depth),
            _ => self.within(at, path, depth),
        }
    }

    /// What `path` stands for below module `at`: an unknown name there is an item a macro made.
    fn within(&self, at: usize, path: &[String], depth: usize) -> Option<Meaning> {
        if path.is_empty() {
            return Some(Meaning::Module(at));
        }
        match self.known(at, path, depth) {
            Some(meaning) => Some(meaning),
            None if self.modules[at].names.imports.iter().any(|import| import.name == path[0]) => None,
            None => Some(Meaning::Item(at)),
        }
    }

    /// What a path stands for whose first segment is a name of module `at`. Before `::` stands a module or a type, so there a child comes
    /// before a function of its name.
    fn known(&self, at: usize, path: &[String], depth: usize) -> Option<Meaning> {
        let (first, rest) = path.split_first()?;
        let module = &self.modules[at];
        let child = module.children.get(first);
        if let (Some(&child), false) = (child, rest.is_empty()) {
            return self.within(child, rest, depth);
        }
        if module.names.defined.contains(first) {
            return Some(Meaning::Item(at));
        }
        for import in module.names.imports.iter().filter(|import| import.name == *first) {
            // `use spline::spline` names itself: the path is read from the module, where the child comes first.
            let longer = [&import.path[..], rest].concat();
            if longer != path
                && let Some(meaning) = self.meaning(at, &longer, depth + 1)
            {
                return Some(meaning);
            }
        }
        if let Some(&child) = child {
            return Some(Meaning::Module(child));
        }
        self.through_glob(at, path, depth)
    }

    /// A name brought in by `use path::*`.
    fn through_glob(&self, at: usize, path: &[String], depth: usize) -> Option<Meaning> {
        let globs = self.modules[at].names.imports.iter().filter(|import| import.name == "*");
        globs.filter(|_| depth < LONGEST_CHAIN).find_map(|import| match self.meaning(at, &import.path, depth + 1)? {
            Meaning::Module(to) if to != at => self.known(to, path, depth + 1),
            _ => None,
        })
    }
}

/// The name of a file's module: `steps::ends` for `steps/ends.rs`.
pub(super) fn module_name(file: &Parsed) -> String {
    let stem = file.inner.trim_end_matches(".rs").trim_end_matches("/mod");
    stem.replace('/', "::")
}

#[cfg(test)]
mod tests {
    use super::super::finding::file;
    use super::super::parsed::parse;
    use super::*;

    /// Imports of a crate as `from -> to: line`.
    fn edges(files: &[(&str, &str)]) -> Vec<String> {
        let files: Vec<_> = files.iter().map(|(path, text)| file(&format!("crates/cli/src/{path}"), text)).collect();
        let (parsed, findings) = parse(&files);
        assert!(findings.is_empty());
        let modules = Modules::new(&parsed.iter().collect::<Vec<_>>()).expect("a root");
        let name = |at: usize| module_name(modules.files[at]);
        modules.edges().iter().map(|((from, to), line)| format!("{} -> {}: {line}", name(*from), name(*to))).collect()
    }

    #[test]
    fn use_lines_and_paths_are_imports() {
        let found = edges(&[
            ("lib.rs", "mod a;\nmod b;\nmod c;\n"),
            ("a.rs", "use crate::b::{self, B};\nfn f() { super::c::g(); }\n"),
            ("b.rs", "pub(crate) struct B;\n"),
            ("c.rs", "fn h() -> crate::b::B { crate::b::B }\n"),
        ]);
        assert_eq!(found, ["a -> b: 1", "a -> c: 2", "c -> b: 1"]);
    }

    #[test]
    fn a_name_passed_on_belongs_to_where_it_is_defined() {
        let found = edges(&[
            ("lib.rs", "mod steps;\nmod run;\nmod scene;\npub use scene::Scene;\n"),
            ("steps.rs", "mod contact;\npub(crate) use contact::Foo;\npub(crate) struct Own;\n"),
            ("steps/contact.rs", "pub(crate) struct Foo;\nfn f(_: super::Own) {}\n"),
            ("run.rs", "use crate::steps::Foo;\nuse crate::Scene;\n"),
            ("scene.rs", "pub struct Scene;\n"),
        ]);
        assert_eq!(found, ["steps::contact -> steps: 2", "run -> steps::contact: 1", "run -> scene: 2"]);
    }

    #[test]
    fn passing_on_is_no_import_and_using_is() {
        let lib = ("lib.rs", "mod steps;\n");
        let child = ("steps/contact.rs", "pub(super) struct Foo;\npub(super) fn solve() {}\n");
        assert!(edges(&[lib, ("steps.rs", "mod contact;\npub(crate) use contact::Foo;\n"), child]).is_empty());
        for text in [
            "mod contact;\nuse contact::Foo;\n",
            "mod contact;\nfn f() { contact::solve() }\n",
            "pub(crate) use contact::solve; mod contact;\nfn f() { solve() }\n",
        ] {
            assert_eq!(edges(&[lib, ("steps.rs", text), child]).len(), 1, "{text}");
        }
        let variable = "mod contact;\npub(crate) use contact::solve;\nfn f(solve: f64) -> f64 { solve }\n";
        assert!(edges(&[lib, ("steps.rs", variable), child]).is_empty());
    }

    #[test]
    fn an_alias_of_a_module_counts_where_it_is_used() {
        let found = edges(&[
            ("lib.rs", "mod steps;\nmod run;\n"),
            ("steps.rs", "pub(crate) mod forecast;\npub(crate) use forecast::forecast;\n"),
            ("steps/forecast.rs", "pub(crate) fn forecast() {}\n"),
            ("run.rs", "use crate::steps;\n\nfn f() { steps::forecast() }\n"),
        ]);
        assert_eq!(found, ["run -> steps::forecast: 3"]);
    }

    #[test]
    fn a_module_written_out_counts_for_its_file() {
        let found = edges(&[
            ("lib.rs", "mod a;\nmod b;\n"),
            ("a.rs", "mod inner { use super::super::b::B; use super::A; }\nstruct A;\n"),
            ("b.rs", "pub(crate) struct B;\n"),
        ]);
        assert_eq!(found, ["a -> b: 1"]);
    }

    #[test]
    fn tests_and_other_crates_are_no_imports() {
        let found = edges(&[
            ("lib.rs", "mod contact;\nmod b;\n"),
            ("b.rs", "use hpfem::contact::Pair;\n#[cfg(test)]\nuse crate::contact::Own;\n"),
            ("contact.rs", "struct Own;\nuse ::contact::Foo;\nuse std::fmt;\n"),
        ]);
        assert!(found.is_empty(), "{found:?}");
    }
}
