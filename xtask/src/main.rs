//! Project chores, started as `cargo xtask <chore>`.

mod api;
mod bench;
mod book;
mod builds;
mod campaign;
mod crates;
mod editor;
mod estimates;
mod fuzz;
mod machine;
mod outputs;
mod package;
mod packages;
mod python;
mod speed;
mod stability;
mod supply;
mod tidy;
mod tube;
mod validation;
mod verify;
mod web;

use std::path::{Path, PathBuf};
use std::process::ExitCode;

const USAGE: &str = "\
usage: cargo xtask <chore>

  tidy      check what the compiler does not: import table, circles between modules, length of
            files and functions, what libraries may not do, unwrap, absolute paths
            --list: the figures, and every import within a circle
  verify    compare wearshape with independent solutions by Debian's dolfinx and gmsh
            [--install] [--quick] [--case NAME] [--fault friction-sign|young] [--can-fail]
            [--known] [--program PATH]
            --study: error against seconds of both [--case NAME] [--repeat N] [--docs]
  validation  writes docs/validation.md: the paper's figures and tables, recomputed
  stability run extreme cases: each must be right, or refused by name
            [--case NAME] [--scenes] [--program PATH] [--docs]
  estimates true errors over estimated ones on random scenes of fixed discretisation
            [--seed N] [--count N] [--minutes N] [--program PATH] [--docs]
  campaign  random scenes beside mirrored, scaled, swapped, renamed and finer twins, in other units and
            with other threads: what must not change the answer does not [--scenes N] [--seed N]
  fuzz      mutated scenes, meshes, profiles and recordings in 1 GB of memory and 5 s each
            [scene|gmsh|profile|recording ..] [--seconds N] [--seed N]
  outputs   open the files of runs with VTK, ezdxf, the reader of MCAP and Chromium [--install]
  editor    check the scenes by the schema with the checker of an editor plug-in (taplo, from npm)
  crates    whether each library crate packs all that it needs, files and versions, and offers the
            names that docs/api lists [--write]
  builds    the libraries by the oldest Rust promised, and without features
  python    the package for Python in an environment of its own below target: built, its tests, types
            and notebooks [--install]
  wheel     the package for Python as a file that others install, into target/wheels [--install]
  web       the page that computes in a browser, into target/web; --test uses it in headless Chromium, and
            calls the module of hpfem alone from node [--test] [--install]
  supply    every package of others comes from the registry, under a licence that deny.toml allows
  book      the book, into target/book: pages with the output of their commands, keys by the schema, links
            [--test]: the examples of the keys too  [--all]: commands of minutes too  [--program PATH]
  package   the static program, manual pages, completions, notices of third parties, the list of
            components and the Debian package
  bench     run the benches of our crates and print their ratios [crate ..]
            --against REV: processor seconds and peak memory of the program over those of a revision, or of
            --program PATH, on the built-in scenes and verify/speed.toml [--case NAME] [--repeat N] [--docs]
  profile   where the time of every built-in scene and of bodies from gmsh goes [--case NAME] [--docs]
";

fn main() -> ExitCode {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let root = workspace_root();
    if let Some(help) = help(&words) {
        print!("{help}");
        return ExitCode::SUCCESS;
    }
    match words.first().map(String::as_str) {
        Some("tidy") => tidy::run(&root, &words[1..]),
        Some("bench") if words[1..].iter().any(|word| word.starts_with("--")) => speed::against(&root, &words[1..]),
        Some("bench") => bench::run(&root, &words[1..]),
        Some("profile") => speed::profile(&root, &words[1..]),
        Some("book") => book::run(&root, &words[1..]),
        Some("stability") => stability::run(&root, &words[1..]),
        Some("estimates") => estimates::run(&root, &words[1..]),
        Some("verify") => verify::run(&root, &words[1..]),
        Some("campaign") => campaign::run(&root, &words[1..]),
        Some("fuzz") => fuzz::run(&root, &words[1..]),
        Some("validation") => validation::run(&root),
        Some("editor") => editor::run(&root),
        Some("outputs") => outputs::run(&root, &words[1..]),
        Some("crates") => crates::run(&root, &words[1..]),
        Some("builds") => builds::run(&root),
        Some("supply") => supply::run(&root),
        Some("python") => python::run(&root, &words[1..]),
        Some("wheel") => python::wheel(&root, &words[1..]),
        Some("web") => web::run(&root, &words[1..]),
        Some("package") => package::run(&root),
        Some(other) => {
            eprintln!("xtask: there is no chore `{other}`\n\n{USAGE}");
            ExitCode::from(2)
        }
        None => {
            eprint!("{USAGE}");
            ExitCode::from(2)
        }
    }
}

/// What is asked for by `help`, or by `--help` behind a chore: its lines of the usage.
fn help(words: &[String]) -> Option<String> {
    let asks = |word: &String| matches!(word.as_str(), "-h" | "--help");
    let (chore, rest) = words.split_first()?;
    if chore == "help" || asks(chore) {
        return Some(USAGE.into());
    }
    let begins = |line: &&str| line.starts_with("  ") && !line.starts_with("   ");
    let mut lines = USAGE.lines().skip_while(|line| !begins(line) || line.split_whitespace().next() != Some(chore));
    let first = lines.next().filter(|_| rest.iter().any(asks))?;
    let lines: Vec<&str> = [first].into_iter().chain(lines.take_while(|line| !begins(line))).collect();
    Some(format!("usage: cargo xtask {chore}\n\n{}\n", lines.join("\n")))
}

/// The folder of the workspace: the parent of this package's own folder.
fn workspace_root() -> PathBuf {
    let package = std::env::var("CARGO_MANIFEST_DIR").unwrap_or_else(|_| env!("CARGO_MANIFEST_DIR").into());
    Path::new(&package).parent().map_or_else(|| PathBuf::from("."), Path::to_path_buf)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_chore_has_its_part_of_the_help() {
        let of = |words: &[&str]| help(&words.iter().map(|word| (*word).into()).collect::<Vec<String>>());
        let stability = of(&["stability", "--help"]).unwrap_or_default();
        assert!(stability.contains("[--case NAME] [--scenes]") && !stability.contains("estimates"), "{stability}");
        assert_eq!(stability.lines().count(), 4);
        for chore in ["tidy", "verify", "validation", "bench", "profile"] {
            assert!(of(&[chore, "--case", "x", "-h"]).unwrap_or_default().contains(&format!("\n  {chore} ")), "{chore}");
        }
        assert_eq!((of(&["--help"]), of(&["help"])), (Some(USAGE.into()), Some(USAGE.into())));
        assert_eq!((of(&["nosuch", "--help"]), of(&["tidy", "--list"]), of(&[])), (None, None, None));
    }
}
