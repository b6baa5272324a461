//! Long functions and long lists of arguments, with the places of today.

use syn::spanned::Spanned;
use syn::visit::{self, Visit};

use super::finding::Finding;
use super::parsed::{Parsed, attributes, is_test};

/// Longest function, in lines from `fn` to its closing brace.
const LONGEST: usize = 60;

/// Most arguments of a function, `self` not counted.
const MOST_ARGUMENTS: usize = 5;

/// A function outside tests.
pub(super) struct Function {
    /// Its place without a line: `hpfem/space.rs: Space::new`.
    pub(super) place: String,
    /// Path of its file.
    pub(super) file: String,
    /// Line of its `fn`.
    pub(super) line: usize,
    /// Lines from its `fn` to its closing brace; 0 without a body.
    pub(super) lines: usize,
    /// Arguments without `self`.
    pub(super) arguments: usize,
}

/// A limit, and the places beyond it today.
struct Limit<'a> {
    most: usize,
    of: fn(&Function) -> usize,
    what: &'static str,
    remedy: &'static str,
    known: &'a [&'a str],
    list: &'static str,
}

/// Findings in all files; `long` and `wide` are the places of today.
pub(super) fn check(files: &[Parsed], long: &[&str], wide: &[&str]) -> Vec<Finding> {
    let functions = functions(files);
    let lines = Limit {
        most: LONGEST,
        of: |function| function.lines,
        what: "lines",
        remedy: "each step one named call: split it",
        known: long,
        list: "LONG_FUNCTIONS",
    };
    let arguments = Limit {
        most: MOST_ARGUMENTS,
        of: |function| function.arguments,
        what: "arguments",
        remedy: "put those that go together into a struct",
        known: wide,
        list: "WIDE_SIGNATURES",
    };
    let mut findings = beyond(&functions, &lines);
    findings.extend(beyond(&functions, &arguments));
    findings
}

fn beyond(functions: &[Function], limit: &Limit<'_>) -> Vec<Finding> {
    let over = |function: &&Function| (limit.of)(function) > limit.most;
    let unlisted = functions.iter().filter(over).filter(|function| !limit.known.contains(&function.place.as_str()));
    let mut findings: Vec<Finding> = unlisted
        .map(|function| Finding {
            file: function.file.clone(),
            line: function.line,
            problem: format!("`{}` has {} {}, more than {}", function.place, (limit.of)(function), limit.what, limit.most),
            remedy: limit.remedy.into(),
        })
        .collect();
    let stale = limit.known.iter().filter(|place| !functions.iter().filter(over).any(|function| function.place == **place));
    findings.extend(stale.map(|place| Finding {
        file: "xtask/src/tidy/today.rs".into(),
        line: 1,
        problem: format!("{} lists `{place}`, which has no more than {} {}", limit.list, limit.most, limit.what),
        remedy: "take it off the list".into(),
    }));
    findings
}

/// Functions longer than the limit, the longest first.
pub(super) fn long(files: &[Parsed]) -> Vec<Function> {
    let mut found: Vec<Function> = functions(files).into_iter().filter(|function| function.lines > LONGEST).collect();
    found.sort_by_key(|function| std::cmp::Reverse(function.lines));
    found
}

/// Functions of more arguments than the limit, most first.
pub(super) fn wide(files: &[Parsed]) -> Vec<Function> {
    let mut found: Vec<Function> = functions(files).into_iter().filter(|function| function.arguments > MOST_ARGUMENTS).collect();
    found.sort_by_key(|function| std::cmp::Reverse(function.arguments));
    found
}

fn functions(files: &[Parsed]) -> Vec<Function> {
    let mut all = Vec::new();
    for file in files {
        let mut search = Search { file, owner: String::new(), found: Vec::new() };
        search.visit_file(&file.tree);
        all.append(&mut search.found);
    }
    all
}

struct Search<'a> {
    file: &'a Parsed,
    /// `Type::` within an `impl` or a trait.
    owner: String,
    found: Vec<Function>,
}

