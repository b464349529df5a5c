//! The folder in which files are made before they take their places, who owns it, and what a killed run left of one.
//!
//! Next door: what is made in it (the parent), how files leave it (`commit`).

use std::fs::{self, File, TryLockError};
use std::io::{self, ErrorKind};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Mutex, MutexGuard, PoisonError};

use super::commit::{self, NEW};

/// How the names of all such folders begin; the process and a number follow.
const PREFIX: &str = ".coilsense-";
/// The file in it that its process holds locked for as long as it lives.
const LOCK: &str = "lock";

/// How many folders this process has named.
static NAMED: AtomicU64 = AtomicU64::new(0);

/// The folders of this process. Who holds it keeps files from taking their places meanwhile.
static OURS: Mutex<Vec<PathBuf>> = Mutex::new(Vec::new());

/// Holds off commits, and those who end the process in the middle of one.
pub(super) fn gate() -> MutexGuard<'static, Vec<PathBuf>> {
    // A thread that panicked while it held the list left it whole.
    OURS.lock().unwrap_or_else(PoisonError::into_inner)
}

/// For a process that is about to end by a signal: waits until files that are taking their places have done so, then removes all folders under
/// construction. Nothing is written by this process from then on: whoever tries waits for its end.
pub fn abandon() {
    let ours = gate();
    for folder in ours.iter() {
        // Another thread may still be writing into it.
        for _ in 0..5 {
            if commit::is_begun(folder) {
                break;
            }
            match empty(folder).and_then(|()| remove(folder)) {
                Err(error) if error.kind() != ErrorKind::NotFound => std::thread::yield_now(),
                _ => break,
            }
        }
    }
    std::mem::forget(ours);
}

/// A folder under construction, removed when it is dropped, by [`abandon`], or by the next run.
#[derive(Debug)]
pub struct Staging {
    path: PathBuf,
    lock: Option<File>,
}

impl Staging {
    /// A new one inside a folder that exists. What killed runs left there and in the folders above is completed or removed.
    ///
    /// # Errors
    /// What the system says where nothing can be made there.
    pub fn within(host: &Path) -> io::Result<Self> {
        let staging = Self::make(host)?;
        for folder in host.ancestors() {
            staging.clear_up(folder);
        }
        Ok(staging)
    }

    fn make(host: &Path) -> io::Result<Self> {
        loop {
            let number = NAMED.fetch_add(1, Ordering::Relaxed);
            let path = host.join(format!("{PREFIX}{}-{number}", std::process::id()));
            let mut ours = gate();
            match private_folder(&path) {
                Err(error) if error.kind() == ErrorKind::AlreadyExists => continue,
                made => made?,
            }
            ours.push(path.clone());
            drop(ours);
            let mut staging = Self { path, lock: None };
            // Another run may take a folder without a lock for one that was left, and remove it: then there is a next one.
            let lock = match File::create_new(staging.path.join(LOCK)) {
                Err(error) if error.kind() == ErrorKind::NotFound => continue,
                lock => lock?,
            };
            match lock.try_lock() {
                Err(TryLockError::WouldBlock) => continue,
                // Where the file system knows no locks, nothing is ever taken for left either.
                Ok(()) | Err(TryLockError::Error(_)) if staging.path.join(LOCK).exists() => (),
                _ => continue,
            }
            staging.lock = Some(lock);
            fs::create_dir(staging.path.join(NEW))?;
            return Ok(staging);
        }
    }

    /// Where it is.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Moves it into another folder of the same file system.
    pub(super) fn move_into(&mut self, host: &Path, ours: &mut Vec<PathBuf>) -> io::Result<()> {
        let path = host.join(self.path.file_name().unwrap_or_default());
        fs::rename(&self.path, &path)?;
        ours.retain(|folder| *folder != self.path);
        ours.push(path.clone());
        self.path = path;
        Ok(())
    }

