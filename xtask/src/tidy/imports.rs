//! The import table: which crate may build on which.
//!
//! ```text
//!  hpfem, contact, wear, shapeopt          (hpfem -> contact, and both with wear -> shapeopt)
//!         |
//!  scene ---> meshing ---> wearshape ---> report ---> cli          crates/python, crates/web -> wearshape (+ report)
//!
//!  tests -> cli, report, wearshape, scene     xtask -> (starts programs; links none of our crates)
//! ```
//!
//! The row of a package that is not there yet waits for it.

use super::finding::{Finding, TextFile};
use super::strip::strip;

/// What one package may import.
struct Row {
    package: &'static str,
    /// Crates of this workspace.
    ours: &'static [&'static str],
    /// Crates of others; `None`: any.
    others: Option<&'static [&'static str]>,
    because: &'static str,
}

const TABLE: &[Row] = &[
    Row {
        package: "crates/hpfem",
        ours: &[],
        others: Some(&["nalgebra", "faer", "pulp", "rayon", "thiserror", "base64", "serde"]),
        because: "hpfem offers elements and bodies and knows nothing of contact, wear or files",
    },
    Row {
        package: "crates/contact",
        ours: &["hpfem"],
        others: Some(&["nalgebra", "faer", "thiserror"]),
        because: "contact knows nothing of wear, time or files",
    },
    Row {
        package: "crates/wear",
        ours: &[],
        others: Some(&["nalgebra", "thiserror"]),
        because: "a wear rule must be testable with three numbers, without finite elements or contact",
    },
    Row {
        package: "crates/shapeopt",
        ours: &["hpfem", "contact", "wear"],
        others: Some(&["nalgebra", "faer", "thiserror"]),
        because: "shapeopt knows nothing of files or scenes",
    },
    Row {
        package: "crates/scene",
        ours: &[],
        others: Some(&["serde", "toml", "strsim", "sha2", "schemars", "thiserror"]),
        because: "scene is the file language: what may be written and where it stands, without numerics",
    },
    Row {
        package: "crates/meshing",
        ours: &["scene", "hpfem"],
        others: Some(&["nalgebra", "thiserror"]),
        because: "meshing makes two meshes of a geometry and knows nothing of contact, wear or the solution",
    },
    Row {
        package: "crates/wearshape",
        ours: &["scene", "meshing", "hpfem", "contact", "wear", "shapeopt"],
        others: Some(&["csv", "serde", "serde_json", "nalgebra"]),
        because: "wearshape is the library: from a document to a solution, for any program",
    },
    Row {
        package: "crates/report",
        ours: &["wearshape", "scene", "hpfem"],
        others: Some(&["serde", "serde_json", "csv"]),
        because: "report writes what the solution says; what it needs of a mesh or a law, the solution carries; of hpfem it takes the file format",
    },
    Row {
        package: "crates/cli",
        ours: &["scene", "meshing", "wearshape", "report", "hpfem", "contact", "wear", "shapeopt"],
        others: None,
        because: "cli is the top of the workspace",
    },
    Row {
        package: "crates/python",
        ours: &["wearshape", "report", "scene", "hpfem", "wear"],
        others: Some(&["one-build", "pyo3", "rayon", "serde_json"]),
        because: "python hands on what the library computes, and computes nothing of its own",
    },
    Row {
        package: "crates/web",
        ours: &["wearshape", "report", "scene"],
        others: Some(&["gemm", "serde_json"]),
        because: "web hands on what the library computes to a page, and computes nothing of its own",
    },
    Row {
        package: "tests/wasm",
        ours: &["hpfem"],
        others: Some(&[]),
        because: "the module shows that hpfem alone runs in a browser",
    },
    Row {
        package: "tests/fuzz",
        ours: &["hpfem", "scene", "wearshape", "cli"],
        others: Some(&["mcap"]),
        because: "inputs are given to what reads them: the libraries, or the program where a recording is read",
    },
    Row {
        package: "tests",
        ours: &["wearshape", "scene", "report", "cli"],
        others: None,
        because: "the cases run what a user runs: `cli::run`, or the library as another program would",
    },
    Row {
        package: "xtask",
        ours: &[],
        others: Some(&["serde_json", "toml", "wait4", "syn", "proc-macro2"]),
        because: "xtask must build when our crates are broken",
    },
    Row {
        package: "xtask/one-build",
        ours: &[],
        others: Some(&["bitflags", "libc", "once_cell", "proc-macro2", "syn2", "syn3"]),
        because: "one-build names features of what others bring in, and has no code",
    },
];

