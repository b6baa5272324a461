//! `cargo xtask book`: the book, from the pages of the repository, into `target/book`.
//!
//! Every page keeps its path of the repository, so that its links are right in both places. Each `wearshape` line of a page's `sh` blocks is run in a folder
//! of the page's own and must end as the page says; outputs and pictures that the pages show are those of these runs. The keys of a scene are
//! written from the schema, the gallery from the built-in scenes.

mod examples;
mod excerpt;
mod files;
mod gallery;
mod keys;
mod made;
mod pages;
mod play;
mod schema;
mod tools;

use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode};
use std::time::Instant;

use super::packages::done;
use super::verify;
use files::{copied, emptied, folder_copied};
use play::Player;

/// What is asked for.
struct Wish {
    /// Whether the examples of the keys are held against the program too.
    test: bool,
    /// Whether lines that take minutes are run too.
    all: bool,
    program: Option<PathBuf>,
}

/// Builds the book and checks its commands and links.
pub(crate) fn run(root: &Path, words: &[String]) -> ExitCode {
    let wish = match wish(words) {
        Ok(wish) => wish,
        Err(message) => {
            eprintln!("book: {message}");
            return ExitCode::from(2);
        }
    };
    match build(root, &wish) {
        Ok(words) => {
            println!("book: {words}: target/book/index.html");
            ExitCode::SUCCESS
        }
        Err(message) => {
            eprintln!("book: {message}");
            ExitCode::FAILURE
        }
    }
}

fn wish(words: &[String]) -> Result<Wish, String> {
    let mut wish = Wish { test: false, all: false, program: None };
    let mut words = words.iter();
    while let Some(word) = words.next() {
        match word.as_str() {
            "--test" => wish.test = true,
            "--all" => wish.all = true,
            "--program" => wish.program = Some(words.next().ok_or("--program needs a path")?.into()),
            _ => return Err(format!("takes --test, --all, --program PATH, not `{word}`")),
        }
    }
    Ok(wish)
}

fn build(root: &Path, wish: &Wish) -> Result<String, String> {
    let start = Instant::now();
    let tools = tools::installed(root)?;
    let program = match &wish.program {
        Some(program) => root.join(program),
        None => verify::programs::build(root)?,
    };
    let began = told("tools and program", start);
    let stage = root.join("target/book-sources");
    emptied(&stage)?;
    let player = Player { root, program: &program, runs: &stage.join("runs"), all: wish.all };
    let book = pages::written(&player, &stage.join("src"))?;
    let began = told("commands, outputs and pictures", began);
    let checked = if wish.test { examples::checked(&player)? } else { 0 };
    let began = if wish.test { told("examples of keys", began) } else { began };
    for file in ["book.toml", "book.css"] {
        copied(&root.join("book").join(file), &stage.join(file))?;
    }
    let target = root.join("target/book");
    done(Command::new(&tools.mdbook).arg("build").arg("--dest-dir").arg(&target).arg(&stage))?;
    let web = root.join("target/web");
    if web.join("index.html").exists() {
        folder_copied(&web, &target.join("web"))?;
    }
    done(Command::new(&tools.links).arg("--check-anchors").arg(&target))?;
    told("pages and links", began);
    let examples = if wish.test { format!(", {checked} examples of keys") } else { String::new() };
    Ok(format!("{} pages, {} commands{examples}, no dead link", book.pages, book.commands))
}

/// Prints the seconds of a part and begins the next.
fn told(part: &str, began: Instant) -> Instant {
    println!("{:4.0} s  {part}", began.elapsed().as_secs_f64());
    Instant::now()
}
