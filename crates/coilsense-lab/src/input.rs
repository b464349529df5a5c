//! Which files a command has read, so that none of them is overwritten by what it writes.
//!
//! Next door: what is read (`spec`, `recording`, `stored`, `sweep`), what is written (`output`).

use std::fs::{self, File};
use std::io;
use std::path::Path;
use std::sync::{Mutex, PoisonError};

/// What tells a file from all others, by whatever name or link it is called.
#[cfg(unix)]
type Identity = (u64, u64);
#[cfg(not(unix))]
type Identity = std::path::PathBuf;

/// The files that were read, where somebody wants to know.
static READ: Mutex<Option<Vec<Identity>>> = Mutex::new(None);

/// From here on, what is read is remembered until the process ends: for a process that runs one command.
pub fn remember() {
    READ.lock().unwrap_or_else(PoisonError::into_inner).get_or_insert_default();
}

/// Opens a file to be read.
///
/// # Errors
/// What the system says.
pub(crate) fn open(path: &Path) -> io::Result<File> {
    let file = File::open(path)?;
    note(path);
    Ok(file)
}

/// Remembers a file that others open.
pub fn note(path: &Path) {
    if let (Some(read), Some(identity)) = (READ.lock().unwrap_or_else(PoisonError::into_inner).as_mut(), identity(path))
    {
        read.push(identity);
    }
}

/// Whether a file was read.
pub(crate) fn is_one(path: &Path) -> bool {
    let read = READ.lock().unwrap_or_else(PoisonError::into_inner);
    let Some(read) = read.as_ref() else { return false };
    identity(path).is_some_and(|identity| read.contains(&identity))
}

/// Whether two names are of one file.
pub(crate) fn is_same(one: &Path, other: &Path) -> bool {
    identity(one).is_some_and(|one| identity(other) == Some(one))
}

#[cfg(unix)]
fn identity(path: &Path) -> Option<Identity> {
    use std::os::unix::fs::MetadataExt;
    fs::metadata(path).ok().map(|file| (file.dev(), file.ino()))
}

#[cfg(not(unix))]
fn identity(path: &Path) -> Option<Identity> {
    fs::canonicalize(path).ok()
}
