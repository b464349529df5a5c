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

use commit::is_there;
use staging::{NEW, gate};
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

    /// The folder.
    pub fn folder(&self) -> &Path {
        &self.target
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
mod tests {
    use std::path::{Path, PathBuf};

    use super::{Output, OutputError, WRITTEN};

    /// What a folder holds besides the list of what was written.
    fn count(folder: &Path) -> usize {
        std::fs::read_dir(folder).unwrap().filter(|entry| entry.as_ref().unwrap().file_name() != WRITTEN).count()
    }

    fn write(folder: &Path, files: &[(&str, &str)]) -> Result<usize, OutputError> {
        let mut output = Output::begin(folder)?;
        files.iter().try_for_each(|(name, text)| output.add(name, text.as_bytes()))?;
        output.commit()
    }

    fn read(path: PathBuf) -> String {
        std::fs::read_to_string(path).unwrap()
    }

    #[test]
    fn nothing_is_seen_before_the_commit_and_nothing_stays_without_it() {
        let place = tempfile::tempdir().unwrap();
        let target = place.path().join("a/b");
        let mut output = Output::begin(&target).unwrap();
        output.add("figures/one.svg", b"<svg/>").unwrap();
        assert!(!target.exists());
        drop(output);
        assert_eq!(std::fs::read_dir(place.path()).unwrap().count(), 0);
    }

    #[test]
    fn a_commit_replaces_its_own_files_and_keeps_the_others() {
        let place = tempfile::tempdir().unwrap();
        let path = |name: &str| place.path().join(name);
        std::fs::write(path("mine.txt"), "mine").unwrap();
        write(place.path(), &[("report.html", "old")]).unwrap();
        assert_eq!(write(place.path(), &[("report.html", "new"), ("deep/er.csv", "1")]).unwrap(), 2);
        assert_eq!(read(path("mine.txt")), "mine");
        assert_eq!(read(path("report.html")), "new");
        assert_eq!(count(place.path()), 3);
    }

    #[test]
    fn what_is_in_the_way_of_a_commit_is_named_and_nothing_changes() {
        let place = tempfile::tempdir().unwrap();
        let path = |name: &str| place.path().join(name);
        std::fs::write(path("a.txt"), "old").unwrap();
        std::fs::create_dir(path("report.html")).unwrap();
        std::fs::write(path("signals"), "a file").unwrap();
        for (obstacle, word) in [("report.html", "folder"), ("signals/one.csv", "file")] {
            let mut output = Output::begin(place.path()).unwrap().overwriting(true);
            output.add("a.txt", b"new").unwrap();
            output.add("b/c.txt", b"new").unwrap();
            output.add(obstacle, b"new").unwrap();
            let error = output.commit().unwrap_err().to_string();
            let named = path(obstacle.split('/').next().unwrap());
            assert!(error.starts_with(&format!("{}: is a {word}", named.display())), "{error}");
            assert_eq!(std::fs::read_to_string(path("a.txt")).unwrap(), "old");
            assert_eq!(count(place.path()), 3);
        }
    }

    #[test]
    fn a_file_of_an_earlier_run_is_removed_unless_it_is_written_again() {
        let place = tempfile::tempdir().unwrap();
        write(place.path(), &[("one.csv", "old"), ("two.csv", "old"), ("four.csv", "old")]).unwrap();
        for (name, text) in [("mine.csv", "mine"), ("four.csv", "mended"), ("five.csv", "mine")] {
            std::fs::write(place.path().join(name), text).unwrap();
        }
        let mut output = Output::begin(place.path()).unwrap();
        output.add("one.csv", b"new").unwrap();
        for name in ["one.csv", "two.csv", "three.csv", "four.csv", "five.csv"] {
            output.remove(name);
        }
        output.commit().unwrap();
        assert_eq!(std::fs::read_to_string(place.path().join("one.csv")).unwrap(), "new");
        assert!(!place.path().join("two.csv").exists() && place.path().join("mine.csv").exists());
        // What somebody has changed, or made himself, stays, whatever its name.
        assert_eq!([read(place.path().join("four.csv")), read(place.path().join("five.csv"))], ["mended", "mine"]);
        assert_eq!(
            read(place.path().join(WRITTEN)).lines().count(),
            3,
            "the head, one.csv, and four.csv, which is there"
        );
    }

    #[test]
    fn what_coilsense_did_not_write_or_somebody_has_changed_is_replaced_only_where_that_is_asked_for() {
        let place = tempfile::tempdir().unwrap();
        let path = place.path().join("a.csv");
        std::fs::write(&path, "mine").unwrap();
        let error = write(place.path(), &[("a.csv", "new")]).unwrap_err().to_string();
        let told = "is there, and coilsense did not write it; name another, or replace it with --overwrite";
        assert_eq!(error, format!("{}: {told}", path.display()));
        assert_eq!((read(path.clone()), count(place.path())), ("mine".to_owned(), 1));
        let over = |text: &[u8]| {
            let mut output = Output::begin(place.path()).unwrap().overwriting(true);
            output.add("a.csv", text).unwrap();
            output.commit().unwrap();
        };
        over(b"new");
        write(place.path(), &[("a.csv", "newer")]).unwrap();
        assert_eq!(read(path.clone()), "newer");
        std::fs::write(&path, "newer, and mended by hand").unwrap();
        let error = write(place.path(), &[("a.csv", "newest")]).unwrap_err().to_string();
        assert!(error.contains("has changed since coilsense wrote it"), "{error}");
        over(b"newest");
        // A folder that is copied keeps its list.
        let other = place.path().join("copy");
        std::fs::create_dir(&other).unwrap();
        for name in ["a.csv", WRITTEN] {
            std::fs::copy(place.path().join(name), other.join(name)).unwrap();
        }
        write(&other, &[("a.csv", "again")]).unwrap();
    }

    #[test]
    fn a_folder_that_appears_meanwhile_takes_the_files_one_by_one() {
        let place = tempfile::tempdir().unwrap();
        for (target, first) in [("a/b", "a"), ("c/d/e", "c/d/e"), ("f", "f")] {
            let target = place.path().join(target);
            let mut output = Output::begin(&target).unwrap();
            output.add("x/new.csv", b"new").unwrap();
            write(&place.path().join(first), &[("x/other.csv", "other")]).unwrap();
            assert_eq!(output.commit().unwrap(), 1);
            assert_eq!(read(target.join("x/new.csv")), "new");
            assert_eq!(read(place.path().join(first).join("x/other.csv")), "other");
            assert!(read(target.join(WRITTEN)).contains("x/new.csv"));
        }
        assert_eq!(count(place.path()), 3);
    }

    #[cfg(unix)]
    #[test]
    fn a_device_and_a_way_up_from_nowhere_are_named() {
        let (output, name) = Output::of_file(Path::new("/dev/null")).unwrap_or_else(|_| {
            // Whoever may not write there is told so.
            Output::of_file(&std::env::temp_dir().join("x")).unwrap()
        });
        if name == "null" {
            assert!(output.check(&name).unwrap_err().to_string().starts_with("/dev/null: is no file but a device"));
        }
        let place = tempfile::tempdir().unwrap();
        let error = Output::begin(&place.path().join("not/there/../out")).unwrap_err().to_string();
        assert!(error.ends_with("goes up from a folder that is not there"), "{error}");
        assert_eq!(count(place.path()), 0);
    }

    #[test]
    fn a_file_in_the_way_is_named() {
        let place = tempfile::tempdir().unwrap();
        let file = place.path().join("file");
        std::fs::write(&file, "").unwrap();
        for target in [file.clone(), file.join("below")] {
            let error = Output::begin(&target).unwrap_err().to_string();
            assert!(error.starts_with(&target.display().to_string()), "{error}");
        }
    }
}
