//! `wearshape report`: the page of a folder, built again from its files.

use scene::{Fault, Place};

use crate::args::ReportArgs;
use crate::exit::Exit;
use crate::print::talk;
use crate::record::{RUN_MCAP, Replay};

/// Rebuilds report.html.
pub(crate) fn run(args: &ReportArgs) -> Result<Exit, Fault> {
    let read = |name: &str| std::fs::read(args.folder.join(name)).ok();
    let running_in = read(RUN_MCAP).map(|bytes| Replay::read(&bytes).running_in());
    let page = report::page(&read, running_in.as_ref()).map_err(|fault| Fault {
        message: format!("{}: {}", args.folder.display(), fault.message),
        place: Some(Place::Flag(args.folder.display().to_string())),
        ..fault
    })?;
    let path = args.folder.join("report.html");
    std::fs::write(&path, page).map_err(|error| Fault {
        place: Some(Place::Flag(args.folder.display().to_string())),
        ..Fault::new("unwritable", format!("cannot write {}: {error}", path.display()), "give a folder that can be written")
    })?;
    talk(&format!("{} written", path.display()));
    Ok(Exit::Done)
}
