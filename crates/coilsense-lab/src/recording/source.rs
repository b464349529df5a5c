//! Where rows come from: one after the other, so that a file need not fit into memory.
//!
//! Next door: texts (`text`), other formats (`formats`), what is read at once (`whole`), what becomes of the rows (`pipeline`).

use std::path::Path;

use super::account::Reason;
use super::error::RecordingError;
use super::layout::FileClock;
use super::title::Title;

/// A log that hands out its rows.
pub(super) trait Source {
    /// The file, for messages.
    fn file(&self) -> &Path;
    /// How it is written, in words.
    fn description(&self) -> String;
    /// The titles of its columns.
    fn titles(&self) -> &[Title];
    /// Comment lines and what else stands above the rows.
    fn remarks(&self) -> &[String];
    /// How much of it is done, and of how much: bytes, or rows.
    fn progress(&self) -> [u64; 2];
    /// The clock that the file tells without a column of it.
    fn clock(&self) -> Option<FileClock> {
        None
    }
    /// From now on what is no number is a missing one.
    fn be_lenient(&mut self) {}
    /// The columns that hold numbers, as far as that is known beforehand.
    fn numeric(&self) -> Vec<usize> {
        (0..self.titles().len()).collect()
    }
    /// All columns, and the line of each row, where they are in memory anyway: moved out, so that no row is left.
    fn whole(&mut self) -> Option<(Vec<Vec<f64>>, Vec<u64>)> {
        None
    }
    /// The next row's cells of the columns `wanted` (indices in rising order) into `values`; NaN where there is none.
    fn next(&mut self, wanted: &[usize], values: &mut Vec<f64>) -> Result<Next, RecordingError>;
}

/// What came.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Next {
    /// A row of numbers, and the line where it stands.
    Row(u64),
    /// A row that cannot be read.
    Broken { line: u64, reason: Reason, message: String },
    /// Nothing is left.
    End,
}
