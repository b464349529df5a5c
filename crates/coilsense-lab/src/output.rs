//! Files on disk: all of a command's output, or none of it.
//!
//! Next door: what is in the files (`report`).

use std::fs;
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
        let host = absolute
            .ancestors()
            .find(|folder| folder.exists())
            .unwrap_or(Path::new("."));
        let staging = tempfile::Builder::new()
            .prefix(".coilsense-")
            .tempdir_in(host)
            .map_err(|error| fault(target, format!("cannot be written: {}", cause(&error))))?;
        Ok(Self {
            target: target.to_owned(),
            staging,
            files: Vec::new(),
        })
    }

    /// Adds a file by its path inside the folder.
    ///
    /// # Errors
    /// [`OutputError`] where it cannot be written.
    pub fn add(&mut self, relative: &str, bytes: &[u8]) -> Result<(), OutputError> {
        let path = self.staging.path().join(relative);
        let written = path
            .parent()
            .map_or(Ok(()), fs::create_dir_all)
            .and_then(|()| fs::write(&path, bytes));
        written.map_err(|error| {
            fault(
                &self.target.join(relative),
                format!("cannot be written: {}", cause(&error)),
            )
        })?;
        self.files.push(relative.into());
        Ok(())
    }

    /// Gives all files their final names; returns how many there are.
    ///
    /// # Errors
    /// [`OutputError`] for the first file that cannot be renamed into place.
    pub fn commit(self) -> Result<usize, OutputError> {
        for relative in &self.files {
            let last = self.target.join(relative);
            last.parent()
                .map_or(Ok(()), fs::create_dir_all)
                .and_then(|()| fs::rename(self.staging.path().join(relative), &last))
                .map_err(|error| fault(&last, format!("cannot be written: {}", cause(&error))))?;
        }
        Ok(self.files.len())
    }
}

fn fault(path: &Path, message: impl std::fmt::Display) -> OutputError {
    OutputError {
        path: path.to_owned(),
        message: message.to_string(),
    }
}

/// What the system said, without the path of the temporary folder.
fn cause(error: &std::io::Error) -> String {
    error.kind().to_string()
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
