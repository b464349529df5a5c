//! Files on disk: all of a command's output, or none of it.
//!
//! Next door: what is in the files (`report`).

use std::fs::{self, File};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

use tempfile::TempDir;

/// A folder that cannot be written.
#[derive(Debug, thiserror::Error)]
#[error("{}: {message}", path.display())]
pub struct OutputError {
    path: PathBuf,
    message: String,
}

/// A folder under construction. Nothing appears under its final name before [`Self::commit`]; dropped before that, it leaves nothing.
#[derive(Debug)]
pub struct Output {
    target: PathBuf,
    staging: TempDir,
    files: Vec<PathBuf>,
    removed: Vec<PathBuf>,
}

impl Output {
    /// Prepares to write the folder `target`, which may exist; its other files are left alone.
    ///
    /// # Errors
    /// [`OutputError`] where `target` is a file, or where nothing can be written beside or in it.
    pub fn begin(target: &Path) -> Result<Self, OutputError> {
        if target.exists() && !target.is_dir() {
            return Err(fault(target, "is a file, a folder is needed"));
        }
        // The staging folder must share the target's file system, for renames to be whole: the target itself, or its nearest ancestor.
        let absolute = std::path::absolute(target).map_err(|error| fault(target, error))?;
        let host = absolute.ancestors().find(|folder| folder.exists()).unwrap_or(Path::new("."));
        let staging = tempfile::Builder::new()
            .prefix(".coilsense-")
            .tempdir_in(host)
            .map_err(|error| unwritable(target, &error))?;
        Ok(Self { target: target.to_owned(), staging, files: Vec::new(), removed: Vec::new() })
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
        let path = self.staging.path().join(relative);
        let filled = || {
            path.parent().map_or(Ok(()), fs::create_dir_all)?;
            let mut file = BufWriter::new(File::create(&path)?);
            write(&mut file)?;
            file.flush()
        };
        filled().map_err(|error| unwritable(&self.target.join(relative), &error))?;
        self.files.push(relative.into());
        Ok(())
    }

    /// The files so far, as they will be called.
    pub fn files(&self) -> Vec<PathBuf> {
        self.files.iter().map(|file| self.target.join(file)).collect()
    }

    /// Removes a file of an earlier run on commit, unless it is written again.
    pub fn remove(&mut self, relative: &str) {
        self.removed.push(relative.into());
    }

    /// Gives all files their final names; returns how many there are. What fails is undone: the folder is then as it was.
    ///
    /// # Errors
    /// [`OutputError`] for the first file that cannot take its place.
    pub fn commit(self) -> Result<usize, OutputError> {
        for relative in &self.files {
            self.check_place(relative)?;
        }
        let aside = self.staging.path().join(".aside");
        let mut done: Vec<(PathBuf, Option<PathBuf>)> = Vec::new();
        let leaving = self.removed.iter().filter(|removed| !self.files.contains(removed));
        let steps = self.files.iter().map(|file| (file, true)).chain(leaving.map(|file| (file, false)));
        for (relative, comes) in steps {
            if let Err(error) = self.place(relative, comes, &aside, &mut done) {
                for (last, before) in done.into_iter().rev() {
                    // Undoing what was just done; nothing better can be done where that fails too.
                    let _ = match before {
                        Some(before) => fs::rename(before, &last),
                        None => fs::remove_file(&last),
                    };
                }
                return Err(unwritable(&self.target.join(relative), &error));
            }
        }
        Ok(self.files.len())
    }

    /// Puts what is there aside, and the new file, if one comes, in its place.
    fn place(
        &self,
        relative: &Path,
        comes: bool,
        aside: &Path,
        done: &mut Vec<(PathBuf, Option<PathBuf>)>,
    ) -> io::Result<()> {
        let last = self.target.join(relative);
        let mut before = None;
        if last.exists() {
            let kept = aside.join(relative);
            kept.parent().map_or(Ok(()), fs::create_dir_all)?;
            fs::rename(&last, &kept)?;
            before = Some(kept);
        }
        if comes {
            last.parent().map_or(Ok(()), fs::create_dir_all)?;
            let moved = fs::rename(self.staging.path().join(relative), &last);
            done.push((last, before));
            return moved;
        }
        done.extend(before.map(|before| (last, Some(before))));
        Ok(())
    }

    /// A file may take the place of a file or of nothing, below folders or nothing.
    fn check_place(&self, relative: &Path) -> Result<(), OutputError> {
        let last = self.target.join(relative);
        if last.is_dir() {
            return Err(fault(&last, "is a folder, a file must take its place"));
        }
        let inside = |folder: &&Path| folder.starts_with(&self.target);
        match last.ancestors().skip(1).take_while(inside).find(|folder| folder.exists() && !folder.is_dir()) {
            Some(file) => Err(fault(file, "is a file, a folder must take its place")),
            None => Ok(()),
        }
    }
}

fn unwritable(path: &Path, error: &io::Error) -> OutputError {
    // What the system said, without the path of the temporary folder.
    fault(path, format!("cannot be written: {}", error.kind()))
}

fn fault(path: &Path, message: impl std::fmt::Display) -> OutputError {
    OutputError { path: path.to_owned(), message: message.to_string() }
}

#[cfg(test)]
mod tests {
    use super::Output;

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
        std::fs::write(path("report.html"), "old").unwrap();
        let mut output = Output::begin(place.path()).unwrap();
        output.add("report.html", b"new").unwrap();
        output.add("deep/er.csv", b"1").unwrap();
        assert_eq!(output.commit().unwrap(), 2);
        assert_eq!(std::fs::read_to_string(path("mine.txt")).unwrap(), "mine");
        assert_eq!(std::fs::read_to_string(path("report.html")).unwrap(), "new");
        assert_eq!(std::fs::read_dir(place.path()).unwrap().count(), 3);
    }

    #[test]
    fn what_is_in_the_way_of_a_commit_is_named_and_nothing_changes() {
        let place = tempfile::tempdir().unwrap();
        let path = |name: &str| place.path().join(name);
        std::fs::write(path("a.txt"), "old").unwrap();
        std::fs::create_dir(path("report.html")).unwrap();
        std::fs::write(path("signals"), "a file").unwrap();
        for (obstacle, word) in [("report.html", "folder"), ("signals/one.csv", "file")] {
            let mut output = Output::begin(place.path()).unwrap();
            output.add("a.txt", b"new").unwrap();
            output.add("b/c.txt", b"new").unwrap();
            output.add(obstacle, b"new").unwrap();
            let error = output.commit().unwrap_err().to_string();
            let named = path(obstacle.split('/').next().unwrap());
            assert!(error.starts_with(&format!("{}: is a {word}", named.display())), "{error}");
            assert_eq!(std::fs::read_to_string(path("a.txt")).unwrap(), "old");
            assert_eq!(std::fs::read_dir(place.path()).unwrap().count(), 3);
        }
    }

    #[test]
    fn a_file_of_an_earlier_run_is_removed_unless_it_is_written_again() {
        let place = tempfile::tempdir().unwrap();
        for (name, text) in [("one.csv", "old"), ("two.csv", "old"), ("mine.csv", "mine")] {
            std::fs::write(place.path().join(name), text).unwrap();
        }
        let mut output = Output::begin(place.path()).unwrap();
        output.add("one.csv", b"new").unwrap();
        for name in ["one.csv", "two.csv", "three.csv"] {
            output.remove(name);
        }
        output.commit().unwrap();
        assert_eq!(std::fs::read_to_string(place.path().join("one.csv")).unwrap(), "new");
        assert!(!place.path().join("two.csv").exists() && place.path().join("mine.csv").exists());
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