/// Allowed in `[dev-dependencies]` of every package; `rayon` for tests that choose the number of threads.
const FOR_TESTS: &[&str] = &["approx", "proptest", "insta", "temp-dir", "serde_json", "toml", "divan", "rayon"];

/// Packages with lints of their own, and why.
const OWN_LINTS: &[(&str, &str)] = &[
    ("tests/wasm", "a function that others call by name counts as unsafe code, which the workspace's table forbids"),
    ("crates/web", "a function that others call by name counts as unsafe code, which the workspace's table forbids"),
];

const OURS: &[&str] = &["hpfem", "contact", "wear", "shapeopt", "scene", "meshing", "wearshape", "report", "cli", "xtask"];

/// Findings in manifests and `use` lines.
pub(super) fn check(files: &[TextFile]) -> Vec<Finding> {
    let mut findings = Vec::new();
    for file in files {
        if let Some(folder) = file.path.strip_suffix("/Cargo.toml") {
            match TABLE.iter().find(|row| row.package == folder) {
                Some(row) => manifest(file, row, &mut findings),
                None if is_own_workspace(&file.text) => {}
                None => findings.push(Finding {
                    file: file.path.clone(),
                    line: 1,
                    problem: format!("package `{folder}` has no row in the import table"),
                    remedy: "add a row to TABLE in xtask/src/tidy/imports.rs, with its reason".into(),
                }),
            }
        } else if file.path.ends_with(".rs")
            && let Some(row) = TABLE.iter().find(|row| file.path.starts_with(&format!("{}/", row.package)))
        {
            use_lines(file, row, &mut findings);
        }
    }
    findings
}

fn manifest(file: &TextFile, row: &Row, findings: &mut Vec<Finding>) {
    let mut report = |needle: &str, problem: String, remedy: String| {
        findings.push(Finding { file: file.path.clone(), line: line_of(&file.text, needle), problem, remedy });
    };
    let parsed: toml::Table = match file.text.parse() {
        Ok(parsed) => parsed,
        Err(error) => {
            return report("", format!("not valid TOML: {error}"), "mend the manifest".into());
        }
    };
    let own_lints = OWN_LINTS.iter().any(|(package, _)| *package == row.package);
    if !own_lints && parsed.get("lints").and_then(|lints| lints.get("workspace")).and_then(toml::Value::as_bool) != Some(true) {
        report("[lints]", "does not take the workspace's lint table".into(), "add `[lints] workspace = true`".into());
    }
    for section in ["dependencies", "dev-dependencies", "build-dependencies"] {
        let Some(table) = parsed.get(section).and_then(toml::Value::as_table) else {
            continue;
        };
        for (name, value) in table {
            if !may_import(row, name, section == "dev-dependencies") {
                report(
                    name,
                    format!("`{}` may not depend on `{name}`", row.package),
                    format!("{}; move the code up, or pass numbers in", row.because),
                );
            }
            if value.get("workspace").and_then(toml::Value::as_bool) != Some(true) || value.get("features").is_some() {
                report(
                    name,
                    format!("`{name}` states its own version or features"),
                    format!("write `{name}.workspace = true`; version and features stand in the root Cargo.toml"),
                );
            }
        }
    }
}

/// A package with a `[workspace]` of its own (a fuzz target) is not part of ours.
fn is_own_workspace(text: &str) -> bool {
    text.parse::<toml::Table>().is_ok_and(|manifest| manifest.contains_key("workspace"))
}

fn may_import(row: &Row, name: &str, for_tests: bool) -> bool {
    if OURS.contains(&name) {
        return row.ours.contains(&name);
    }
    (for_tests && FOR_TESTS.contains(&name)) || row.others.is_none_or(|others| others.contains(&name))
}

/// `use contact::..` in a crate below `contact`. The compiler would say so too, but not why.
fn use_lines(file: &TextFile, row: &Row, findings: &mut Vec<Finding>) {
    let code = strip(&file.text);
    for (number, line) in code.lines().enumerate() {
        let Some(name) = used_crate(line) else {
            continue;
        };
        // A module of that name stands before a crate of that name.
        let own = row.package.rsplit('/').next() == Some(name) || code.contains(&format!("mod {name};"));
        if OURS.contains(&name) && !own && !row.ours.contains(&name) {
            findings.push(Finding {
                file: file.path.clone(),
                line: number + 1,
                problem: format!("`{}` may not use `{name}`", row.package),
                remedy: row.because.into(),
            });
        }
    }
}

