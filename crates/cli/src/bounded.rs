//! Reading a file whole, up to a size beyond which it is refused by name.

use std::fs::{self, File};
use std::io::Read;
use std::path::Path;

/// The largest file of results that is read whole, bytes: a table of a million points is half of it.
const LARGEST_RESULT: u64 = 1_000_000_000;

/// The bytes of a file, or of a pipe up to its end; at most so many.
pub(crate) fn whole(path: &Path, largest: u64) -> Result<Vec<u8>, String> {
    let mut bytes = Vec::new();
    let read = File::open(path).and_then(|file| file.take(largest + 1).read_to_end(&mut bytes));
    match read {
        Err(error) => Err(error.to_string()),
        Ok(length) if length as u64 > largest => Err(too_large(largest)),
        Ok(_) => Ok(bytes),
    }
}

/// The bytes of a file and of nothing else: a pipe may never end, and is read but once.
pub(crate) fn file(path: &Path, largest: u64) -> Result<Vec<u8>, String> {
    let data = fs::metadata(path).map_err(|error| error.to_string())?;
    match (data.is_file(), data.is_dir()) {
        (true, _) if data.len() > largest => Err(too_large(largest)),
        (true, _) => whole(path, largest),
        (_, true) => Err("it is a folder".into()),
        _ => Err("it is a pipe or a device, not a file".into()),
    }
}

/// The bytes of a file of results.
pub(crate) fn result(path: &Path) -> Result<Vec<u8>, String> {
    file(path, LARGEST_RESULT)
}

/// The text of a file of results.
pub(crate) fn result_text(path: &Path) -> Result<String, String> {
    String::from_utf8(result(path)?).map_err(|_| "it is not UTF-8 text".into())
}

fn too_large(largest: u64) -> String {
    format!("it is larger than {} MB, the largest that is read", largest / 1_000_000)
}
