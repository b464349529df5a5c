//! Files take their places: each by a rename over the old one, all of them or none, and a run that is killed in between is completed by the next.
//!
//! Before the first rename a journal stands in the staging folder, on disk: from then on all new files will take their places. What was there is
//! linked into the same folder, so that a rename that fails is undone.
//!
//! Next door: what takes which place (the parent), who finds a killed run's folder (`staging`).

use std::collections::BTreeSet;
use std::fs::{self, File};
use std::io::{self, ErrorKind, Write};
use std::path::{Component, Path, PathBuf};

use serde::{Deserialize, Serialize};

use super::written::digest;

/// Where in a staging folder files are made.
pub(super) const NEW: &str = "new";
/// Where in it what was there before is.
const OLD: &str = "old";
const JOURNAL: &str = "journal";

/// What is about to happen to a folder.
#[derive(Debug, Serialize, Deserialize)]
struct Journal {
    way: Way,
    /// Files that take their places.
    new: Vec<PathBuf>,
    /// Files of an earlier run that leave.
    removed: Vec<PathBuf>,
    /// Those of both that were there.
    kept: Vec<PathBuf>,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
enum Way {
    /// To what is new.
    Forward,
    /// To what was there, since something new could not take its place.
    Back,
}

/// Gives all new files of a staging folder their places in `target`, and removes others. What fails is undone.
///
/// # Errors
/// The file that could not take its place, and what the system says.
pub(super) fn run(
    staging: &Path,
    target: &Path,
    new: &[PathBuf],
    removed: &[PathBuf],
) -> Result<(), (PathBuf, io::Error)> {
    let mut journal = Journal { way: Way::Forward, new: new.to_owned(), removed: removed.to_owned(), kept: Vec::new() };
    for file in new.iter().chain(removed).filter(|file| is_there(&target.join(file))) {
        link(target, staging, file).map_err(|error| (file.clone(), error))?;
        journal.kept.push(file.clone());
    }
    let begun = sync_below(&staging.join(OLD)).and_then(|()| journal.write(staging));
    begun.map_err(|error| (PathBuf::new(), error))?;
    if let Err(failed) = journal.forward(staging, target) {
        journal.way = Way::Back;
        // Nothing better can be done where that fails, too; the next run tries it again.
        let _ = journal.write(staging).and_then(|()| journal.back(staging, target)).and_then(|()| forget(staging));
        return Err(failed);
    }
    // A journal that stays is of files that have their places.
    let _ = forget(staging);
    Ok(())
}

/// Brings to its end what a killed run had begun to do to `target`, the folder that its staging folder lies in.
///
/// # Errors
/// What the system says; and for a journal that none of us wrote, of which nothing is done.
pub(super) fn complete(staging: &Path, target: &Path) -> io::Result<()> {
    let text = match fs::read_to_string(staging.join(JOURNAL)) {
        Err(error) if error.kind() == ErrorKind::NotFound => return Ok(()),
        text => text?,
    };
    let journal: Journal = serde_json::from_str(&text)?;
    let mut files = journal.new.iter().chain(&journal.removed);
    if !files.all(|file| file.components().all(|part| matches!(part, Component::Normal(_)))) {
        return Err(ErrorKind::InvalidData.into());
    }
    match journal.way {
        Way::Forward => journal.complete(staging, target)?,
        Way::Back => journal.back(staging, target)?,
    }
    forget(staging)
}

impl Journal {
    /// To disk, in one piece.
    fn write(&self, staging: &Path) -> io::Result<()> {
        let unfinished = staging.join("journal.part");
        let mut file = File::create(&unfinished)?;
        file.write_all(&serde_json::to_vec(self)?)?;
        file.sync_all()?;
        step()?;
        fs::rename(&unfinished, staging.join(JOURNAL))?;
        sync_folder(staging)
    }

    fn forward(&self, staging: &Path, target: &Path) -> Result<(), (PathBuf, io::Error)> {
        for file in &self.new {
            place(staging, target, file).map_err(|error| (file.clone(), error))?;
        }
        for file in &self.removed {
            remove(&target.join(file)).map_err(|error| (file.clone(), error))?;
        }
        self.sync(target).map_err(|error| (PathBuf::new(), error))
    }

