//! Starts the program in a folder of its own.

use std::path::{Path, PathBuf};
use std::process::{Child, Command, Output, Stdio};

/// A folder that vanishes with the test.
pub(crate) struct Bench {
    folder: temp_dir::TempDir,
}

/// What a call left behind.
pub(crate) struct Call {
    pub(crate) code: i32,
    pub(crate) out: String,
    pub(crate) err: String,
}

impl Bench {
    pub(crate) fn new() -> Bench {
        Bench { folder: temp_dir::TempDir::new().unwrap() }
    }

    pub(crate) fn path(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    pub(crate) fn file(&self, name: &str, text: &str) -> PathBuf {
        let path = self.path(name);
        std::fs::create_dir_all(path.parent().unwrap()).unwrap();
        std::fs::write(&path, text).unwrap();
        path
    }

    pub(crate) fn read(&self, name: &str) -> String {
        std::fs::read_to_string(self.path(name)).unwrap()
    }

    pub(crate) fn bytes(&self, name: &str) -> Vec<u8> {
        std::fs::read(self.path(name)).unwrap()
    }

    /// Calls wearshape with blank-separated arguments; `_` in an argument stands for a blank.
    pub(crate) fn call(&self, args: &str) -> Call {
        self.call_with(&args.split_whitespace().map(|arg| arg.replace('_', " ")).collect::<Vec<_>>())
    }

    pub(crate) fn call_with(&self, args: &[impl AsRef<std::ffi::OsStr>]) -> Call {
        let mut command = Command::new(env!("CARGO_BIN_EXE_wearshape"));
        finished(command.args(args).current_dir(self.folder.path()).output().unwrap())
    }

    /// Calls `check` and `run` with the same scene and settings, blank-separated: both refuse it in the same words with exit 2, or neither does.
    /// Returns the call of `run`.
    pub(crate) fn check_and_run(&self, scene: &str) -> Call {
        let with = |command| [command].into_iter().chain(scene.split_whitespace()).collect::<Vec<_>>();
        let [check, run] = ["check", "run"].map(|command| self.call_with(&with(command)));
        assert_eq!(check.code == 2, run.code == 2, "{scene}\ncheck: {}{}\nrun: {}{}", check.out, check.err, run.out, run.err);
        if run.code == 2 {
            assert_eq!(check.err, run.err, "{scene}");
            assert!(check.out.is_empty() && run.out.is_empty(), "errors belong on stderr");
            assert!(!check.err.contains('@'), "{}", check.err);
        } else {
            assert_eq!(check.code, 0, "{scene}: {}", check.err);
        }
        run
    }

    /// Starts a call and leaves it running; what it says on stderr can be read at its end.
    pub(crate) fn start(&self, args: &str) -> Child {
        let args = args.split_whitespace().map(|arg| arg.replace('_', " "));
        let mut command = Command::new(env!("CARGO_BIN_EXE_wearshape"));
        command.args(args).current_dir(self.folder.path()).stdout(Stdio::null()).stderr(Stdio::piped()).spawn().unwrap()
    }

    /// Runs a shell script in which `$0` is the program.
    pub(crate) fn shell(&self, script: &str) -> Call {
        let mut shell = Command::new("sh");
        finished(shell.args(["-c", script, env!("CARGO_BIN_EXE_wearshape")]).current_dir(self.folder.path()).output().unwrap())
    }

    /// The summary of a run in out/.
    pub(crate) fn summary(&self, name: &str) -> serde_json::Value {
        serde_json::from_str(&self.read(&format!("out/{name}/summary.json"))).unwrap()
    }
}

/// Presses Ctrl-C in a call that goes on. The signal is there at once: starting `kill` may take longer than what is to be interrupted.
#[cfg(unix)]
pub(crate) fn press_ctrl_c(child: &Child) {
    use rustix::process::{Pid, Signal, kill_process};
    kill_process(Pid::from_child(child), Signal::INT).unwrap();
}

/// SHA-256 of a text.
pub(crate) fn sha256(text: &str) -> String {
    use sha2::Digest;
    sha2::Sha256::digest(text).iter().map(|byte| format!("{byte:02x}")).collect()
}

fn finished(output: Output) -> Call {
    Call {
        code: output.status.code().unwrap_or(-1),
        out: String::from_utf8(output.stdout).unwrap(),
        err: String::from_utf8(output.stderr).unwrap(),
    }
}

/// Every file below a folder, sorted, by its path from there.
pub(crate) fn files(folder: &Path) -> Vec<String> {
    let mut found = Vec::new();
    let mut open = vec![folder.to_path_buf()];
    while let Some(next) = open.pop() {
        for entry in std::fs::read_dir(next).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                open.push(path);
            } else {
                found.push(path.strip_prefix(folder).unwrap().to_string_lossy().replace('\\', "/"));
            }
        }
    }
    found.sort();
    found
}