    /// As if the process were killed: its lock is let go, and the folder stays.
    #[cfg(test)]
    pub(super) fn lose(mut self) {
        self.lock = None;
        gate().retain(|folder| *folder != self.path);
        std::mem::forget(self);
    }

    /// Completes or removes what killed runs of the same user left in a folder.
    pub(super) fn clear_up(&self, folder: &Path) {
        let Ok(entries) = fs::read_dir(folder) else { return };
        for entry in entries.flatten() {
            let is_one = entry.file_name().to_str().is_some_and(is_name);
            if is_one && entry.path() != self.path && self.is_of_same_user(&entry) {
                // What cannot be cleared up now is left to another run.
                let _ = clear_one(&entry.path(), folder);
            }
        }
    }

    #[cfg(unix)]
    fn is_of_same_user(&self, entry: &fs::DirEntry) -> bool {
        use std::os::unix::fs::MetadataExt;
        let owner = |found: io::Result<fs::Metadata>| found.ok().filter(fs::Metadata::is_dir).map(|found| found.uid());
        let theirs = owner(entry.metadata());
        theirs.is_some() && theirs == owner(fs::symlink_metadata(&self.path))
    }

    #[cfg(not(unix))]
    fn is_of_same_user(&self, entry: &fs::DirEntry) -> bool {
        entry.metadata().is_ok_and(|found| found.is_dir())
    }
}

/// Whether a folder is called as these are.
fn is_name(name: &str) -> bool {
    let numbers = name.strip_prefix(PREFIX).and_then(|numbers| numbers.split_once('-'));
    let is_number = |text: &str| !text.is_empty() && text.bytes().all(|sign| sign.is_ascii_digit());
    numbers.is_some_and(|(process, number)| is_number(process) && is_number(number))
}

impl Drop for Staging {
    fn drop(&mut self) {
        let mut ours = gate();
        // What could not be undone is there for the next run to undo.
        if !commit::is_begun(&self.path) {
            let emptied = empty(&self.path);
            // Some systems remove no file that is open.
            self.lock = None;
            let _ = emptied.and_then(|()| remove(&self.path));
        }
        ours.retain(|folder| *folder != self.path);
    }
}

/// What a killed run left: its files take their places where it had begun to give them theirs, then it is removed. A folder whose process lives
/// is left alone, and so is one that is not made as these are.
fn clear_one(left: &Path, folder: &Path) -> io::Result<()> {
    let lock = match File::options().write(true).open(left.join(LOCK)) {
        // Killed before there was a lock: then there is nothing else.
        Err(error) if error.kind() == ErrorKind::NotFound => return fs::remove_dir(left),
        lock => lock?,
    };
    if lock.try_lock().is_err() {
        return Ok(());
    }
    let _gate = gate();
    commit::complete(left, folder)?;
    empty(left)?;
    drop(lock);
    remove(left)
}

/// Removes all that is in a staging folder but its lock: a folder without one is empty, wherever a run is killed.
fn empty(folder: &Path) -> io::Result<()> {
    for entry in fs::read_dir(folder)? {
        let entry = entry?;
        match entry.file_type()?.is_dir() {
            true => fs::remove_dir_all(entry.path())?,
            false if entry.file_name() == LOCK => (),
            false => fs::remove_file(entry.path())?,
        }
    }
    Ok(())
}

/// Removes a staging folder of which only the lock is left.
fn remove(folder: &Path) -> io::Result<()> {
    match fs::remove_file(folder.join(LOCK)) {
        Err(error) if error.kind() != ErrorKind::NotFound => Err(error),
        _ => fs::remove_dir(folder),
    }
}

/// A folder that nobody else can look into.
fn private_folder(path: &Path) -> io::Result<()> {
    #[cfg_attr(not(unix), expect(unused_mut, reason = "only Unix has modes"))]
    let mut builder = fs::DirBuilder::new();
    #[cfg(unix)]
    {
        use std::os::unix::fs::DirBuilderExt;
        builder.mode(0o700);
    }
    builder.create(path)
}
