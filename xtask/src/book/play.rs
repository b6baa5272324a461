//! Runs the commands of a page.
//!
//! Lines of `sh` blocks that begin with `wearshape ` are run in their order in a folder of the page's own, where `data` is that of the repository. Each must end with 0, or
//! as its comment says (`# exit 2`); those with the comment `# minutes` are left out unless all are asked for. A block after `<!-- file: NAME -->` is
//! written to that file first, and `<!-- output -->` becomes what the last block printed.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use super::files::write;

/// What runs the commands of pages.
pub(super) struct Player<'a> {
    pub root: &'a Path,
    /// The program itself.
    pub program: &'a Path,
    /// The folder of the folders that pages run in.
    pub runs: &'a Path,
    /// Whether lines that take minutes are run too.
    pub all: bool,
}

/// A fenced block of a page.
#[derive(Default)]
struct Block {
    language: String,
    lines: Vec<String>,
}

impl Player<'_> {
    /// A page with its outputs filled in, and how many commands it has run.
    pub(super) fn played(&self, page: &str, text: &str) -> Result<(String, usize), String> {
        let folder = self.runs.join(page.trim_end_matches(".md"));
        let mut lines: Vec<String> = Vec::new();
        let (mut open, mut file, mut printed, mut commands) = (None, None, String::new(), 0);
        for line in text.lines() {
            match (&mut open, line.trim_start().strip_prefix("```")) {
                (None, Some(language)) => open = Some(Block { language: language.trim().into(), lines: Vec::new() }),
                (Some(_), Some(_)) => {
                    let block: Block = open.take().unwrap_or_default();
                    if let Some(name) = file.take() {
                        write(&folder.join::<String>(name), &(block.lines.join("\n") + "\n"))?;
                    }
                    if block.language == "sh" {
                        let (words, count) = self.block(&folder, &block.lines)?;
                        (printed, commands) = (words, commands + count);
                    }
                }
                (Some(block), None) => block.lines.push(line.into()),
                (None, None) => {}
            }
            match line.trim() {
                "<!-- output -->" => lines.push(format!("```text\n{}\n```", printed.trim_matches('\n'))),
                order => {
                    file =
                        order.strip_prefix("<!-- file: ").and_then(|name| name.strip_suffix(" -->")).map(String::from).or(file);
                    lines.push(line.into());
                }
            }
        }
        Ok((lines.join("\n") + "\n", commands))
    }

    /// Runs the lines of a block; what they print, and how many they are.
    fn block(&self, folder: &Path, lines: &[String]) -> Result<(String, usize), String> {
        let (mut printed, mut count) = (String::new(), 0);
        for line in lines.iter().map(|line| line.trim()).filter(|line| line.starts_with("wearshape ")) {
            let comment = line.split_once("  #").map_or("", |(_, comment)| comment);
            if comment.contains("minutes") && !self.all {
                continue;
            }
            let wanted = comment.split_once("exit ").and_then(|(_, code)| code.chars().next()?.to_digit(10)).unwrap_or(0);
            let (code, words) = self.line(folder, line)?;
            if code != wanted as i32 {
                return Err(format!("`{line}` ended with {code}, not {wanted}:\n{words}"));
            }
            printed += &words;
            count += 1;
        }
        Ok((printed, count))
    }

    /// Runs one line in a shell that finds the program by its name; its exit code and what it printed.
    pub(super) fn line(&self, folder: &Path, line: &str) -> Result<(i32, String), String> {
        let programs = self.prepared(folder)?;
        let before = std::env::var_os("PATH").unwrap_or_default();
        let paths = std::iter::once(programs).chain(std::env::split_paths(&before));
        let path = std::env::join_paths(paths).map_err(|error| format!("PATH: {error}"))?;
        let output = Command::new("sh")
            .args(["-c", line])
            .current_dir(folder)
            .env("PATH", path)
            .stdin(Stdio::null())
            .output()
            .map_err(|error| format!("sh: {error}"))?;
        let words = [output.stdout, output.stderr].map(|bytes| String::from_utf8_lossy(&bytes).into_owned()).concat();
        Ok((output.status.code().unwrap_or(-1), words))
    }

    /// Makes the folder of a page, and the one with the program by its name.
    fn prepared(&self, folder: &Path) -> Result<PathBuf, String> {
        let programs = self.runs.join("bin");
        for folder in [folder, &programs] {
            fs::create_dir_all(folder).map_err(|error| format!("{}: {error}", folder.display()))?;
        }
        self.linked(self.program, &programs.join("wearshape"))?;
        self.linked(&self.root.join("data"), &folder.join("data"))?;
        Ok(programs)
    }

    fn linked(&self, from: &Path, to: &Path) -> Result<(), String> {
        if to.exists() {
            return Ok(());
        }
        let done = std::os::unix::fs::symlink(from, to);
        done.map_err(|error| format!("{}: {error}", to.display()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Plays a page with the shell under the name of the program, in a folder of the test's own.
    fn played(name: &str, text: &str) -> Result<(String, usize), String> {
        let root = std::env::temp_dir().join(format!("wearshape-book-{}-{name}", std::process::id()));
        fs::create_dir_all(root.join("data")).expect("a folder");
        let player = Player { root: &root, program: Path::new("/bin/sh"), runs: &root.join("runs"), all: false };
        let played = player.played("a/b.md", text);
        fs::remove_dir_all(&root).expect("the folder");
        played
    }

    #[test]
    fn files_are_written_commands_run_and_outputs_shown() {
        let page =
            "<!-- file: a.toml -->\n```toml\nx = 1\n```\n```sh\nls nowhere\nwearshape -c 'cat a.toml'\n```\n<!-- output -->\n";
        let (text, commands) = played("shown", page).expect("a page");
        assert!(commands == 1 && text.ends_with("```\n```text\nx = 1\n```\n"), "{text}");
    }

    #[test]
    fn an_end_that_the_page_does_not_tell_is_an_error() {
        let page = |line: &str| played("ends", &format!("```sh\n{line}\n```\n"));
        assert!(page("wearshape -c 'exit 2'").is_err());
        assert!(page("wearshape -c 'exit 2'  # exit 2").is_ok_and(|(_, commands)| commands == 1));
        assert!(page("wearshape -c true  # exit 2").is_err());
        assert!(page("wearshape -c false  # some minutes").is_ok_and(|(_, commands)| commands == 0));
    }
}
