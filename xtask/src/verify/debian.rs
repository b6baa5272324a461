//! The independent solver: packages of Debian 12.

use super::programs::{self, PYTHON};
use std::path::Path;
use std::process::Command;

const PACKAGES: [&str; 3] = ["python3-dolfinx-real", "python3-gmsh", "libopenblas0-pthread"];

/// Installs the packages with apt-get, as root or through sudo; nothing to do when all are there.
pub(crate) fn install() -> Result<(), String> {
    install_packages(&PACKAGES)
}

/// The same for any packages.
pub(crate) fn install_packages(packages: &[&str]) -> Result<(), String> {
    if packages.iter().all(|package| is_installed(package)) {
        println!("{} are installed", packages.join(", "));
        return Ok(());
    }
    let as_root = user_is_root()?;
    let apt = |arguments: &[&str]| -> Result<(), String> {
        let mut command = Command::new(if as_root { "apt-get" } else { "sudo" });
        if !as_root {
            command.args(["-n", "DEBIAN_FRONTEND=noninteractive", "apt-get"]);
        }
        command.env("DEBIAN_FRONTEND", "noninteractive").stdin(std::process::Stdio::null()).args(arguments);
        let done = command.status().map_err(|error| format!("apt-get: {error}; verify needs Debian 12"))?;
        if done.success() { Ok(()) } else { Err(format!("apt-get {} ended with {done}", arguments.join(" "))) }
    };
    if let Err(message) = apt(&["update", "-q"]) {
        // One broken source of many need not matter; the installation itself will tell.
        eprintln!("verify: {message}; going on");
    }
    let mut arguments = vec!["install", "-q", "-y", "--no-install-recommends", "-o", "Dpkg::Use-Pty=0"];
    arguments.extend(packages);
    apt(&arguments)
}

fn is_installed(package: &str) -> bool {
    let output = Command::new("dpkg-query").args(["-W", "-f=${db:Status-Status}", package]).output();
    output.is_ok_and(|output| String::from_utf8_lossy(&output.stdout) == "installed")
}

fn user_is_root() -> Result<bool, String> {
    let output = Command::new("id").arg("-u").output().map_err(|error| format!("id: {error}"))?;
    Ok(String::from_utf8_lossy(&output.stdout).trim() == "0")
}

/// Says what is missing, and how to get it.
pub(crate) fn check(root: &Path) -> Result<(), String> {
    let output = programs::python(root)
        .args(["-c", "import dolfinx, gmsh; print(dolfinx.__version__)"])
        .output()
        .map_err(|error| remedy(&format!("{PYTHON}: {error}")))?;
    if output.status.success() {
        return Ok(());
    }
    let message = String::from_utf8_lossy(&output.stderr);
    Err(remedy(message.lines().last().unwrap_or("dolfinx cannot be imported")))
}

fn remedy(problem: &str) -> String {
    format!(
        "{problem}\n    The references are solved by Debian's dolfinx and gmsh.\n    remedy: cargo xtask verify --install\n    \
         (apt-get install --no-install-recommends {})",
        PACKAGES.join(" ")
    )
}
