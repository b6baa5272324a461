//! `wearshape report`: the page of a folder, built again from its files. The folder may be anybody's.

use std::cell::RefCell;
use std::fs::{self, File};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use scene::{Fault, Place};

use crate::args::ReportArgs;
use crate::bounded;
use crate::commands::sweep;
use crate::exit::Exit;
use crate::print::talk;
use crate::record::{RUN_MCAP, Replay};

/// Rebuilds report.html.
pub(crate) fn run(args: &ReportArgs) -> Result<Exit, Fault> {
    let folder = &args.folder;
    let here = |fault: Fault| Fault { place: Some(Place::Flag(folder.display().to_string())), ..fault };
    let unread = RefCell::new(None);
    let read = |name: &str| {
        let path = plain(folder, name)?;
        bounded::result(&path).map_err(|why| unread.replace(Some(format!("cannot read {}: {why}", path.display())))).ok()
    };
    let there = |name: &str| plain(folder, name).is_some_and(|path| path.is_file());
    let page = match sweep::page_again(folder, &read, &there) {
        Some(page) => Ok(page),
        None => {
            let running_in = read(RUN_MCAP).map(|bytes| Replay::read(&bytes).running_in());
            report::page(&read, running_in.as_ref())
                .map_err(|fault| here(Fault { message: format!("{}: {}", folder.display(), fault.message), ..fault }))
        }
    };
    if let Some(message) = unread.into_inner() {
        let remedy = "take it out of the folder, or run the scene again";
        return Err(here(Fault::new("unreadable", message, remedy)));
    }
    let page = page?;
    let path = folder.join("report.html");
    replace(folder, &path, &page).map_err(|error| {
        let message = format!("cannot write {}: {error}", path.display());
        here(Fault::new("unwritable", message, "give a folder that can be written"))
    })?;
    talk(&format!("{} written", path.display()));
    Ok(Exit::Done)
}

/// The path of what is in a folder if it is really there: no link on the way leads out of the folder.
fn plain(folder: &Path, name: &str) -> Option<PathBuf> {
    let mut path = folder.to_path_buf();
    for part in name.split('/') {
        if matches!(part, "" | "." | "..") {
            return None;
        }
        path.push(part);
        if fs::symlink_metadata(&path).ok()?.is_symlink() {
            return None;
        }
    }
    Some(path)
}

/// Puts a page in the place of the one that is there; where that is a link, the link goes and what it leads to stays.
fn replace(folder: &Path, path: &Path, page: &str) -> io::Result<()> {
    let new = folder.join(format!(".report.html.new-{}", std::process::id()));
    // Nothing that is there already is written to.
    let written =
        File::create_new(&new).and_then(|mut file| file.write_all(page.as_bytes())).and_then(|()| fs::rename(&new, path));
    if written.is_err() {
        let _ = fs::remove_file(&new);
    }
    written
}
