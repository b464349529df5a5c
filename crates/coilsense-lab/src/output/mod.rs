//! Files on disk: all of a command's output, or none of it, and nothing that is not its own in their place.
//!
//! Next door: what is in the files (`report`), which files were read (`input`), and inside: where files are made (`staging`), how they take
//! their places (`commit`), which of those that are there are our own (`written`).

mod commit;
mod staging;
mod written;

use std::fs::{self, File};
use std::io::{self, BufWriter, ErrorKind, Write};
use std::path::{Component, Path, PathBuf};

use commit::{NEW, is_there};
use staging::gate;
pub use staging::{Staging, abandon};
pub use written::WRITTEN;
use written::{Written, digest};

use crate::message::{Hint, Message};
use crate::{input, system};

/// A folder that cannot be written.
#[derive(Debug, thiserror::Error)]
#[error("{}: {message}", path.display())]
pub struct OutputError {
    path: PathBuf,
    message: Message,
}

impl From<OutputError> for Message {
    fn from(error: OutputError) -> Self {
        Self::from(format!("{}: ", error.path.display())) + error.message
    }
}

/// A folder under construction. Nothing appears under its final name before [`Self::commit`]; dropped before that, it leaves nothing.
#[derive(Debug)]
pub struct Output {
    target: PathBuf,
    /// The folder that is there already, in which files are made.
    host: PathBuf,
    /// From there to the target.
    rest: PathBuf,
    staging: Staging,
    files: Vec<PathBuf>,
    removed: Vec<PathBuf>,
    overwrites: bool,
}

impl Output {
    /// Prepares to write the folder `target`, which may exist; its other files are left alone. What a killed run left there is completed or
    /// removed first.
    ///
    /// # Errors
    /// [`OutputError`] where `target` is a file, or where nothing can be written beside or in it.
    pub fn begin(target: &Path) -> Result<Self, OutputError> {
        if target.exists() && !target.is_dir() {
            return Err(fault(target, "is a file, a folder is needed"));
        }
        // The staging folder must share the target's file system, for renames to be whole: the target itself, or its nearest ancestor.
        let absolute = std::path::absolute(target).map_err(|error| unwritable(target, &error))?;
        let host = absolute.ancestors().find(|folder| folder.exists()).unwrap_or(Path::new("/"));
        let rest = absolute.strip_prefix(host).unwrap_or(Path::new(""));
        if !rest.components().all(|part| matches!(part, Component::Normal(_))) {
            return Err(fault(target, "goes up from a folder that is not there"));
        }
        let staging = Staging::within(host).map_err(|error| unwritable(target, &error))?;
        Ok(Self {
            target: target.to_owned(),
            host: host.to_owned(),
            rest: rest.to_owned(),
            staging,
            files: Vec::new(),
            removed: Vec::new(),
            overwrites: false,
        })
    }

    /// Prepares to write one file: the folder that it is in, and its name there.
    ///
    /// # Errors
    /// As [`Self::begin`], and for a path that does not end in a name.
    pub fn of_file(path: &Path) -> Result<(Self, String), OutputError> {
        let name = path.file_name().and_then(std::ffi::OsStr::to_str);
        let name = name.ok_or_else(|| fault(path, "is no name of a file"))?;
        let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
        Ok((Self::begin(folder)?, name.to_owned()))
    }

    /// Whether files that coilsense did not write, or that have changed since, are replaced as well. Those that were read never are.
    #[must_use]
    pub fn overwriting(self, overwrites: bool) -> Self {
        Self { overwrites, ..self }
    }

    /// Whether a file may be written, for who would rather know before the work than after it.
    ///
    /// # Errors
    /// [`OutputError`] where [`Self::commit`] would refuse it as things stand now.
    pub fn check(&self, relative: &str) -> Result<(), OutputError> {
        self.check_place(Path::new(relative), &Written::of(&self.target))
    }

    /// Where files are made that will be in the target.
    fn made(&self) -> PathBuf {
        self.staging.path().join(NEW).join(&self.rest)
    }

    /// Adds a file by its path inside the folder.
    ///
    /// # Errors
    /// [`OutputError`] where it cannot be written.
    pub fn add(&mut self, relative: &str, bytes: &[u8]) -> Result<(), OutputError> {
        self.write(relative, |file| file.write_all(bytes))
    }

    /// Adds a file that `write` fills, for what need not lie in memory as a whole.
    ///
    /// # Errors
    /// [`OutputError`] where it cannot be written.
    pub fn write(
        &mut self,
        relative: &str,
        write: impl FnOnce(&mut BufWriter<File>) -> io::Result<()>,
    ) -> Result<(), OutputError> {
        self.fill(relative, write).map_err(|error| unwritable(&self.target.join(relative), &error))?;
        self.files.push(relative.into());
        Ok(())
    }

    fn fill(&self, relative: &str, write: impl FnOnce(&mut BufWriter<File>) -> io::Result<()>) -> io::Result<()> {
        let path = self.made().join(relative);
        path.parent().map_or(Ok(()), fs::create_dir_all)?;
        let mut file = BufWriter::new(File::create(&path)?);
        write(&mut file)?;
        file.flush()?;
        // A name must not be on disk before what it names.
        file.get_ref().sync_all()
    }

    /// The files so far, as they will be called.
    pub fn files(&self) -> Vec<PathBuf> {
        self.files.iter().map(|file| self.target.join(file)).collect()
    }

    /// Removes a file of an earlier run on commit, unless it is written again, or is not as coilsense wrote it.
    pub fn remove(&mut self, relative: &str) {
        self.removed.push(relative.into());
    }

