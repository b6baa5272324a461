//! What one module says of others: its `use` lines and the paths in its code, without its tests.

use proc_macro2::{TokenStream, TokenTree};
use syn::visit::{self, Visit};

use super::parsed::{attributes, is_test};

/// A name brought in by a `use`.
pub(super) struct Import {
    /// The name in this module; `*` for all names of `path`.
    pub(super) name: String,
    /// The path it stands for; the first segment of `::a::b` is empty.
    pub(super) path: Vec<String>,
    /// Whether others may import it from here: `pub use`, `pub(crate) use`.
    pub(super) passed_on: bool,
    /// Line, counted from 1.
    pub(super) line: usize,
}

/// How a path stands in the code.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Form {
    /// As a type, a value or a pattern.
    Plain,
    /// As a function: `path(..)`.
    Called,
    /// As a macro: `path!(..)`.
    Macro,
}

/// A path in the code.
pub(super) struct Mention {
    /// Its segments.
    pub(super) path: Vec<String>,
    /// How it stands there.
    pub(super) form: Form,
    /// Line, counted from 1.
    pub(super) line: usize,
}

/// The names of one module.
#[derive(Default)]
pub(super) struct Names {
    /// Modules declared here whose code stands in another file.
    pub(super) files: Vec<String>,
    /// Modules written out here.
    pub(super) inline: Vec<(String, Names)>,
    /// Items defined here.
    pub(super) defined: Vec<String>,
    /// Its `use` lines, one entry a name.
    pub(super) imports: Vec<Import>,
    /// Paths in its code.
    pub(super) mentions: Vec<Mention>,
    /// `static` items: name, the words of its type, line.
    pub(super) statics: Vec<(String, Vec<String>, usize)>,
}

/// The names of a file.
pub(super) fn names(tree: &syn::File) -> Names {
    let mut names = Names::default();
    names.visit_file(tree);
    names
}

impl Names {
    fn uses(&mut self, tree: &syn::UseTree, before: &[String], passed_on: bool) {
        let mut leaf = |name: &syn::Ident, known_as: &syn::Ident| {
            let mut path = before.to_vec();
            if name != "self" {
                path.push(name.to_string());
            }
            let local = if known_as == "self" { path.last().cloned().unwrap_or_default() } else { known_as.to_string() };
            self.imports.push(Import { name: local, path, passed_on, line: name.span().start().line });
        };
        match tree {
            syn::UseTree::Name(found) => leaf(&found.ident, &found.ident),
            syn::UseTree::Rename(found) => leaf(&found.ident, &found.rename),
            syn::UseTree::Glob(found) => {
                let line = found.star_token.spans[0].start().line;
                self.imports.push(Import { name: "*".into(), path: before.to_vec(), passed_on, line });
            }
            syn::UseTree::Path(found) => {
                let before = [before, &[found.ident.to_string()]].concat();
                self.uses(&found.tree, &before, passed_on);
            }
            syn::UseTree::Group(found) => found.items.iter().for_each(|tree| self.uses(tree, before, passed_on)),
        }
    }

    fn mention(&mut self, path: &syn::Path, form: Form) {
        let Some(first) = path.segments.first() else {
            return;
        };
        let mut words: Vec<String> = path.segments.iter().map(|segment| segment.ident.to_string()).collect();
        if path.leading_colon.is_some() {
            words.insert(0, String::new());
        }
        self.mentions.push(Mention { path: words, form, line: first.ident.span().start().line });
    }

    /// Paths in the tokens of a macro, which are no syntax tree.
    fn tokens(&mut self, tokens: TokenStream) {
        let tokens: Vec<TokenTree> = tokens.into_iter().collect();
        let mut at = 0;
        while at < tokens.len() {
            match &tokens[at] {
                TokenTree::Group(group) => self.tokens(group.stream()),
                TokenTree::Ident(first) if !follows_dot(&tokens, at) => {
                    let mut path = vec![first.to_string()];
                    while let Some(TokenTree::Ident(next)) = tokens.get(at + 3)
                        && is_punct(tokens.get(at + 1), ':')
                        && is_punct(tokens.get(at + 2), ':')
                    {
                        path.push(next.to_string());
                        at += 3;
                    }
                    let form = match tokens.get(at + 1) {
                        Some(TokenTree::Group(group)) if group.delimiter() == proc_macro2::Delimiter::Parenthesis => Form::Called,
                        next if is_punct(next, '!') => Form::Macro,
                        _ => Form::Plain,
                    };
                    self.mentions.push(Mention { path, form, line: first.span().start().line });
                }
                // `deserialize_with = "crate::read::number"` names a path as well.
                TokenTree::Literal(literal) => self.path_in_string(literal),
                _ => {}
            }
            at += 1;
        }
    }

    fn path_in_string(&mut self, literal: &proc_macro2::Literal) {
        let text = literal.to_string();
        let inside = text.trim_matches('"');
        if inside.contains("::")
            && let Ok(path) = syn::parse_str::<syn::Path>(inside)
        {
            let words = path.segments.iter().map(|segment| segment.ident.to_string()).collect();
            self.mentions.push(Mention { path: words, form: Form::Called, line: literal.span().start().line });
        }
    }
}

