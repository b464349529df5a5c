//! A file's columns as they are, all in memory.
//!
//! Next door: reading a file into them (`whole`), channels in SI (`mod`), rows one by one (`source`).

use std::path::{Path, PathBuf};

use super::error::{RecordingError, clipped};
use super::title::Title;

/// Columns by name or number, with their units, as they stand in a file.
#[derive(Debug, Clone, PartialEq)]
pub struct Table {
    pub(super) file: PathBuf,
    pub(super) description: String,
    pub(super) remarks: Vec<String>,
    pub(super) titles: Vec<Title>,
    pub(super) columns: Vec<Vec<f64>>,
    /// The file's line of each row; of a file without lines its rows from 1.
    pub(super) lines: Vec<u64>,
}

impl Table {
    /// The file, for messages.
    pub fn file(&self) -> &Path {
        &self.file
    }

    /// How many rows there are.
    pub fn rows(&self) -> usize {
        self.lines.len()
    }

    /// The columns' titles, in order.
    pub fn titles(&self) -> &[Title] {
        &self.titles
    }

    /// The file's line of each row, shape `rows`.
    pub fn lines(&self) -> &[u64] {
        &self.lines
    }

    /// Comment lines and what else stands above the rows.
    pub fn remarks(&self) -> &[String] {
        &self.remarks
    }

    /// The numbers of a column by its title, name or number (`#1` is the first), shape `rows`; NaN where there is none.
    ///
    /// # Errors
    /// [`RecordingError`] where no column or more than one is called so.
    pub fn column(&self, title: &str) -> Result<&[f64], RecordingError> {
        let number = title.strip_prefix('#').and_then(|number| number.parse::<usize>().ok()?.checked_sub(1));
        let named = |candidate: &Title| candidate.text == title || candidate.name == title;
        let places: Vec<usize> = match number {
            Some(index) => vec![index],
            None => (0..self.titles.len()).filter(|&index| named(&self.titles[index])).collect(),
        };
        let column = match places.as_slice() {
            [one] => self.columns.get(*one),
            _ => None,
        };
        let message =
            || format!("no single column is called {}; it has {} columns", clipped(title), self.columns.len());
        column.map(Vec::as_slice).ok_or_else(|| RecordingError::of_file(&self.file, message()))
    }
}
