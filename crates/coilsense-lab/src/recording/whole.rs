//! Reading a file's columns, all at once.
//!
//! Next door: the columns (`table`), formats (`formats`), channels in SI (`mod`).

use std::path::Path;

use super::error::RecordingError;
use super::formats;
use super::handed::Handed;
use super::mapping::Format;
use super::order::MOST_NUMBERS;
use super::source::{Next, Source};
use super::table::Table;
use super::title::Title;

impl Table {
    /// Reads a file as a whole. What is no number is NaN, and a column of texts in Parquet is not there; a row with too many or too few cells is an error.
    ///
    /// # Errors
    /// [`RecordingError`] where the file cannot be read or holds no rows of numbers.
    pub fn read(path: &Path, format: &Format) -> Result<Self, RecordingError> {
        let mut source = formats::open(path, format)?;
        source.be_lenient();
        let wanted = source.numeric();
        Self::of_source(source.as_mut(), &wanted)
    }

    /// The same of a text that is handed over.
    ///
    /// # Errors
    /// As [`Self::read`].
    pub fn of_handed(log: Handed, format: &Format) -> Result<Self, RecordingError> {
        let mut source = formats::held(log, format)?;
        source.be_lenient();
        let wanted = source.numeric();
        Self::of_source(&mut source, &wanted)
    }

    fn of_source(source: &mut dyn Source, wanted: &[usize]) -> Result<Self, RecordingError> {
        let titles: Vec<Title> = wanted.iter().filter_map(|index| source.titles().get(*index)).cloned().collect();
        let mut table = Self {
            file: source.file().to_owned(),
            description: source.description(),
            remarks: source.remarks().to_vec(),
            columns: vec![Vec::new(); titles.len()],
            titles,
            lines: Vec::new(),
        };
        if let Some((columns, lines)) = source.whole() {
            return Ok(Self { columns, lines, ..table });
        }
        let mut cells = Vec::new();
        loop {
            match source.next(wanted, &mut cells)? {
                Next::End => return Ok(table),
                Next::Row(line) => table.push(line, &cells)?,
                Next::Broken { line, message, .. } => return Err(RecordingError::of_line(&table.file, line, message)),
            }
        }
    }

    fn push(&mut self, line: u64, cells: &[f64]) -> Result<(), RecordingError> {
        if (self.lines.len() + 1) * (cells.len() + 1) > MOST_NUMBERS {
            return Err(RecordingError::of_file(&self.file, "is too large to be held in memory"));
        }
        self.lines.push(line);
        for (column, cell) in self.columns.iter_mut().zip(cells) {
            column.push(*cell);
        }
        Ok(())
    }
}
