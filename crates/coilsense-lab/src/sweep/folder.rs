//! The names in a sweep's folder: which chunks are there, who holds it, and how a file comes to its name.
//!
//! Next door: what the files hold (`dataset`).

use std::ffi::OsStr;
use std::fs::{self, File, TryLockError};
use std::io::{self, Write};
use std::path::Path;

use super::SweepError;

/// Held while a run writes; the system lets go of it with the process, however that ends. Readers pass over names that begin so.
const LOCK: &str = "_lock";

/// Files in the making begin so.
const UNFINISHED: &str = ".unfinished-";

/// A chunk's file.
pub(super) fn name(chunk: u64) -> String {
    format!("chunk-{chunk:06}.parquet")
}

/// The number of a chunk whose file is called so.
fn number(file: &str) -> Option<u64> {
    let number = file.strip_prefix("chunk-")?.strip_suffix(".parquet")?.parse().ok()?;
    (name(number) == file).then_some(number)
}

/// Numbers of the chunks in a folder, in order: the folder is listed once, whatever their number may be.
pub(super) fn chunks_in(folder: &Path) -> Result<Vec<u64>, SweepError> {
    let mut numbers = Vec::new();
    each(folder, |_, name| {
        numbers.extend(number(name));
        Ok(())
    })?;
    numbers.sort_unstable();
    Ok(numbers)
}

/// Removes what killed runs left.
pub(super) fn remove_unfinished(folder: &Path) -> Result<(), SweepError> {
    each(folder, |path, name| match name.starts_with(UNFINISHED) {
        true => fs::remove_file(path).map_err(|error| unwritable(path, &error)),
        false => Ok(()),
    })
}

/// Shows each name in a folder that is a text, with its path.
fn each(folder: &Path, mut visit: impl FnMut(&Path, &str) -> Result<(), SweepError>) -> Result<(), SweepError> {
    let unreadable = |error: io::Error| SweepError::new(format!("{}: cannot be read: {error}", folder.display()));
    for entry in fs::read_dir(folder).map_err(unreadable)? {
        let path = entry.map_err(unreadable)?.path();
        if let Some(name) = path.file_name().and_then(OsStr::to_str) {
            visit(&path, name)?;
        }
    }
    Ok(())
}

/// Writes a file under another name, waits until it rests on the disk, and renames it.
pub(super) fn put(folder: &Path, name: &str, bytes: &[u8]) -> Result<(), SweepError> {
    let (unfinished, path) = (folder.join(format!("{UNFINISHED}{name}")), folder.join(name));
    let write = || -> io::Result<()> {
        let mut file = File::create(&unfinished)?;
        file.write_all(bytes)?;
        file.sync_all()?;
        fs::rename(&unfinished, &path)?;
        rest(folder)
    };
    write().map_err(|error| {
        // Nothing better can be done where that fails, too: the next run removes it.
        let _ = fs::remove_file(&unfinished);
        unwritable(&path, &error)
    })
}

/// Lets a folder's names come to rest, where the system can.
fn rest(folder: &Path) -> io::Result<()> {
    if cfg!(unix) { File::open(folder)?.sync_all() } else { Ok(()) }
}

/// Holds a folder for a run.
pub(super) fn locked(folder: &Path) -> Result<File, SweepError> {
    let path = folder.join(LOCK);
    let file = File::options().create(true).truncate(false).write(true).open(&path);
    let file = file.map_err(|error| unwritable(&path, &error))?;
    match file.try_lock() {
        Ok(()) => Ok(file),
        Err(TryLockError::WouldBlock) => Err(SweepError::of(
            &shown(folder),
            "another run is writing to it; wait for its end, or take another folder",
        )),
        Err(TryLockError::Error(error)) => {
            Err(SweepError::new(format!("{}: cannot be locked: {error}", path.display())))
        }
    }
}

/// A path as messages call it.
pub(super) fn shown(path: &Path) -> String {
    path.display().to_string()
}

/// That a file cannot be written.
pub(super) fn unwritable(path: &Path, error: &io::Error) -> SweepError {
    SweepError::new(format!("{}: cannot be written: {}", path.display(), crate::system::said(error)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_the_names_that_chunks_are_given_are_chunks() {
        for chunk in [0, 7, 999_999, 1_000_000] {
            assert_eq!(number(&name(chunk)), Some(chunk));
        }
        for other in
            ["chunk-1.parquet", "chunk-000001.parquet.bak", "chunk-+00001.parquet", "chunk-0000001.parquet", "a"]
        {
            assert_eq!(number(other), None, "{other}");
        }
    }
}
