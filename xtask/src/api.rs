//! What each library offers, by name: `docs/api/<crate>.txt`, one name a line. A change of these lists is a change that users see.
//!
//! Names are those that `lib.rs` hands on, with the public fields, variants and methods of types of the crate itself.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;
use syn::{Fields, ImplItem, Item, TraitItem, Type, UseTree, Visibility};

/// Compares the list of a library with what it offers, or writes it.
pub(crate) fn listed(root: &Path, folder: &str, write: bool) -> Result<usize, String> {
    let names = offered(&sources(&root.join("crates").join(folder).join("src"))?);
    let text: String = names.iter().map(|name| format!("{name}\n")).collect();
    let place = format!("docs/api/{folder}.txt");
    let path = root.join(&place);
    if write {
        let made = fs::create_dir_all(root.join("docs/api")).and_then(|()| fs::write(&path, text));
        made.map_err(|error| format!("{place}: {error}"))?;
        return Ok(names.len());
    }
    let known = fs::read_to_string(&path).map_err(|error| format!("{place}: {error}"))?.replace('\r', "");
    if known == text {
        return Ok(names.len());
    }
    let known: BTreeSet<String> = known.lines().map(String::from).collect();
    let changes = names.difference(&known).map(|name| format!("+ {name}"));
    let changes: Vec<String> = changes.chain(known.difference(&names).map(|name| format!("- {name}"))).collect();
    Err(format!(
        "{folder} does not offer what {place} says:\n{}\n`cargo xtask crates --write` renews the list",
        changes.join("\n")
    ))
}

/// Syntax trees below a folder, `lib.rs` first.
fn sources(folder: &Path) -> Result<Vec<syn::File>, String> {
    let mut paths = Vec::new();
    let mut folders = vec![folder.to_path_buf()];
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(&folder).map_err(|error| format!("{}: {error}", folder.display()))?.filter_map(Result::ok) {
            let path = entry.path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|end| end == "rs") {
                paths.push(path);
            }
        }
    }
    let root = folder.join("lib.rs");
    paths.sort_by_key(|path| (*path != root, path.clone()));
    let parse = |path: &std::path::PathBuf| {
        let text = fs::read_to_string(path).map_err(|error| format!("{}: {error}", path.display()))?;
        syn::parse_file(&text).map_err(|error| format!("{}: {error}", path.display()))
    };
    paths.iter().map(parse).collect()
}

/// The names that the first file hands on, with the members of those that any file defines.
fn offered(files: &[syn::File]) -> BTreeSet<String> {
    let mut handed = Vec::new();
    let mut modules = BTreeSet::new();
    for item in files.first().into_iter().flat_map(|file| &file.items).filter(|item| !conditional(attributes(item))) {
        match item {
            Item::Use(item) if public(&item.vis) => leaves(&item.tree, &[], &mut handed),
            Item::Mod(item) => {
                modules.insert(item.ident.to_string());
                if public(&item.vis) {
                    handed.push((vec![item.ident.to_string()], item.ident.to_string()));
                }
            }
            item => {
                if let Some(name) = defined(item) {
                    handed.push((vec!["crate".into(), name.clone()], name));
                }
            }
        }
    }
    let mut names = BTreeSet::new();
    for (path, known_as) in handed {
        let own = path.first().is_some_and(|first| modules.contains(first) || first == "crate");
        if own && let Some(name) = path.last() {
            let found = files.iter().flat_map(|file| &file.items).flat_map(|item| members(item, name));
            names.extend(found.map(|member| format!("{known_as}::{member}")));
        }
        names.insert(known_as);
    }
    names
}

