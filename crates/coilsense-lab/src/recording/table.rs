//! A file's columns as they are, all in memory.
//!
//! Next door: channels in SI (`mod`), rows one by one (`source`).

use std::path::{Path, PathBuf};

use super::error::{RecordingError, clipped};
use super::mapping::Format;
use super::order::MOST_NUMBERS;
use super::source::{Kind, Next, Source};
use super::text::Text;
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
    /// Reads a file as a whole. What is no number is NaN, and a column of texts in Parquet is not there; a row with too many or too few cells is an error.
    ///
    /// # Errors
    /// [`RecordingError`] where the file cannot be read or holds no rows of numbers.
    pub fn read(path: &Path, format: &Format) -> Result<Self, RecordingError> {
        match Kind::of(path)? {
            Kind::Text => Self::of_text(Text::open(path, format)?),
            #[cfg(feature = "matlab")]
            Kind::Matlab => super::matlab::read(path),
            #[cfg(feature = "mdf")]
            Kind::Mdf => super::mdf::read(path),
            #[cfg(feature = "parquet")]
            Kind::Parquet => {
                let mut source = super::parquet::ParquetRows::open(path)?;
                let wanted = source.numeric();
                Self::of_source(&mut source, &wanted)
            }
        }
    }

    /// The same of a text in memory, under a name for messages.
    ///
    /// # Errors
    /// As [`Self::read`].
    pub fn held(name: &str, text: Vec<u8>, format: &Format) -> Result<Self, RecordingError> {
        Self::of_text(Text::held(Path::new(name), text, format)?)
    }

    fn of_text(mut source: Text) -> Result<Self, RecordingError> {
        source.lenient = true;
        let wanted: Vec<usize> = (0..source.titles().len()).collect();
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

/// Rows of a table, one after the other.
#[cfg(any(feature = "matlab", feature = "mdf"))]
pub(super) struct TableRows {
    table: Table,
    row: usize,
}

#[cfg(any(feature = "matlab", feature = "mdf"))]
impl TableRows {
    /// From the first row on.
    pub fn of(table: Table) -> Self {
        Self { table, row: 0 }
    }
}

#[cfg(any(feature = "matlab", feature = "mdf"))]
impl Source for TableRows {
    fn file(&self) -> &Path {
        &self.table.file
    }

    fn description(&self) -> String {
        self.table.description.clone()
    }

    fn titles(&self) -> &[Title] {
        &self.table.titles
    }

    fn remarks(&self) -> &[String] {
        &self.table.remarks
    }

    fn progress(&self) -> [u64; 2] {
        [self.row as u64, self.table.lines.len() as u64]
    }

    fn next(&mut self, wanted: &[usize], values: &mut Vec<f64>) -> Result<Next, RecordingError> {
        let Some(&line) = self.table.lines.get(self.row) else { return Ok(Next::End) };
        values.clear();
        let cell = |&index: &usize| self.table.columns.get(index).and_then(|column| column.get(self.row)).copied();
        values.extend(wanted.iter().map(|index| cell(index).unwrap_or(f64::NAN)));
        self.row += 1;
        Ok(Next::Row(line))
    }
}
