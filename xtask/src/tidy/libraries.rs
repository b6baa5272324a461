//! What has no place below `cli`: files, clocks, printing, processes, global state, thread pools.
//!
//! A library takes bytes and numbers and returns bytes and numbers, so that any program can build on it: a server, a notebook, a page in
//! a browser.

use super::finding::Finding;
use super::names::{Form, Mention, Names, names};
use super::parsed::Parsed;

/// Crates that are programs or bindings; every other folder below `crates` is a library.
const TOPS: &[&str] = &["cli", "python", "web", "xtask"];

/// A part of the standard library, and what to do instead.
struct Ban {
    paths: &'static [&'static str],
    remedy: &'static str,
}

const BANS: &[Ban] = &[
    Ban {
        paths: &["std::fs", "std::env", "std::process", "std::net", "std::io::stdin", "std::io::stdout", "std::io::stderr"],
        remedy: "take bytes or numbers as an argument; only cli reads, writes and starts programs",
    },
    Ban { paths: &["std::time"], remedy: "who calls measures the seconds, between the events it watches" },
];

const PRINTING: &[&str] = &["println", "print", "eprintln", "eprint"];

/// Types whose content changes behind a shared reference.
const INTERIOR: &[&str] = &["Mutex", "RwLock", "OnceLock", "OnceCell", "LazyLock", "LazyCell", "Cell", "RefCell", "UnsafeCell"];

/// Findings in all files; `known` are the places of today, as `hpfem/body.rs: std::time`.
pub(super) fn check(files: &[Parsed], known: &[&str]) -> Vec<Finding> {
    let mut findings = Vec::new();
    let mut needed = Vec::new();
    for file in files.iter().filter(|file| !TOPS.contains(&file.krate.as_str())) {
        let mut uses = Vec::new();
        collect(&names(&file.tree), &mut uses);
        for Use { what, line, remedy } in uses {
            let place = format!("{}/{}: {what}", file.krate, file.inner);
            if !known.contains(&place.as_str()) {
                let problem = format!("`{what}` in a library");
                findings.push(Finding { file: file.path.clone(), line, problem, remedy: remedy.into() });
            }
            needed.push(place);
        }
    }
    let stale = known.iter().filter(|place| !needed.iter().any(|needed| needed == *place));
    findings.extend(stale.map(|place| Finding {
        file: "xtask/src/tidy/today.rs".into(),
        line: 1,
        problem: format!("OUTSIDE_LIBRARIES lists `{place}`, which is not there"),
        remedy: "take it off the list".into(),
    }));
    findings.sort();
    findings.dedup();
    findings
}

/// One use of what has no place there.
struct Use {
    what: String,
    line: usize,
    remedy: &'static str,
}

fn collect(names: &Names, uses: &mut Vec<Use>) {
    for import in &names.imports {
        path(&import.path, import.line, uses);
    }
    for mention in &names.mentions {
        path(&in_full(mention, names), mention.line, uses);
        macros(mention, uses);
    }
    for (name, words, line) in &names.statics {
        if words.iter().any(|word| INTERIOR.contains(&word.as_str()) || word.starts_with("Atomic")) {
            global(&format!("static {name}"), *line, uses);
        }
    }
    names.inline.iter().for_each(|(_, inside)| collect(inside, uses));
}

/// A path with its first word replaced by what a `use` line makes of it: `io::stdin` is `std::io::stdin`.
fn in_full(mention: &Mention, names: &Names) -> Vec<String> {
    let import = mention.path.first().and_then(|first| names.imports.iter().find(|import| import.name == *first));
    import.map_or_else(|| mention.path.clone(), |import| [&import.path[..], &mention.path[1..]].concat())
}

fn path(path: &[String], line: usize, uses: &mut Vec<Use>) {
    let path: Vec<&str> = path.iter().map(String::as_str).skip_while(|word| word.is_empty()).collect();
    for ban in BANS {
        for banned in ban.paths {
            let words: Vec<&str> = banned.split("::").collect();
            if path.starts_with(&words) {
                uses.push(Use { what: (*banned).into(), line, remedy: ban.remedy });
            }
        }
    }
    if path.contains(&"ThreadPoolBuilder") {
        let remedy = "work in the pool that the caller installed";
        uses.push(Use { what: "ThreadPoolBuilder".into(), line, remedy });
    }
}

