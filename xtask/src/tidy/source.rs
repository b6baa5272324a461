//! Rules on single files: length, unwrap, absolute paths.

use super::finding::{Finding, TextFile};
use super::strip::{strip, test_modules};

/// Longest file that needs no reason, in lines.
const LONGEST: usize = 400;

/// Longer files, each with the reason why it stays one file.
const LONG_FILES: &[(&str, &str)] = &[];

/// A piece of code that has no place in some files.
struct Ban {
    words: &'static [&'static str],
    remedy: &'static str,
}

const DEBUGGING: Ban = Ban { words: &["dbg!", "todo!", "unimplemented!"], remedy: "finish it or take it out" };
const GIVING_UP: Ban = Ban {
    words: &[".unwrap()", ".unwrap_err()", "panic!"],
    remedy: "wrong input is an Err with the numbers in it, not converging is a status, our own bug is an assert",
};

/// Findings in all files, one at a time.
pub(super) fn check(files: &[TextFile]) -> Vec<Finding> {
    check_with(files, LONG_FILES)
}

fn check_with(files: &[TextFile], long_files: &[(&str, &str)]) -> Vec<Finding> {
    let mut findings = Vec::new();
    let in_tests = test_files(files);
    for file in files {
        length(file, long_files, &mut findings);
        absolute_paths(file, &mut findings);
        let source = file.path.starts_with("crates/") && file.path.contains("/src/") && file.path.ends_with(".rs");
        if !source || in_tests.contains(&file.path) {
            continue;
        }
        let code = strip(&file.text);
        banned(file, &code, &DEBUGGING, &mut findings);
        banned(file, &code, &GIVING_UP, &mut findings);
    }
    stale_reasons(files, long_files, &mut findings);
    findings
}

/// Files that hold a module declared as `#[cfg(test)] mod name;`.
pub(super) fn test_files(files: &[TextFile]) -> Vec<String> {
    let mut paths = Vec::new();
    for file in files.iter().filter(|file| file.path.ends_with(".rs")) {
        let stem = file.path.trim_end_matches(".rs");
        let folder = match stem.rsplit_once('/') {
            Some((folder, "lib" | "main" | "mod")) => folder,
            _ => stem,
        };
        for name in test_modules(&file.text) {
            paths.push(format!("{folder}/{name}.rs"));
            paths.push(format!("{folder}/{name}/mod.rs"));
        }
    }
    paths
}

fn length(file: &TextFile, long_files: &[(&str, &str)], findings: &mut Vec<Finding>) {
    let lines = file.text.lines().count();
    let code = file.path.ends_with(".rs") || file.path.ends_with(".py");
    if code && lines > LONGEST && !long_files.iter().any(|(path, _)| *path == file.path) {
        findings.push(Finding {
            file: file.path.clone(),
            line: LONGEST + 1,
            problem: format!("{lines} lines, more than {LONGEST}"),
            remedy: "one public concept a file: split it, or list it with a reason in LONG_FILES of xtask/src/tidy/source.rs"
                .into(),
        });
    }
}

fn stale_reasons(files: &[TextFile], long_files: &[(&str, &str)], findings: &mut Vec<Finding>) {
    for (path, reason) in long_files {
        let long = files.iter().any(|file| file.path == *path && file.text.lines().count() > LONGEST);
        if !long {
            findings.push(Finding {
                file: (*path).into(),
                line: 1,
                problem: format!("listed as a long file (\"{reason}\") and is none"),
                remedy: "take it off LONG_FILES in xtask/src/tidy/source.rs".into(),
            });
        }
    }
}

fn banned(file: &TextFile, code: &str, ban: &Ban, findings: &mut Vec<Finding>) {
    for (number, line) in code.lines().enumerate() {
        for word in ban.words {
            let stands_alone =
                |at: usize| word.starts_with('.') || !line[..at].ends_with(|c: char| c.is_alphanumeric() || c == '_');
            if line.match_indices(word).any(|(at, _)| stands_alone(at)) {
                findings.push(Finding {
                    file: file.path.clone(),
                    line: number + 1,
                    problem: format!("`{word}` outside tests"),
                    remedy: ban.remedy.into(),
                });
            }
        }
    }
}

