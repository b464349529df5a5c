//! A record of a real spring that rings, as somebody sends it: a folder with logs and what is known of them, checked and packed.
//!
//! Next door: what a single log says (`identification`), what the command prints (`report::record`), what to record (`book/src/guide/record.md`).

mod checks;
mod file;
#[cfg(feature = "fmu")]
mod pack;

use std::path::{Component, Path, PathBuf};

pub use checks::{Check, State};
use file::File;
pub use file::{FILE, Kind, TEMPLATE};

use crate::identification::Identified;
use crate::message::Message;

/// Why a folder is no record, or cannot be packed: one line.
#[derive(Debug, thiserror::Error)]
#[error("{0}")]
pub struct RecordError(Message);

impl RecordError {
    fn of(text: impl Into<Message>) -> Self {
        Self(text.into())
    }
}

/// A record, read and checked.
#[derive(Debug)]
pub struct Record {
    folder: PathBuf,
    file: File,
    /// What was found of each log that could be read, by its name.
    pub logs: Vec<(String, Kind, Identified)>,
    /// Everything that was looked at, in the order of the page.
    pub checks: Vec<Check>,
}

impl Record {
    /// Reads a folder's `record.toml` and all that it names, and checks it.
    ///
    /// # Errors
    /// [`RecordError`] for a folder without `record.toml`, or one that cannot be read; what is wrong with a log is a check that fails.
    pub fn read(folder: &Path) -> Result<Self, RecordError> {
        let file = File::read(folder)?;
        let mut record = Self { folder: folder.to_owned(), file, logs: Vec::new(), checks: Vec::new() };
        checks::all(&mut record);
        Ok(record)
    }

    /// Whether it is whole enough to be sent: nothing is missing. What is doubtful may be sent, and is told.
    pub fn is_whole(&self) -> bool {
        self.checks.iter().all(|check| check.state != State::Missing)
    }

    /// Whether nothing is missing and nothing is doubtful.
    pub fn is_clean(&self) -> bool {
        self.checks.iter().all(|check| check.state == State::Fine)
    }

    /// A file of the folder, by the name that `record.toml` has for it.
    ///
    /// # Errors
    /// The reason for one that would lie elsewhere, or is not there.
    fn inside(&self, name: &str) -> Result<PathBuf, String> {
        let is_plain = |part: Component<'_>| matches!(part, Component::Normal(_));
        if name.is_empty() || !Path::new(name).components().all(is_plain) {
            return Err(format!("{name:?} must be a file of this folder"));
        }
        let path = self.folder.join(name);
        if path.is_file() { Ok(path) } else { Err(format!("{} is not there", path.display())) }
    }

    /// Every file that is sent, by name: `record.toml`, the spec, logs and their mappings, each once.
    #[cfg(feature = "fmu")]
    fn names(&self) -> Vec<&str> {
        let mut names = vec![FILE, self.file.spring.spec.as_str()];
        let of_logs = self.file.log.iter().flat_map(|log| [Some(&log.file), log.mapping.as_ref()]);
        for name in of_logs.flatten().map(String::as_str) {
            if !names.contains(&name) {
                names.push(name);
            }
        }
        names
    }
}
