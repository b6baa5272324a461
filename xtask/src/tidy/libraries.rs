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

const NO_STATE: &str = "pass it as an argument: two callers in one process must not see each other";

const PRINTING: &[&str] = &["println", "print", "eprintln", "eprint"];

/// Types whose content changes behind a shared reference.
const INTERIOR: &[&str] = &["Mutex", "RwLock", "OnceLock", "OnceCell", "LazyLock", "LazyCell", "Cell", "RefCell", "UnsafeCell"];

/// Of these, the types that are written once.
const ONCE: &[&str] = &["OnceLock", "LazyLock"];

/// Statics that hold a table of constants, each with the reason why it is kept. They are written once, with what depends on nothing, so
/// that no caller can tell whether another was there before; a static that could be written again is not helped by an entry.
const TABLES_OF_CONSTANTS: &[(&str, &str)] = &[
    (
        "hpfem/basis.rs: static TABLES",
        "shape functions of a degree and their products at the Gauss points: every element matrix is integrated from them, and making them \
         takes longer than a cell",
    ),
    (
        "wear/quadrature.rs: static RULE",
        "abscissas and weights of one Gauss-Legendre rule, found by Newton's method: every integral over every piece of a surface asks for them",
    ),
];

/// Findings in all files; `known` are the places of today, as `hpfem/body.rs: std::time`.
pub(super) fn check(files: &[Parsed], known: &[&str]) -> Vec<Finding> {
    check_with(files, known, TABLES_OF_CONSTANTS)
}

fn check_with(files: &[Parsed], known: &[&str], tables: &[(&str, &str)]) -> Vec<Finding> {
    let mut findings = Vec::new();
    let mut needed = Vec::new();
    let mut kept = Vec::new();
    for file in files.iter().filter(|file| !TOPS.contains(&file.krate.as_str())) {
        let mut uses = Vec::new();
        collect(&names(&file.tree), &mut uses);
        for Use { what, line, remedy, once } in uses {
            let place = format!("{}/{}: {what}", file.krate, file.inner);
            if once && tables.iter().any(|(table, _)| *table == place) {
                kept.push(place);
                continue;
            }
            if !known.contains(&place.as_str()) {
                let problem = format!("`{what}` in a library");
                findings.push(Finding { file: file.path.clone(), line, problem, remedy: remedy.into() });
            }
            needed.push(place);
        }
    }
    let stale = known.iter().filter(|place| !needed.iter().any(|needed| needed == *place));
    findings.extend(stale.map(|place| gone("today.rs", "OUTSIDE_LIBRARIES", place)));
    let stale = tables.iter().filter(|(place, _)| !kept.iter().any(|kept| kept == place));
    findings.extend(stale.map(|(place, _)| gone("libraries.rs", "TABLES_OF_CONSTANTS", place)));
    findings.sort();
    findings.dedup();
    findings
}

fn gone(file: &str, list: &str, place: &str) -> Finding {
    Finding {
        file: format!("xtask/src/tidy/{file}"),
        line: 1,
        problem: format!("{list} lists `{place}`, which is not there"),
        remedy: "take it off the list".into(),
    }
}

/// One use of what has no place there.
struct Use {
    what: String,
    line: usize,
    remedy: &'static str,
    /// A static that is written once.
    once: bool,
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
        let mut interior = words.iter().filter(|word| INTERIOR.contains(&word.as_str()) || word.starts_with("Atomic")).peekable();
        if interior.peek().is_some() {
            let once = interior.all(|word| ONCE.contains(&word.as_str()));
            uses.push(Use { what: format!("static {name}"), line: *line, remedy: NO_STATE, once });
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
                uses.push(Use { what: (*banned).into(), line, remedy: ban.remedy, once: false });
            }
        }
    }
    if path.contains(&"ThreadPoolBuilder") {
        let remedy = "work in the pool that the caller installed";
        uses.push(Use { what: "ThreadPoolBuilder".into(), line, remedy, once: false });
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
            once: false,
        });
    }
    if name == "thread_local" {
        uses.push(Use { what: "thread_local!".into(), line: mention.line, remedy: NO_STATE, once: false });
    }
}

#[cfg(test)]
mod tests {
    use super::super::finding::file;
    use super::super::parsed::parse;
    use super::*;

    fn found(path: &str, text: &str) -> Vec<(usize, String)> {
        let (parsed, _) = parse(&[file(path, text)]);
        check_with(&parsed, &[], &[]).into_iter().map(|finding| (finding.line, finding.problem)).collect()
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
        assert!(check_with(&parsed, &["hpfem/body.rs: std::time"], &[]).is_empty());
        let findings = check_with(&parsed, &["hpfem/body.rs: std::time", "hpfem/gone.rs: std::fs"], &[]);
        assert_eq!(findings.len(), 1);
        assert_eq!(findings[0].remedy, "take it off the list");
    }

    #[test]
    fn tables_of_constants_are_kept_if_they_are_written_once() {
        let tables = [("hpfem/basis.rs: static TABLES", "asked for by every cell")];
        let found = |text: &str| check_with(&parse(&[file("crates/hpfem/src/basis.rs", text)]).0, &[], &tables);
        assert!(found("static TABLES: [OnceLock<Table>; 21] = [const { OnceLock::new() }; 21];\n").is_empty());
        assert!(found("fn f() { static TABLES: LazyLock<Table> = LazyLock::new(table); }\n").is_empty());
        let other = found("static OTHER: OnceLock<Table> = OnceLock::new();\n");
        assert_eq!(other.len(), 2, "{other:?}");
        assert!(other[1].problem.contains("TABLES_OF_CONSTANTS lists") && other[0].problem.contains("static OTHER"));
        assert_eq!(found("static TABLES: OnceLock<Mutex<Table>> = OnceLock::new();\n").len(), 2);
    }
}
