//! `wearshape reproduce`: the paper's figures and tables.

use std::path::{Path, PathBuf};
use std::time::Instant;

use report::SCHEMA_VERSION;
use scene::{Fault, Place, did_you_mean};
use serde_json::{Value, json};

use crate::again::again;
use crate::args::{Common, Points, ReproduceArgs};
use crate::exit::Exit;
use crate::folder::Folder;
use crate::interrupt;
use crate::options::threads;
use crate::print::{print_json, print_out, talk};
use crate::progress::Progress;
use crate::reproduce::{ITEMS, Item, Made, Row, page, rows_csv, rows_json, rows_table};

/// Computes one item or all of them, or lists them.
pub(crate) fn run(args: &ReproduceArgs) -> Result<Exit, Fault> {
    let name = match &args.item {
        Some(name) if !args.list => name.as_str(),
        _ => {
            list(args.json);
            return Ok(Exit::Done);
        }
    };
    let root = PathBuf::from("out").join("reproduce");
    let outcome = threads(args.threads)?.install(|| {
        if name == "all" {
            every(args, &args.output.clone().unwrap_or(root))
        } else {
            single(args, find(name)?, &args.output.clone().unwrap_or_else(|| root.join(name)))
        }
    });
    // A run that Ctrl-C has cut short is a fault of its item; nothing is wrong with it.
    if outcome.is_err() && interrupt::asked() {
        let kept = if name == "all" { "items that are finished keep their folders; " } else { "" };
        talk(&format!("interrupted; {kept}{}", again(&["reproduce", name], (&common(args), &Points::default()), None)));
        return Ok(Exit::Interrupted);
    }
    outcome
}

/// One item.
fn single(args: &ReproduceArgs, item: &Item, target: &Path) -> Result<Exit, Fault> {
    interrupt::listen();
    let progress = busy(args);
    progress.say(item.name);
    let (made, document) = compute(item, target)?;
    progress.end();
    if args.json {
        print_json(&document);
    } else if !args.quiet {
        print_out(&screen(item, &made));
        print_out(&format!("files     {}\n", target.display()));
    }
    Ok(Exit::Done)
}

/// Every item, in a folder each, and the index of all.
fn every(args: &ReproduceArgs, root: &Path) -> Result<Exit, Fault> {
    interrupt::listen();
    let mut all = Vec::new();
    let mut documents = Vec::new();
    let progress = busy(args);
    for item in ITEMS {
        progress.say(item.name);
        let start = Instant::now();
        let (made, document) = compute(item, &root.join(item.name))?;
        if !args.json && !args.quiet {
            let seconds = start.elapsed().as_secs_f64();
            progress.beside(|| talk(&format!("{:<9} {seconds:6.2} s  {}", item.name, item.sentence)));
        }
        documents.push(document);
        all.push((item, made));
    }
    progress.end();
    let document = index(&all, documents, &root.join("index"))?;
    if args.json {
        print_json(&document);
    } else if !args.quiet {
        for (item, made) in &all {
            print_out(&format!("{}\n", screen(item, made)));
        }
        print_out(&format!("files     {} (all rows in index/rows.csv, the page in index/validation.md)\n", root.display()));
    }
    Ok(Exit::Done)
}

/// The options that other commands have too.
fn common(args: &ReproduceArgs) -> Common {
    let ReproduceArgs { item: _, output, list: _, threads, json, quiet } = args;
    Common { output: output.clone(), threads: *threads, json: *json, quiet: *quiet, ..Common::default() }
}

/// A line that says which item is computed.
fn busy(args: &ReproduceArgs) -> Progress {
    Progress::new(&common(args))
}

fn list(json: bool) {
    if json {
        let items: Vec<Value> = ITEMS.iter().map(|item| json!({ "item": item.name, "shows": item.sentence })).collect();
        print_json(&json!({ "items": items }));
        return;
    }
    let mut text = String::new();
    for item in ITEMS {
        text += &format!("{:<9} {}\n", item.name, item.sentence);
    }
    print_out(&(text + "all       Every item, an index of all rows, and the validation page\n"));
}

fn find(name: &str) -> Result<&'static Item, Fault> {
    let names: Vec<&str> = ITEMS.iter().map(|item| item.name).chain(["all"]).collect();
    ITEMS.iter().find(|item| item.name == name).ok_or_else(|| Fault {
        place: Some(Place::Flag(format!("reproduce {name}"))),
        ..Fault::new("no-item", format!("`{name}` is no figure or table that can be reproduced"), did_you_mean(name, &names))
    })
}

/// Computes an item and writes its folder.
fn compute(item: &Item, target: &Path) -> Result<(Made, Value), Fault> {
    Folder::check(target)?;
    let made = (item.make)()?;
    let folder = Folder::begin(target, &made.resolved, false)?;
    for file in &made.files {
        folder.write(&file.name, &file.text)?;
    }
    let rows: Vec<(&str, &Row)> = made.rows.iter().map(|row| (item.name, row)).collect();
    folder.write("rows.csv", &rows_csv(&rows))?;
    folder.write("commands.txt", &(made.commands.join("\n") + "\n"))?;
    let document = json!({
        "schema_version": SCHEMA_VERSION,
        "version": env!("CARGO_PKG_VERSION"),
        "scene_sha256": scene::sha256(&made.resolved),
        "item": item.name,
        "shows": item.sentence,
        "rows": rows_json(&made.rows),
        "remarks": made.remarks,
        "commands": made.commands,
        "files": made.files.iter().map(|file| file.name.clone()).collect::<Vec<_>>(),
    });
    let document = folder.finish(&document)?;
    Ok((made, document))
}

/// Writes the rows of all items and the page.
fn index(all: &[(&Item, Made)], documents: Vec<Value>, target: &Path) -> Result<Value, Fault> {
    let folder = Folder::begin(target, "# The index has no scene of its own.\n", false)?;
    let rows: Vec<(&str, &Row)> = all.iter().flat_map(|(item, made)| made.rows.iter().map(|row| (item.name, row))).collect();
    folder.write("rows.csv", &rows_csv(&rows))?;
    let named: Vec<(&str, &Made)> = all.iter().map(|(item, made)| (item.name, made)).collect();
    for (name, text) in page(&named) {
        folder.write(&name, &text)?;
    }
    let document = json!({
        "schema_version": SCHEMA_VERSION,
        "version": env!("CARGO_PKG_VERSION"),
        "scene_sha256": scene::sha256(""),
        "items": documents,
    });
    folder.finish(&document)
}

fn screen(item: &Item, made: &Made) -> String {
    let mut out = format!("{}: {}\n\n{}", item.name, item.sentence, rows_table(&made.rows));
    for remark in &made.remarks {
        out += &format!("\n{remark}\n");
    }
    out
}
