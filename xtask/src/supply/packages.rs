//! The packages of others that ours need, as cargo knows them.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

use serde_json::Value;

use crate::packages::{cargo, printed};

/// A package of others.
#[derive(Debug, Default, Clone)]
pub(super) struct Package {
    pub(super) name: String,
    pub(super) version: String,
    /// Where it comes from, as the lock file names it.
    pub(super) source: String,
    /// Its licence expression.
    pub(super) licence: Option<String>,
    pub(super) repository: Option<String>,
    /// The folder of its source here.
    pub(super) folder: PathBuf,
}

/// All packages of others, by name and version; or those alone that one of ours has in it on one system.
pub(super) fn packages(root: &Path, shipped: Option<(&str, &str)>) -> Result<Vec<Package>, String> {
    let mut command = cargo(root);
    command.args(["metadata", "--format-version", "1", "--locked"]);
    if let Some((_, target)) = shipped {
        command.args(["--filter-platform", target]);
    }
    let metadata: Value = serde_json::from_str(&printed(&mut command)?).map_err(|error| format!("cargo metadata: {error}"))?;
    let shipped = shipped.map(|(package, _)| within(&metadata, package));
    let wanted = |package: &&Value| {
        let id = package["id"].as_str().unwrap_or("");
        package["source"].is_string() && shipped.as_ref().is_none_or(|shipped| shipped.contains(id))
    };
    let mut packages: Vec<Package> = list(&metadata["packages"]).iter().filter(wanted).map(package).collect();
    packages.sort_by(|a, b| (&a.name, &a.version).cmp(&(&b.name, &b.version)));
    if packages.is_empty() {
        return Err("cargo metadata names no packages".into());
    }
    Ok(packages)
}

fn list(value: &Value) -> &[Value] {
    value.as_array().map_or(&[], Vec::as_slice)
}

fn package(value: &Value) -> Package {
    let text = |key: &str| value[key].as_str().map(String::from);
    let manifest = PathBuf::from(text("manifest_path").unwrap_or_default());
    Package {
        name: text("name").unwrap_or_default(),
        version: text("version").unwrap_or_default(),
        source: text("source").unwrap_or_default(),
        licence: text("license"),
        repository: text("repository"),
        folder: manifest.parent().map(Path::to_path_buf).unwrap_or_default(),
    }
}

/// Identities of what is linked into a package of ours: its dependencies, theirs, and so on, but not those of tests and builds.
fn within(metadata: &Value, name: &str) -> BTreeSet<String> {
    let nodes: BTreeMap<&str, &Value> =
        list(&metadata["resolve"]["nodes"]).iter().filter_map(|node| Some((node["id"].as_str()?, node))).collect();
    let named = list(&metadata["packages"]).iter().filter(|package| package["name"] == name && package["source"].is_null());
    let mut open: Vec<&str> = named.filter_map(|package| package["id"].as_str()).collect();
    let mut found = BTreeSet::new();
    while let Some(id) = open.pop() {
        if found.insert(id.to_string())
            && let Some(node) = nodes.get(id)
        {
            let linked = |dependency: &&Value| list(&dependency["dep_kinds"]).iter().any(|kind| kind["kind"].is_null());
            open.extend(list(&node["deps"]).iter().filter(linked).filter_map(|dependency| dependency["pkg"].as_str()));
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_linked_is_found_through_others_and_without_tests_and_builds() {
        let dependency = |id: &str, kind: Option<&str>| serde_json::json!({ "pkg": id, "dep_kinds": [{ "kind": kind }] });
        let metadata = serde_json::json!({
            "packages": [{ "id": "ours", "name": "cli", "source": null }],
            "resolve": { "nodes": [
                { "id": "ours", "deps": [dependency("a", None), dependency("test", Some("dev")), dependency("b", Some("build"))] },
                { "id": "a", "deps": [dependency("deep", None), dependency("ours", Some("dev"))] },
                { "id": "deep", "deps": [] },
            ] },
        });
        let found: Vec<String> = within(&metadata, "cli").into_iter().collect();
        assert_eq!(found, ["a", "deep", "ours"]);
    }
}
