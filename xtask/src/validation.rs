//! `cargo xtask validation`: the page of the paper's figures and tables, written by the program into `docs`.

use std::fs;
use std::path::Path;
use std::process::{Command, ExitCode};

/// Calls `wearshape reproduce all` and copies its page and pictures to `docs`.
pub(crate) fn run(root: &Path) -> ExitCode {
    match renew(root) {
        Ok(count) => {
            println!("validation: docs/validation.md and {count} pictures written");
            ExitCode::SUCCESS
        }
        Err(message) => {
            eprintln!("validation: {message}");
            ExitCode::FAILURE
        }
    }
}

fn renew(root: &Path) -> Result<usize, String> {
    let out = root.join("target").join("reproduce");
    let arguments = ["run", "--release", "--quiet", "-p", "cli", "--", "reproduce", "all", "--quiet", "-o"];
    let status = Command::new("cargo").args(arguments).arg(&out).current_dir(root).status();
    match status {
        Ok(status) if status.success() => {}
        Ok(status) => return Err(format!("wearshape reproduce all ended with {status}")),
        Err(error) => return Err(format!("cargo: {error}")),
    }
    let (index, docs) = (out.join("index"), root.join("docs"));
    let copy = |from: &Path, to: &Path| {
        fs::copy(from, to).map(|_| ()).map_err(|error| format!("{} to {}: {error}", from.display(), to.display()))
    };
    copy(&index.join("validation.md"), &docs.join("validation.md"))?;
    let (from, to) = (index.join("validation"), docs.join("validation"));
    if to.exists() {
        fs::remove_dir_all(&to).map_err(|error| format!("{}: {error}", to.display()))?;
    }
    fs::create_dir_all(&to).map_err(|error| format!("{}: {error}", to.display()))?;
    let pictures = fs::read_dir(&from).map_err(|error| format!("{}: {error}", from.display()))?;
    let mut count = 0;
    for picture in pictures.filter_map(Result::ok) {
        copy(&picture.path(), &to.join(picture.file_name()))?;
        count += 1;
    }
    Ok(count)
}
