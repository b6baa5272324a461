//! The program of an earlier revision, built in a checkout and a target folder of its own.

use crate::packages::{done, printed};
use crate::verify::programs;
use std::path::{Path, PathBuf};
use std::process::Command;

/// Where the checkout is, below target.
const CHECKOUT: &str = "target/speed/checkout";

/// The short name of a revision.
pub(crate) fn name(root: &Path, revision: &str) -> Result<String, String> {
    let commit = format!("{revision}^{{commit}}");
    let text = printed(git(root).args(["rev-parse", "--short", "--verify", "--end-of-options", &commit]))?;
    Ok(text.trim().into())
}

/// Builds the program of a revision; one that was built before is not built again.
pub(crate) fn built(root: &Path, name: &str) -> Result<PathBuf, String> {
    let kept = root.join("target/speed").join(format!("wearshape-{name}"));
    if kept.exists() {
        return Ok(kept);
    }
    let checkout = root.join(CHECKOUT);
    if checkout.join(".git").exists() {
        done(git(&checkout).args(["checkout", "--quiet", "--detach", name]))?;
    } else {
        done(git(root).args(["worktree", "prune"]))?;
        done(git(root).args(["worktree", "add", "--quiet", "--detach"]).arg(&checkout).arg(name))?;
    }
    let program = programs::build(&checkout)?;
    std::fs::copy(&program, &kept).map_err(|error| format!("{}: {error}", kept.display()))?;
    Ok(kept)
}

fn git(folder: &Path) -> Command {
    let mut command = Command::new("git");
    command.current_dir(folder);
    command
}