fn macros(mention: &Mention, uses: &mut Vec<Use>) {
    let Some(name) = mention.path.last().filter(|_| mention.form == Form::Macro) else {
        return;
    };
    if PRINTING.contains(&name.as_str()) {
        uses.push(Use {
            what: format!("{name}!"),
            line: mention.line,
            remedy: "return the number or the sentence; only cli prints",
        });
    }
    if name == "thread_local" {
        global("thread_local!", mention.line, uses);
    }
}

fn global(what: &str, line: usize, uses: &mut Vec<Use>) {
    let remedy = "pass it as an argument: two callers in one process must not see each other";
    uses.push(Use { what: what.into(), line, remedy });
}

#[cfg(test)]
mod tests {
    use super::super::finding::file;
    use super::super::parsed::parse;
    use super::*;

    fn found(path: &str, text: &str) -> Vec<(usize, String)> {
        let (parsed, _) = parse(&[file(path, text)]);
        check(&parsed, &[]).into_iter().map(|finding| (finding.line, finding.problem)).collect()
    }

    fn lines(text: &str) -> Vec<usize> {
        found("crates/wearshape/src/solve.rs", text).into_iter().map(|(line, _)| line).collect()
    }

    #[test]
    fn libraries_neither_print_nor_read_files_nor_look_at_clocks() {
        let text = "//! println! is only spoken of\nfn f() {\n    println!(\"{}\", 1);\n    let x = std::fs::read(\"a\");\n    std::time::Instant::now();\n}\n";
        assert_eq!(lines(text), [3, 4, 5]);
        for krate in ["hpfem", "contact", "wear", "shapeopt", "scene", "meshing", "report"] {
            assert_eq!(found(&format!("crates/{krate}/src/law.rs"), text).len(), 3, "{krate}");
        }
        for path in ["crates/cli/src/main.rs", "crates/web/src/lib.rs", "xtask/src/main.rs", "crates/wear/tests/it/main.rs"] {
            assert!(found(path, text).is_empty(), "{path}");
        }
    }

    #[test]
    fn groups_and_aliases_do_not_hide_them() {
        assert_eq!(lines("use std::{\n    fmt,\n    fs::File,\n    time as t,\n};\n"), [3, 4]);
        assert_eq!(lines("use std::io;\nfn f() {\n    io::Write::flush(&mut io::stdout());\n}\n"), [3]);
        assert_eq!(lines("fn f() { assert!(g(\n    std::env::var(\"A\")\n)) }\n"), [2]);
    }

    #[test]
    fn global_state_and_pools_are_found() {
        let text = "static STOP: AtomicBool = AtomicBool::new(false);\nstatic A: std::sync::OnceLock<f64> = OnceLock::new();\nthread_local! { static B: u8 = 1; }\nstatic TABLE: [f64; 2] = [0.0; 2];\n";
        assert_eq!(lines(text), [1, 2, 3]);
        assert_eq!(lines("fn f() { rayon::ThreadPoolBuilder::new(); }\nfn g(lock: &Mutex<f64>) {}\n"), [1]);
    }

    #[test]
    fn tests_may() {
        assert!(lines("#[cfg(test)]\nmod tests { fn f() { std::fs::read(\"a\"); println!(); } }\n").is_empty());
    }

    #[test]
    fn known_places_pass_and_mended_ones_leave_the_list() {
        let (parsed, _) = parse(&[file("crates/hpfem/src/body.rs", "use std::time::Instant;\n")]);
        assert!(check(&parsed, &["hpfem/body.rs: std::time"]).is_empty());
        let findings = check(&parsed, &["hpfem/body.rs: std::time", "hpfem/gone.rs: std::fs"]);
        assert_eq!(findings.len(), 1);
        assert_eq!(findings[0].remedy, "take it off the list");
    }
}