/// Folders that exist on one machine only, written in two parts so that this file passes.
const MACHINE_FOLDERS: &[&str] =
    &[concat!("/wo", "rk"), concat!("/ro", "ot"), concat!("/ho", "me"), concat!("/tm", "p"), concat!("/Us", "ers")];

fn absolute_paths(file: &TextFile, findings: &mut Vec<Finding>) {
    for (number, line) in file.text.lines().enumerate() {
        for folder in MACHINE_FOLDERS {
            let is_path = |at: usize| {
                let before = line[..at].chars().next_back();
                let after = line[at + folder.len()..].chars().next();
                let begins = before.is_none_or(|c| c.is_whitespace() || "\"'`(=<[{,:".contains(c));
                begins && after.is_none_or(|c| !c.is_alphanumeric() && c != '_' && c != '-')
            };
            if line.match_indices(folder).any(|(at, _)| is_path(at)) {
                findings.push(Finding {
                    file: file.path.clone(),
                    line: number + 1,
                    problem: format!("absolute path of one machine, `{folder}`"),
                    remedy: "use a path from the root of the workspace, or a temporary folder made by the program".into(),
                });
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::finding::file;
    use super::*;

    fn problems(path: &str, text: &str) -> Vec<(usize, String)> {
        check_with(&[file(path, text)], &[]).into_iter().map(|finding| (finding.line, finding.problem)).collect()
    }

    #[test]
    fn unwrap_is_found_outside_tests_only() {
        let text = "fn f() { a.unwrap() }\nfn g() { a.unwrap_or(1) }\n#[cfg(test)]\nmod tests {\n    fn h() { b.unwrap(); panic!() }\n}\n";
        assert_eq!(problems("crates/cli/src/scene.rs", text), [(1, "`.unwrap()` outside tests".to_string())]);
    }

    #[test]
    fn a_test_module_in_its_own_file_is_a_test() {
        let files = [
            file("crates/hpfem/src/basis.rs", "#[cfg(test)]\nmod tests;\n"),
            file("crates/hpfem/src/basis/tests.rs", "fn f() { a.unwrap() }\n"),
        ];
        assert!(check_with(&files, &[]).is_empty());
    }

    #[test]
    fn a_word_inside_another_is_not_the_word() {
        assert!(problems("crates/hpfem/src/a.rs", "my_println!();\nlet pprint = 1;\n").is_empty());
        assert_eq!(problems("crates/hpfem/src/a.rs", "dbg!(x);\n").len(), 1);
    }

    #[test]
    fn long_files_are_found() {
        assert!(problems("crates/hpfem/src/a.rs", &"x\n".repeat(LONGEST)).is_empty());
        assert_eq!(problems("verify/gap.py", &"x\n".repeat(LONGEST + 1)).len(), 1);
        assert!(problems("README.md", &"x\n".repeat(LONGEST + 1)).is_empty());
    }

    #[test]
    fn a_long_file_with_a_reason_passes_and_a_reason_without_one_does_not() {
        let listed = [("tests/table.rs", "numbers")];
        assert!(check_with(&[file("tests/table.rs", &"x\n".repeat(900))], &listed).is_empty());
        assert_eq!(check_with(&[file("tests/table.rs", "x\n")], &listed).len(), 1);
    }

    #[test]
    fn machine_folders_are_found_and_words_are_not() {
        let tmp = MACHINE_FOLDERS[3];
        assert_eq!(problems("docs/a.md", &format!("see `{tmp}/x`\n")).len(), 1);
        assert_eq!(problems("verify/a.py", &format!("open('{tmp}')\n")).len(), 1);
        assert!(problems("docs/a.md", "force/work, target/tmp/x, https://a.org/home, /usr/bin/python3\n").is_empty());
    }
}
