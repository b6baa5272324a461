//! `wearshape report`: the page of a folder, built again from its files.

use report::page_of_folder;
use scene::{Fault, Place};

use crate::args::ReportArgs;
use crate::exit::Exit;

/// Rebuilds report.html.
pub(crate) fn run(args: &ReportArgs) -> Result<Exit, Fault> {
    let page = page_of_folder(&args.folder)?;
    let path = args.folder.join("report.html");
    std::fs::write(&path, page).map_err(|error| Fault {
        place: Some(Place::Flag(args.folder.display().to_string())),
        ..Fault::new("unwritable", format!("cannot write {}: {error}", path.display()), "give a folder that can be written")
    })?;
    eprintln!("{} written", path.display());
    Ok(Exit::Done)
}
