//! What must be on the disk before it counts.

use std::collections::BTreeSet;
use std::fs::File;
use std::io;
use std::path::{Path, PathBuf};
use std::time::Duration;

/// Files that grow during a run are handed to the disk this often: a loss of power takes no more than the work of this time.
pub(crate) const INTERVAL: Duration = Duration::from_secs(10);

/// Files that are waited for at once.
const AT_ONCE: usize = 16;

/// Waits until some files of a folder, and the folders they stand in, are on the disk.
pub(super) fn folder(folder: &Path, names: &BTreeSet<String>) -> io::Result<()> {
    let paths: Vec<PathBuf> = names.iter().map(|name| folder.join(name)).collect();
    let inside = paths.iter().flat_map(|path| path.ancestors().skip(1).take_while(|inner| *inner != folder));
    let folders: BTreeSet<&Path> = inside.filter(|inner| inner.is_dir()).chain([folder]).collect();
    // Disks and file systems take many at once in about the time of one.
    let share = paths.len().div_ceil(AT_ONCE).max(1);
    std::thread::scope(|scope| {
        let waiting: Vec<_> =
            paths.chunks(share).map(|paths| scope.spawn(|| paths.iter().try_for_each(|path| file(path)))).collect();
        waiting.into_iter().try_for_each(|thread| thread.join().unwrap_or_else(|_| Err(io::Error::other("a thread has ended"))))
    })?;
    folders.iter().rev().try_for_each(|folder| names_in(folder))
}

/// Waits until a file is on the disk, if it is there.
fn file(path: &Path) -> io::Result<()> {
    match File::open(path) {
        Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(()),
        opened => opened?.sync_all(),
    }
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