fn is_punct(token: Option<&TokenTree>, wanted: char) -> bool {
    matches!(token, Some(TokenTree::Punct(punct)) if punct.as_char() == wanted)
}

/// Whether the word at `at` is a field or method: one dot before it. After two, as in `0..end`, it is not.
fn follows_dot(tokens: &[TokenTree], at: usize) -> bool {
    let dot = |back: usize| at >= back && is_punct(tokens.get(at - back), '.');
    dot(1) && !dot(2)
}

/// The name an item gives to its module.
fn defines(item: &syn::Item) -> Option<&syn::Ident> {
    use syn::Item;
    match item {
        Item::Const(item) => Some(&item.ident),
        Item::Enum(item) => Some(&item.ident),
        Item::Fn(item) => Some(&item.sig.ident),
        Item::Macro(item) => item.ident.as_ref(),
        Item::Static(item) => Some(&item.ident),
        Item::Struct(item) => Some(&item.ident),
        Item::Trait(item) => Some(&item.ident),
        Item::Type(item) => Some(&item.ident),
        _ => None,
    }
}

impl<'ast> Visit<'ast> for Names {
    fn visit_item(&mut self, item: &'ast syn::Item) {
        if is_test(attributes(item)) {
            return;
        }
        self.defined.extend(defines(item).map(ToString::to_string));
        visit::visit_item(self, item);
    }

    fn visit_impl_item_fn(&mut self, item: &'ast syn::ImplItemFn) {
        if !is_test(&item.attrs) {
            visit::visit_impl_item_fn(self, item);
        }
    }

    fn visit_item_mod(&mut self, item: &'ast syn::ItemMod) {
        let name = item.ident.to_string();
        match &item.content {
            None => self.files.push(name),
            Some((_, items)) => {
                let mut inside = Names::default();
                items.iter().for_each(|item| inside.visit_item(item));
                self.inline.push((name, inside));
            }
        }
    }

    fn visit_item_use(&mut self, item: &'ast syn::ItemUse) {
        let before: &[String] = if item.leading_colon.is_some() { &[String::new()] } else { &[] };
        self.uses(&item.tree, before, !matches!(item.vis, syn::Visibility::Inherited));
    }

    fn visit_item_static(&mut self, item: &'ast syn::ItemStatic) {
        let mut inside = Names::default();
        inside.visit_type(&item.ty);
        let words = inside.mentions.iter().flat_map(|mention| mention.path.clone()).collect();
        self.statics.push((item.ident.to_string(), words, item.ident.span().start().line));
        visit::visit_item_static(self, item);
    }

    fn visit_expr_call(&mut self, call: &'ast syn::ExprCall) {
        if let syn::Expr::Path(function) = &*call.func {
            self.mention(&function.path, Form::Called);
        }
        visit::visit_expr_call(self, call);
    }

    fn visit_macro(&mut self, found: &'ast syn::Macro) {
        self.mention(&found.path, Form::Macro);
        self.tokens(found.tokens.clone());
    }

    fn visit_attribute(&mut self, attribute: &'ast syn::Attribute) {
        if let syn::Meta::List(list) = &attribute.meta {
            self.tokens(list.tokens.clone());
        }
    }

    /// `pub(in crate::steps)` says who may look, not what is used.
    fn visit_visibility(&mut self, _: &'ast syn::Visibility) {}

    fn visit_path(&mut self, path: &'ast syn::Path) {
        self.mention(path, Form::Plain);
        visit::visit_path(self, path);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(text: &str) -> Names {
        names(&syn::parse_file(text).expect("Rust"))
    }

    fn imports(text: &str) -> Vec<(String, String)> {
        of(text).imports.into_iter().map(|import| (import.name, import.path.join("::"))).collect()
    }

    fn mentions(text: &str) -> Vec<String> {
        of(text).mentions.into_iter().map(|mention| mention.path.join("::")).collect()
    }

    #[test]
    fn groups_are_taken_apart() {
        let found = imports("use crate::a::{self, b::{C, D as E}, f::*};\nuse ::z::Y;\n");
        let expected =
            [("a", "crate::a"), ("C", "crate::a::b::C"), ("E", "crate::a::b::D"), ("*", "crate::a::f"), ("Y", "::z::Y")];
        assert_eq!(found, expected.map(|(name, path)| (name.to_string(), path.to_string())));
    }

    #[test]
    fn paths_of_types_calls_and_macros_are_found() {
        let found = mentions("fn f(x: &a::B) -> Vec<c::D> { e::f(matches!(x, g::H { .. } | self.i)) }\n");
        for path in ["a::B", "c::D", "e::f", "g::H"] {
            assert!(found.iter().any(|word| word == path), "{path} in {found:?}");
        }
        assert!(!found.contains(&"i".to_string()));
    }

    #[test]
    fn tests_comments_and_visibility_name_nothing() {
        let text = "// a::b()\npub(in crate::a) struct S;\n#[cfg(test)]\nmod tests { use super::*; fn f() { a::b(); } }\n";
        assert!(mentions(text).is_empty() && imports(text).is_empty());
    }

    #[test]
    fn a_path_in_an_attribute_counts() {
        let text = "struct S {\n    #[serde(with = \"crate::read::number\")]\n    x: f64,\n}\n";
        assert!(mentions(text).contains(&"crate::read::number".to_string()));
    }
}