/// Path and name of everything that a `use` hands on; `path::*` for all names of a path.
fn leaves(tree: &UseTree, before: &[String], found: &mut Vec<(Vec<String>, String)>) {
    let path = |name: &syn::Ident| [before, &[name.to_string()]].concat();
    match tree {
        UseTree::Name(leaf) => found.push((path(&leaf.ident), leaf.ident.to_string())),
        UseTree::Rename(leaf) => found.push((path(&leaf.ident), leaf.rename.to_string())),
        UseTree::Glob(_) => found.push((before.to_vec(), format!("{}::*", before.join("::")))),
        UseTree::Path(branch) => leaves(&branch.tree, &path(&branch.ident), found),
        UseTree::Group(group) => group.items.iter().for_each(|tree| leaves(tree, before, found)),
    }
}

/// Public members that an item gives to the type `name`.
fn members(item: &Item, name: &str) -> Vec<String> {
    match item {
        Item::Struct(item) if item.ident == name => fields(&item.fields),
        Item::Enum(item) if item.ident == name => item.variants.iter().map(|variant| variant.ident.to_string()).collect(),
        Item::Trait(item) if item.ident == name => item
            .items
            .iter()
            .filter_map(|item| if let TraitItem::Fn(f) = item { Some(f.sig.ident.to_string()) } else { None })
            .collect(),
        Item::Impl(item) if item.trait_.is_none() && of_type(&item.self_ty, name) => item
            .items
            .iter()
            .filter_map(|item| match item {
                ImplItem::Fn(f) if public(&f.vis) && !conditional(&f.attrs) => Some(f.sig.ident.to_string()),
                ImplItem::Const(c) if public(&c.vis) => Some(c.ident.to_string()),
                _ => None,
            })
            .collect(),
        _ => Vec::new(),
    }
}

fn fields(fields: &Fields) -> Vec<String> {
    let names = fields.iter().enumerate().filter(|(_, field)| public(&field.vis));
    names.map(|(at, field)| field.ident.as_ref().map_or_else(|| at.to_string(), ToString::to_string)).collect()
}

fn of_type(of: &Type, name: &str) -> bool {
    matches!(of, Type::Path(path) if path.path.segments.last().is_some_and(|segment| segment.ident == name))
}

/// Name of a public item.
fn defined(item: &Item) -> Option<String> {
    let (vis, name) = match item {
        Item::Const(item) => (&item.vis, &item.ident),
        Item::Enum(item) => (&item.vis, &item.ident),
        Item::Fn(item) => (&item.vis, &item.sig.ident),
        Item::Struct(item) => (&item.vis, &item.ident),
        Item::Trait(item) => (&item.vis, &item.ident),
        Item::Type(item) => (&item.vis, &item.ident),
        _ => return None,
    };
    public(vis).then(|| name.to_string())
}

fn public(vis: &Visibility) -> bool {
    matches!(vis, Visibility::Public(_))
}

/// Whether an item is there for tests only.
fn conditional(attributes: &[syn::Attribute]) -> bool {
    attributes.iter().any(|attribute| {
        attribute.path().is_ident("cfg")
            && attribute.meta.require_list().is_ok_and(|list| list.tokens.to_string().contains("test"))
    })
}

fn attributes(item: &Item) -> &[syn::Attribute] {
    match item {
        Item::Use(item) => &item.attrs,
        Item::Mod(item) => &item.attrs,
        Item::Struct(item) => &item.attrs,
        Item::Fn(item) => &item.attrs,
        _ => &[],
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_those_that_users_see() {
        let root = "mod body; mod error; pub mod units { }\npub use faer;\npub use body::{Body, read as read_body};\npub use other::Thing;\n\
                    #[cfg(doctest)]\npub struct Readme;\npub const MOST: usize = 2;\n";
        let body = "pub struct Body { pub mesh: u8, inside: u8 }\nimpl Body { pub fn new() {} fn check() {} pub(crate) fn cut() {} }\n\
                    impl Clone for Body { fn clone(&self) {} }\npub fn read() {}\npub enum Thing { One }\n";
        let files = [root, body].map(|text| syn::parse_file(text).expect("Rust"));
        let names: Vec<String> = offered(&files).into_iter().collect();
        assert_eq!(names, ["Body", "Body::mesh", "Body::new", "MOST", "Thing", "faer", "read_body", "units"]);
    }
}