/// First segment of the path of a `use` line: `hpfem` for `pub use hpfem::Body;`.
fn used_crate(line: &str) -> Option<&str> {
    let line = line.trim_start();
    let line = match line.strip_prefix("pub") {
        Some(rest) if rest.starts_with('(') => rest.split_once(')')?.1.trim_start(),
        Some(rest) if rest.starts_with(' ') => rest.trim_start(),
        _ => line,
    };
    let path = line.strip_prefix("use ").or_else(|| line.strip_prefix("extern crate "))?.trim_start();
    let path = path.strip_prefix("::").unwrap_or(path);
    let end = path.find(|c: char| !c.is_alphanumeric() && c != '_').unwrap_or(path.len());
    Some(&path[..end])
}

/// Line of the first `name` that begins a line, or 1.
fn line_of(text: &str, name: &str) -> usize {
    text.lines().position(|line| line.trim_start().starts_with(name)).map_or(1, |at| at + 1)
}

#[cfg(test)]
mod tests {
    use super::super::finding::file;
    use super::*;

    const LINTS: &str = "[lints]\nworkspace = true\n";

    #[test]
    fn wear_may_not_depend_on_hpfem() {
        let text = format!("{LINTS}[dependencies]\nnalgebra.workspace = true\nhpfem.workspace = true\n");
        let findings = check(&[file("crates/wear/Cargo.toml", &text)]);
        assert_eq!(findings.len(), 1);
        assert_eq!((findings[0].line, findings[0].file.as_str()), (5, "crates/wear/Cargo.toml"));
        assert!(findings[0].problem.contains("`crates/wear` may not depend on `hpfem`"));
    }

    #[test]
    fn test_dependencies_are_layered_too() {
        let text = format!("{LINTS}[dev-dependencies]\napprox.workspace = true\nshapeopt.workspace = true\n");
        let findings = check(&[file("crates/contact/Cargo.toml", &text)]);
        assert_eq!(findings.len(), 1);
        assert!(findings[0].problem.contains("shapeopt"));
    }

    #[test]
    fn own_version_and_missing_lints_are_found() {
        let findings = check(&[file("crates/hpfem/Cargo.toml", "[dependencies]\nfaer = \"0.24\"\n")]);
        assert_eq!(findings.len(), 2);
    }

    #[test]
    fn a_package_without_a_row_is_found() {
        assert_eq!(check(&[file("crates/extra/Cargo.toml", LINTS)]).len(), 1);
        assert!(check(&[file("crates/hpfem/fuzz/Cargo.toml", "[workspace]\n")]).is_empty());
    }

    #[test]
    fn use_of_a_higher_crate_is_found_with_its_line() {
        let text = "//! use contact::Pair;\nuse nalgebra::Vector2;\npub(crate) use contact::Pair;\n";
        let findings = check(&[file("crates/hpfem/src/body.rs", text)]);
        assert_eq!(findings.len(), 1);
        assert_eq!(findings[0].line, 3);
    }

    #[test]
    fn a_module_of_the_same_name_is_no_import() {
        let text = "use crate::contact::Pair;\nuse self::wear::Law;\nmod contact;\n";
        assert!(check(&[file("crates/hpfem/src/body.rs", text)]).is_empty());
        assert!(check(&[file("crates/wear/src/lib.rs", "mod report;\npub use report::Report;\n")]).is_empty());
        assert_eq!(check(&[file("crates/wear/src/lib.rs", "pub use report::Report;\n")]).len(), 1);
    }

    #[test]
    fn the_library_knows_nothing_of_what_is_built_on_it() {
        let text = format!("{LINTS}[dependencies]\nscene.workspace = true\nmeshing.workspace = true\nreport.workspace = true\n");
        let findings = check(&[file("crates/wearshape/Cargo.toml", &text)]);
        assert_eq!(findings.len(), 1);
        assert!(findings[0].problem.contains("`crates/wearshape` may not depend on `report`"));
        let text = format!("{LINTS}[dependencies]\nscene.workspace = true\nclap.workspace = true\n");
        assert_eq!(check(&[file("crates/report/Cargo.toml", &text)]).len(), 1);
        assert!(check(&[file("crates/cli/Cargo.toml", &text)]).is_empty());
    }
}
