//! What must be on the disk before it counts.

use std::collections::BTreeSet;
use std::fs::File;
use std::io;
use std::path::Path;
use std::time::Duration;

/// Files that grow during a run are handed to the disk this often: a loss of power takes no more than the work of this time.
pub(crate) const INTERVAL: Duration = Duration::from_secs(10);

/// Waits until some files of a folder, and the folders they stand in, are on the disk.
pub(super) fn folder(folder: &Path, names: &BTreeSet<String>) -> io::Result<()> {
    let mut folders = BTreeSet::from([folder.to_path_buf()]);
    for name in names {
        let path = folder.join(name);
        match File::open(&path) {
            Err(error) if error.kind() == io::ErrorKind::NotFound => continue,
            opened => opened?.sync_all()?,
        }
        folders.extend(path.ancestors().skip(1).take_while(|inner| *inner != folder).map(Path::to_path_buf));
    }
    folders.iter().rev().try_for_each(|folder| names_in(folder))
}

/// Waits until the name of a folder is on the disk.
pub(super) fn parent(folder: &Path) -> io::Result<()> {
    match folder.parent().filter(|parent| !parent.as_os_str().is_empty()) {
        Some(parent) => names_in(parent),
        None => names_in(Path::new(".")),
    }
}

/// Waits until the names in a folder are on the disk.
#[cfg(unix)]
fn names_in(folder: &Path) -> io::Result<()> {
    match File::open(folder)?.sync_all() {
        // Some file systems have nothing to do here, and say so.
        Err(error) if matches!(error.kind(), io::ErrorKind::InvalidInput | io::ErrorKind::Unsupported) => Ok(()),
        synced => synced,
    }
}

/// Folders cannot be opened as files here.
#[cfg(not(unix))]
fn names_in(_: &Path) -> io::Result<()> {
    Ok(())
}