impl Search<'_> {
    fn function(&mut self, signature: &syn::Signature, body: Option<&syn::Block>) {
        let line = signature.fn_token.span.start().line;
        self.found.push(Function {
            place: format!("{}/{}: {}{}", self.file.krate, self.file.inner, self.owner, signature.ident),
            file: self.file.path.clone(),
            line,
            lines: body.map_or(0, |body| body.span().end().line - line + 1),
            arguments: signature.inputs.iter().filter(|argument| matches!(argument, syn::FnArg::Typed(_))).count(),
        });
    }

    fn within(&mut self, owner: String, visit: impl FnOnce(&mut Self)) {
        let outer = std::mem::replace(&mut self.owner, owner);
        visit(self);
        self.owner = outer;
    }
}

impl<'ast> Visit<'ast> for Search<'_> {
    fn visit_item(&mut self, item: &'ast syn::Item) {
        if !is_test(attributes(item)) {
            visit::visit_item(self, item);
        }
    }

    fn visit_item_fn(&mut self, item: &'ast syn::ItemFn) {
        self.function(&item.sig, Some(&item.block));
        self.within(String::new(), |search| visit::visit_item_fn(search, item));
    }

    fn visit_item_impl(&mut self, item: &'ast syn::ItemImpl) {
        let owner = match &*item.self_ty {
            syn::Type::Path(path) => path.path.segments.last().map(|segment| format!("{}::", segment.ident)),
            _ => None,
        };
        self.within(owner.unwrap_or_default(), |search| visit::visit_item_impl(search, item));
    }

    fn visit_item_trait(&mut self, item: &'ast syn::ItemTrait) {
        self.within(format!("{}::", item.ident), |search| visit::visit_item_trait(search, item));
    }

    fn visit_impl_item_fn(&mut self, item: &'ast syn::ImplItemFn) {
        if !is_test(&item.attrs) {
            self.function(&item.sig, Some(&item.block));
            visit::visit_impl_item_fn(self, item);
        }
    }

    fn visit_trait_item_fn(&mut self, item: &'ast syn::TraitItemFn) {
        self.function(&item.sig, item.default.as_ref());
        visit::visit_trait_item_fn(self, item);
    }
}

#[cfg(test)]
mod tests {
    use super::super::finding::file;
    use super::super::parsed::parse;
    use super::*;

    fn parsed(text: &str) -> Vec<Parsed> {
        parse(&[file("crates/wear/src/law.rs", text)]).0
    }

    /// A function of so many lines.
    fn lines(name: &str, count: usize) -> String {
        format!("#[inline]\npub fn {name}() {{\n{}}}\n", "    step();\n".repeat(count - 2))
    }

    #[test]
    fn a_long_function_is_found_at_its_fn() {
        let text = format!("{}{}#[cfg(test)]\nmod tests {{ {} }}\n", lines("a", 60), lines("b", 61), lines("c", 90));
        let findings = check(&parsed(&text), &[], &[]);
        assert_eq!(findings.len(), 1);
        assert_eq!((findings[0].line, findings[0].problem.contains("`wear/law.rs: b` has 61 lines")), (63, true));
    }

    #[test]
    fn methods_of_traits_count_and_closures_do_not() {
        let text = format!("impl Iterator for Law {{ {} }}\nfn f() {{ let g = |a, b, c, d, e, f| a; }}\n", lines("next", 70));
        let findings = check(&parsed(&text), &[], &[]);
        assert_eq!(findings.len(), 1);
        assert!(findings[0].problem.contains("`wear/law.rs: Law::next`"));
    }

    #[test]
    fn self_is_no_argument() {
        let text = "impl Law {\n    fn a(&self, a: f64, b: f64, c: f64, d: f64, e: f64) {}\n    fn b(a: f64, b: f64, c: f64, d: f64, e: f64, f: f64) {}\n}\n";
        let findings = check(&parsed(text), &[], &[]);
        assert_eq!(findings.len(), 1);
        assert_eq!((findings[0].line, findings[0].problem.contains("`wear/law.rs: Law::b` has 6 arguments")), (3, true));
    }

    #[test]
    fn known_places_pass_and_mended_ones_leave_the_list() {
        let files = parsed(&lines("b", 61));
        assert!(check(&files, &["wear/law.rs: b"], &[]).is_empty());
        let findings = check(&files, &["wear/law.rs: b", "wear/law.rs: gone"], &["wear/law.rs: b"]);
        assert_eq!(findings.len(), 2);
        assert!(findings.iter().all(|finding| finding.remedy == "take it off the list"));
    }
}
