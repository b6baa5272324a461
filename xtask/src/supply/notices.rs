//! What goes along with the shipped program: the licences of all that is in it, and the list of its components (CycloneDX 1.5).

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use serde_json::{Value, json};

use crate::supply::packages::{Package, packages};

/// Beginnings of the names of files with licences, in capitals.
const NAMES: [&str; 5] = ["LICENSE", "LICENCE", "COPYING", "NOTICE", "UNLICENSE"];

/// Writes both files into a folder and returns how many packages of others the program has in it on that system.
pub(crate) fn write(root: &Path, target: &str, folder: &Path) -> Result<usize, String> {
    let packages = packages(root, Some(("cli", target)))?;
    let components = serde_json::to_string_pretty(&components(&packages)).map_err(|error| error.to_string())?;
    for (name, text) in [("THIRD-PARTY.txt", notices(&packages)), ("wearshape.cdx.json", components + "\n")] {
        fs::write(folder.join(name), text).map_err(|error| format!("cannot write {name}: {error}"))?;
    }
    Ok(packages.len())
}

/// The licences of the packages of others that are in one of ours on a system.
pub(crate) fn notices_of(root: &Path, package: &str, target: &str) -> Result<String, String> {
    packages(root, Some((package, target))).map(|packages| notices(&packages))
}

/// The packages with their licences, then each text once, with the packages that it stands in.
fn notices(packages: &[Package]) -> String {
    let mut out = String::from("wearshape has these packages of others in it.\n\n");
    let mut texts: BTreeMap<String, Vec<String>> = BTreeMap::new();
    for package in packages {
        let shown = format!("{} {}", package.name, package.version);
        let licence = package.licence.as_deref().unwrap_or("see its text");
        let files = files(&package.folder, 2);
        let bare = if files.is_empty() { " (no text in its source)" } else { "" };
        out += &format!("{shown}: {licence}{bare}\n");
        if let Some(repository) = &package.repository {
            out += &format!("  {repository}\n");
        }
        for text in files.iter().filter_map(|path| fs::read_to_string(path).ok()) {
            let of = texts.entry(text.replace("\r\n", "\n").trim().to_string()).or_default();
            if !of.contains(&shown) {
                of.push(shown.clone());
            }
        }
    }
    for (text, of) in texts {
        out += &format!("\n{}\n{}\n\n{text}\n", "-".repeat(80), of.join(", "));
    }
    out
}

/// Files with licences in a folder, also in folders in it: sources of others are kept there.
fn files(folder: &Path, depth: usize) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).into_iter().flatten().filter_map(Result::ok).map(|entry| entry.path());
    let mut found = Vec::new();
    for path in entries {
        let name = path.file_name().unwrap_or_default().to_string_lossy().to_uppercase();
        if path.is_dir() {
            found.extend(if depth > 1 { files(&path, depth - 1) } else { Vec::new() });
        } else if NAMES.iter().any(|begin| name.starts_with(begin)) {
            found.push(path);
        }
    }
    found.sort();
    found
}

fn components(packages: &[Package]) -> Value {
    let component = |package: &Package| {
        let licence = package.licence.as_deref().unwrap_or("NOASSERTION");
        // The old sign for OR is none of the standard.
        let expression = licence.split('/').map(str::trim).collect::<Vec<_>>().join(" OR ");
        json!({
            "type": "library",
            "name": package.name,
            "version": package.version,
            "purl": format!("pkg:cargo/{}@{}", package.name, package.version),
            "licenses": [{ "expression": expression }],
        })
    };
    json!({
        "bomFormat": "CycloneDX",
        "specVersion": "1.5",
        "version": 1,
        "metadata": { "component": { "type": "application", "name": "wearshape", "version": env!("CARGO_PKG_VERSION") } },
        "components": packages.iter().map(component).collect::<Vec<_>>(),
    })
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    #[test]
    fn each_text_stands_once_with_all_its_packages_and_one_without_text_is_named() {
        let root = std::env::temp_dir().join(format!("wearshape-notices-{}", std::process::id()));
        let package = |name: &str, text: Option<&str>| {
            let folder = root.join(name);
            fs::create_dir_all(folder.join("inner")).unwrap();
            if let Some(text) = text {
                fs::write(folder.join("inner/LICENSE-MIT"), text).unwrap();
            }
            Package { name: name.into(), version: "1.0.0".into(), licence: Some("MIT/Zlib".into()), folder, ..Package::default() }
        };
        let packages = [package("a", Some("Words\r\n")), package("b", Some("Words")), package("c", None)];
        let text = notices(&packages);
        fs::remove_dir_all(&root).unwrap();
        assert_eq!(text.matches("Words").count(), 1, "{text}");
        assert!(
            text.contains("a 1.0.0, b 1.0.0\n\nWords") && text.contains("c 1.0.0: MIT/Zlib (no text in its source)"),
            "{text}"
        );
        let listed = components(&packages);
        assert_eq!(listed["components"][2]["purl"], "pkg:cargo/c@1.0.0");
        assert_eq!(listed["components"][2]["licenses"][0]["expression"], "MIT OR Zlib");
    }
}
