//! The programs that make and check the book, in `target/tools`.

use std::path::{Path, PathBuf};
use std::process::Command;

use crate::packages::{cargo, done};

/// Where both are.
pub(super) struct Tools {
    pub mdbook: PathBuf,
    pub links: PathBuf,
}

/// Name, version and options of what makes the pages.
const MDBOOK: [&str; 2] = ["mdbook", "0.5.4"];
/// The same of what follows the links, without a network.
const LINKS: [&str; 2] = ["hyperlink", "0.3.2"];

/// Builds both unless they are there in these versions.
pub(super) fn installed(root: &Path) -> Result<Tools, String> {
    let mdbook = tool(root, MDBOOK, &["--no-default-features", "--features", "search"])?;
    let links = tool(root, LINKS, &[])?;
    Ok(Tools { mdbook, links })
}

fn tool(root: &Path, [name, version]: [&str; 2], options: &[&str]) -> Result<PathBuf, String> {
    let folder = root.join("target/tools");
    let program = folder.join("bin").join(name);
    if !is_there(&program, version) {
        println!("installing {name} {version} into target/tools");
        // Neither optimised nor to be debugged: it takes longer to compile them well than they run.
        let install = ["install", "--quiet", "--locked", "--debug", "--force", "--version", version, name, "--root"];
        let plain = [("CARGO_INCREMENTAL", "0"), ("CARGO_PROFILE_DEV_DEBUG", "0")];
        done(cargo(root).args(install).arg(&folder).args(options).envs(plain))?;
    }
    Ok(program)
}

fn is_there(program: &Path, version: &str) -> bool {
    let output = Command::new(program).arg("--version").output();
    output.is_ok_and(|output| String::from_utf8_lossy(&output.stdout).trim_end().ends_with(version))
}