    /// Gives all files their final names; returns how many there are. What fails is undone: the folder is then as it was. A process that is killed
    /// in between leaves what the next run on the folder completes.
    ///
    /// # Errors
    /// [`OutputError`] for the first file that cannot take its place, or must not.
    pub fn commit(mut self) -> Result<usize, OutputError> {
        let count = self.files.len();
        if !self.rest.as_os_str().is_empty() && self.commit_as_folder()? {
            return Ok(count);
        }
        // Of several runs into one folder, one at a time; where the system cannot lock a folder, they take their chance.
        let locked = File::open(&self.host).and_then(|folder| folder.lock().map(|()| folder));
        self.staging.clear_up(&self.host);
        let mut written = Written::of(&self.host);
        for file in &self.files {
            self.check_place(file, &written)?;
        }
        let removed: Vec<PathBuf> =
            self.removed.iter().filter(|file| self.may_leave(file, &written)).cloned().collect();
        written.keep(|file| is_there(&self.host.join(file)) && !removed.iter().any(|leaving| leaving == file));
        self.sign(written)?;
        let gate = gate();
        let done = commit::run(self.staging.path(), &self.host, &self.files, &removed);
        drop(gate);
        drop(locked);
        done.map_err(|(file, error)| unwritable(&self.target.join(file), &error))?;
        Ok(count)
    }

    /// A target that is not there yet comes by one rename. Whether it has; else it has appeared meanwhile, and files go into it one by one.
    fn commit_as_folder(&mut self) -> Result<bool, OutputError> {
        self.sign(Written::default())?;
        let failed = |error: io::Error| unwritable(&self.target, &error);
        let made = self.staging.path().join(NEW);
        commit::sync_below(&made).map_err(failed)?;
        let mut gate = gate();
        let mut passed = PathBuf::new();
        for part in self.rest.components() {
            let parent = self.host.join(&passed);
            passed.push(part);
            let folder = self.host.join(&passed);
            if !is_there(&folder) {
                match fs::rename(made.join(&passed), &folder) {
                    // Another run was faster.
                    Err(error) if matches!(error.kind(), ErrorKind::DirectoryNotEmpty | ErrorKind::AlreadyExists) => (),
                    renamed => {
                        return renamed.and_then(|()| commit::sync_folder(&parent)).map(|()| true).map_err(failed);
                    }
                }
            }
            if !folder.is_dir() {
                return Err(fault(&folder, "is a file, a folder must take its place"));
            }
        }
        let target = self.host.join(&self.rest);
        let moved = fs::rename(&made, self.staging.path().join("made"))
            .and_then(|()| fs::rename(self.staging.path().join("made").join(&self.rest), &made))
            .and_then(|()| self.staging.move_into(&target, &mut gate));
        moved.map_err(failed)?;
        self.files.retain(|file| file != Path::new(WRITTEN));
        (self.host, self.rest) = (target, PathBuf::new());
        Ok(false)
    }

    /// Says in the folder which files are ours.
    fn sign(&mut self, mut written: Written) -> Result<(), OutputError> {
        for file in &self.files {
            let digest =
                digest(&self.made().join(file)).map_err(|error| unwritable(&self.target.join(file), &error))?;
            digest.into_iter().for_each(|digest| written.set(file, digest));
        }
        self.add(WRITTEN, written.text().as_bytes())
    }

    /// A file may take the place of one of ours or of nothing, below folders or nothing.
    fn check_place(&self, relative: &Path, written: &Written) -> Result<(), OutputError> {
        let last = self.target.join(relative);
        let inside = |folder: &&Path| folder.starts_with(&self.target);
        if let Some(file) =
            last.ancestors().skip(1).take_while(inside).find(|folder| folder.exists() && !folder.is_dir())
        {
            return Err(fault(file, "is a file, a folder must take its place"));
        }
        match fs::metadata(&last) {
            Ok(found) if found.is_dir() => return Err(fault(&last, "is a folder, a file must take its place")),
            Ok(found) if !found.is_file() => {
                return Err(fault(&last, "is no file but a device or the like; name a file"));
            }
            _ if !is_there(&last) || relative == Path::new(WRITTEN) => return Ok(()),
            _ => (),
        }
        if input::is_one(&last) {
            return Err(fault(&last, "is read by this command, and is not overwritten; name another file to write"));
        }
        if self.overwrites || self.is_ours(relative, written) {
            return Ok(());
        }
        let why = match written.digest(relative) {
            Some(_) => "has changed since coilsense wrote it",
            None => "is there, and coilsense did not write it",
        };
        let message = Message::from(why) + "; name another, or replace it with " + Hint::Flag("overwrite");
        Err(OutputError { path: last, message })
    }

    fn is_ours(&self, relative: &Path, written: &Written) -> bool {
        let Some(known) = written.digest(relative) else { return false };
        digest(&self.target.join(relative)).is_ok_and(|found| found.as_deref() == Some(known))
    }

    /// Whether a file of an earlier run is to leave.
    fn may_leave(&self, relative: &Path, written: &Written) -> bool {
        let last = self.target.join(relative);
        let is_old = last.is_file() && !self.files.iter().any(|file| file == relative);
        is_old && !input::is_one(&last) && (self.overwrites || self.is_ours(relative, written))
    }
}

fn unwritable(path: &Path, error: &io::Error) -> OutputError {
    fault(path, format!("cannot be written: {}", system::said(error)))
}

fn fault(path: &Path, message: impl Into<Message>) -> OutputError {
    OutputError { path: path.to_owned(), message: message.into() }
}

#[cfg(test)]
mod tests;