    /// The same of what is left to do. What somebody else has changed since then stays as it is.
    fn complete(&self, staging: &Path, target: &Path) -> io::Result<()> {
        let is_as_it_was = |file: &Path| is_same(&target.join(file), &staging.join(OLD).join(file));
        for file in self.new.iter().filter(|file| is_there(&staging.join(NEW).join(file))) {
            if is_as_it_was(file)? {
                place(staging, target, file)?;
            }
        }
        for file in self.removed.iter().filter(|file| is_there(&staging.join(OLD).join(file))) {
            if is_as_it_was(file)? {
                remove(&target.join(file))?;
            }
        }
        self.sync(target)
    }

    fn back(&self, staging: &Path, target: &Path) -> io::Result<()> {
        for file in self.new.iter().chain(&self.removed).rev() {
            let (old, new, last) = (staging.join(OLD).join(file), staging.join(NEW).join(file), target.join(file));
            step()?;
            if self.kept.contains(file) {
                // Unless it is back already.
                if is_there(&old) {
                    fs::rename(&old, &last)?;
                }
            } else if !is_there(&new) && is_there(&last) {
                fs::rename(&last, &new)?;
            }
        }
        self.sync(target)
    }

    /// All folders in which something has changed.
    fn sync(&self, target: &Path) -> io::Result<()> {
        let below = |file: &PathBuf| file.ancestors().skip(1).map(|folder| target.join(folder)).collect::<Vec<_>>();
        let folders: BTreeSet<PathBuf> = self.new.iter().chain(&self.removed).flat_map(below).collect();
        folders.iter().filter(|folder| folder.is_dir()).try_for_each(|folder| sync_folder(folder))
    }
}

/// A second name for what is there, so that it can come back.
fn link(target: &Path, staging: &Path, file: &Path) -> io::Result<()> {
    let (last, old) = (target.join(file), staging.join(OLD).join(file));
    step()?;
    old.parent().map_or(Ok(()), fs::create_dir_all)?;
    if fs::hard_link(&last, &old).is_err() {
        // Not every file system has them.
        fs::copy(&last, &old)?;
        File::open(&old)?.sync_all()?;
    }
    Ok(())
}

fn place(staging: &Path, target: &Path, file: &Path) -> io::Result<()> {
    let last = target.join(file);
    last.parent().map_or(Ok(()), fs::create_dir_all)?;
    step()?;
    fs::rename(staging.join(NEW).join(file), last)
}

fn remove(last: &Path) -> io::Result<()> {
    step()?;
    match fs::remove_file(last) {
        Err(error) if error.kind() == ErrorKind::NotFound => Ok(()),
        removed => removed,
    }
}

fn forget(staging: &Path) -> io::Result<()> {
    step()?;
    fs::remove_file(staging.join(JOURNAL))?;
    sync_folder(staging)
}

/// Whether files of a staging folder have begun to take their places, and neither all have nor none.
pub(super) fn is_begun(staging: &Path) -> bool {
    is_there(&staging.join(JOURNAL))
}

/// Whether there is anything of this name, a link that leads nowhere included.
pub(super) fn is_there(path: &Path) -> bool {
    fs::symlink_metadata(path).is_ok()
}

/// Whether two names are of the same file, or both of none; a copy counts as the file.
fn is_same(one: &Path, other: &Path) -> io::Result<bool> {
    match (is_there(one), is_there(other)) {
        (true, true) => Ok(crate::input::is_same(one, other) || digest(one)? == digest(other)?),
        (one, other) => Ok(one == other),
    }
}

/// A folder's names to disk, and those of all folders in it.
pub(super) fn sync_below(folder: &Path) -> io::Result<()> {
    if !folder.is_dir() {
        return Ok(());
    }
    for entry in fs::read_dir(folder)? {
        let entry = entry?;
        if entry.file_type()?.is_dir() {
            sync_below(&entry.path())?;
        }
    }
    sync_folder(folder)
}

/// A folder's names to disk, where the system can.
pub(super) fn sync_folder(folder: &Path) -> io::Result<()> {
    if !cfg!(unix) {
        return Ok(());
    }
    match File::open(folder).and_then(|folder| folder.sync_all()) {
        // A folder that may be written but not read, and file systems that have nothing to sync.
        Err(error) if matches!(error.kind(), ErrorKind::PermissionDenied | ErrorKind::InvalidInput) => Ok(()),
        Err(error) if error.kind() == ErrorKind::Unsupported => Ok(()),
        synced => synced,
    }
}

/// Passed before each change on disk, so that tests can end a run there.
#[cfg(not(test))]
#[expect(clippy::unnecessary_wraps, reason = "the tests' own fails")]
fn step() -> io::Result<()> {
    Ok(())
}
#[cfg(test)]
use tests::step;

#[cfg(test)]
mod tests;
