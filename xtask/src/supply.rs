//! `cargo xtask supply`: what the program is made of: every package from the one registry, under a licence of the list in `deny.toml`; the notices and
//! the list of components of what is shipped.

mod licence;
mod notices;
mod packages;

use std::path::Path;
use std::process::ExitCode;

use packages::{Package, packages};

pub(crate) use notices::{notices_of, write};

/// The registry of all packages, as the lock file names it.
const REGISTRY: &str = "registry+https://github.com/rust-lang/crates.io-index";

/// Checks sources and licences of all dependencies, those for tests and for other systems too.
pub(crate) fn run(root: &Path) -> ExitCode {
    let checked = allowed(root).and_then(|allowed| Ok((packages(root, None)?, allowed)));
    let (packages, findings) = match checked {
        Ok((packages, allowed)) => {
            let findings: Vec<String> = packages.iter().flat_map(|package| findings(package, &allowed)).collect();
            (packages, findings)
        }
        Err(message) => {
            eprintln!("supply: {message}");
            return ExitCode::from(2);
        }
    };
    if findings.is_empty() {
        println!("supply: {} packages of others, all from the registry, all under allowed licences", packages.len());
        return ExitCode::SUCCESS;
    }
    findings.iter().for_each(|finding| eprintln!("{finding}"));
    eprintln!("\nsupply: {} finding(s); leave the package out, or allow its licence in deny.toml", findings.len());
    ExitCode::FAILURE
}

/// The licences that `deny.toml` allows.
fn allowed(root: &Path) -> Result<Vec<String>, String> {
    let path = root.join("deny.toml");
    let text = std::fs::read_to_string(&path).map_err(|error| format!("deny.toml: {error}"))?;
    let table: toml::Table = text.parse().map_err(|error| format!("deny.toml: {error}"))?;
    let list = table.get("licenses").and_then(|licences| licences.get("allow")).and_then(toml::Value::as_array);
    let list = list.ok_or("deny.toml has no licenses.allow")?;
    Ok(list.iter().filter_map(toml::Value::as_str).map(String::from).collect())
}

/// What is wrong with a package.
fn findings(package: &Package, allowed: &[String]) -> Vec<String> {
    let shown = format!("{} {}", package.name, package.version);
    let mut findings = Vec::new();
    if package.source != REGISTRY {
        findings.push(format!("{shown}: comes from {}, not from the registry", package.source));
    }
    match &package.licence {
        None => findings.push(format!("{shown}: names no licence")),
        Some(licence) => match licence::permits(licence, &|name| allowed.iter().any(|other| other == name)) {
            Ok(true) => {}
            Ok(false) => findings.push(format!("{shown}: {licence} is not allowed")),
            Err(message) => findings.push(format!("{shown}: cannot read the licence `{licence}`: {message}")),
        },
    }
    findings
}

#[cfg(test)]
mod tests {
    use super::*;

    fn package(source: &str, licence: Option<&str>) -> Package {
        let (name, version) = ("a".to_string(), "1.0.0".to_string());
        Package { name, version, source: source.into(), licence: licence.map(String::from), ..Package::default() }
    }

    #[test]
    fn another_source_or_licence_is_found() {
        let allowed = ["MIT".to_string()];
        assert!(findings(&package(REGISTRY, Some("MIT OR GPL-3.0-only")), &allowed).is_empty());
        for (source, licence, words) in [
            (REGISTRY, Some("GPL-3.0-only"), "is not allowed"),
            (REGISTRY, Some("MIT AND GPL-3.0-only"), "is not allowed"),
            (REGISTRY, Some("MIT OR"), "cannot read"),
            (REGISTRY, None, "no licence"),
            ("git+https://example.org/a", Some("MIT"), "comes from git+"),
            ("registry+https://example.org/index", Some("MIT"), "comes from registry+"),
        ] {
            let findings = findings(&package(source, licence), &allowed);
            assert!(findings.len() == 1 && findings[0].contains(words), "{findings:?}");
        }
    }
}
