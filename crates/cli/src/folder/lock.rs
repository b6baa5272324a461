//! One call at a time writes a folder.

use std::fs::{self, File};
use std::io;
use std::path::Path;

/// Held as long as it lives; none where the file system has no locks.
#[derive(Debug)]
pub(super) struct Lock(#[expect(dead_code, reason = "the lock goes with the file")] Option<File>);

/// Makes a folder if it is not there, and holds it. `WouldBlock` if another process does.
#[cfg(unix)]
pub(super) fn lock(folder: &Path) -> io::Result<Lock> {
    use std::fs::TryLockError;
    use std::os::unix::fs::MetadataExt;

    loop {
        fs::create_dir_all(folder)?;
        let file = match File::open(folder) {
            Err(error) if error.kind() == io::ErrorKind::NotFound => continue,
            opened => opened?,
        };
        match file.try_lock() {
            Ok(()) => {}
            Err(TryLockError::WouldBlock) => return Err(io::ErrorKind::WouldBlock.into()),
            Err(TryLockError::Error(_)) => return Ok(Lock(None)),
        }
        // Who held it may have put it elsewhere before it was free: then it is not the folder of this name any more.
        let held = file.metadata()?;
        if fs::metadata(folder).is_ok_and(|there| (there.dev(), there.ino()) == (held.dev(), held.ino())) {
            return Ok(Lock(Some(file)));
        }
    }
}

/// Folders cannot be locked here.
#[cfg(not(unix))]
pub(super) fn lock(folder: &Path) -> io::Result<Lock> {
    fs::create_dir_all(folder)?;
    Ok(Lock(None))
}
