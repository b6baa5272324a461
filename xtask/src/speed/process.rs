//! A program's processor seconds and peak memory.

use std::path::Path;
use std::process::{Command, Stdio};
use wait4::Wait4;

/// What a run took.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Taken {
    /// User and system seconds.
    pub(crate) user: f64,
    pub(crate) system: f64,
    /// Peak memory, MB.
    pub(crate) peak: f64,
}

impl Taken {
    /// Processor seconds.
    pub(crate) fn seconds(&self) -> f64 {
        self.user + self.system
    }
}

/// Runs a program to its end; `None` if it does not end well, say because it is too old for the scene.
pub(crate) fn run(root: &Path, program: &Path, words: &[String]) -> Result<Option<Taken>, String> {
    let mut command = Command::new(program);
    command.current_dir(root).args(words).stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null());
    let failed = |error: std::io::Error| format!("{}: {error}", program.display());
    let used = command.spawn().map_err(failed)?.wait4().map_err(failed)?;
    let taken = Taken {
        user: used.rusage.utime.as_secs_f64(),
        system: used.rusage.stime.as_secs_f64(),
        peak: used.rusage.maxrss as f64 / 1e6,
    };
    Ok(used.status.success().then_some(taken))
}
