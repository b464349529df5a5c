//! Rows of a Parquet file, one row group in memory at a time.
//!
//! | file | holds |
//! |---|---|
//! | `kind` | what a column holds |
//! | `values` | its values in one row group |
//!
//! Next door: who writes such files here (`crate::series`), texts (`text`).

mod kind;
mod values;

use std::fs::File;
use std::path::{Path, PathBuf};

use parquet::errors::ParquetError;
use parquet::file::reader::{FileReader, SerializedFileReader};
use parquet::schema::types::ColumnDescriptor;

use super::super::error::RecordingError;
use super::super::input::Input;
use super::super::order::MOST_NUMBERS;
use super::super::source::{Next, Source};
use super::super::title::Title;
use super::columnar::Kind;
use crate::bounded::Bounded;
use crate::guarded::guarded;
use crate::series::parquet::REMARKS;

/// A Parquet file that is being read.
pub(super) struct ParquetRows {
    path: PathBuf,
    reader: SerializedFileReader<Bounded>,
    titles: Vec<Title>,
    remarks: Vec<String>,
    /// What each column holds: numbers, or something else.
    kinds: Vec<Result<Kind, &'static str>>,
    /// First instant of each column that holds such.
    origins: Vec<Option<i128>>,
    /// The row group in memory: its number, the columns that were wanted, and the next row of it.
    group: usize,
    columns: Vec<Vec<f64>>,
    row: usize,
    progress: [u64; 2],
}

impl ParquetRows {
    /// Opens a file.
    pub fn open(input: Input) -> Result<Self, RecordingError> {
        let path = input.path().to_owned();
        let file = input.file()?;
        guarded(&path, || Self::opened(&path, file))
    }

    fn opened(path: &Path, file: File) -> Result<Self, RecordingError> {
        let wrong = |error: &dyn std::fmt::Display| {
            RecordingError::of_file(path, format!("is no Parquet file that can be read: {}", one_line(error)))
        };
        let reader = SerializedFileReader::new(Bounded(file)).map_err(|error| wrong(&error))?;
        let metadata = reader.metadata().file_metadata();
        let schema = metadata.schema_descr();
        let pairs = || metadata.key_value_metadata().into_iter().flatten();
        let texts = |key| pairs().filter(move |pair| pair.key == key).filter_map(|pair| pair.value.as_deref());
        let durations = kind::durations(texts("ARROW:schema").next());
        let columns = schema.columns().iter();
        let (titles, kinds): (Vec<Title>, Vec<_>) = columns
            .map(|column| {
                let kind = kind::kind(column, &durations);
                (title(column, kind), kind)
            })
            .unzip();
        let remarks = texts(REMARKS).flat_map(str::lines).map(str::to_owned).collect();
        let rows = u64::try_from(metadata.num_rows()).unwrap_or(0);
        let origins = vec![None; titles.len()];
        let (path, progress) = (path.to_owned(), [0, rows]);
        let columns = Vec::new();
        Ok(Self { path, reader, titles, remarks, kinds, origins, group: 0, columns, row: 0, progress })
    }

    /// Reads the next row group that has rows; false where none is left.
    fn advance(&mut self, wanted: &[usize]) -> Result<bool, RecordingError> {
        let wrong = |message: String| RecordingError::of_file(&self.path, message);
        while self.group < self.reader.num_row_groups() {
            let group = self.reader.get_row_group(self.group).map_err(|error| wrong(one_line(&error)))?;
            self.group += 1;
            let rows = usize::try_from(group.metadata().num_rows()).unwrap_or(usize::MAX);
            if rows.saturating_mul(wanted.len()) > MOST_NUMBERS {
                return Err(wrong(format!("its row group {} is too large to be held in memory", self.group)));
            }
            self.columns.clear();
            for &index in wanted {
                let place = self.titles[index].place(index);
                let failed =
                    |error: ParquetError| wrong(format!("{place}, row group {}: {}", self.group, one_line(&error)));
                let kind = self.kinds[index].map_err(|what| wrong(format!("{place}: it holds {what}, no numbers")))?;
                let reader = group.get_column_reader(index).map_err(failed)?;
                let most = group.metadata().schema_descr().column(index).max_def_level();
                let values = values::numbers(reader, kind, rows, most, &mut self.origins[index]).map_err(failed)?;
                if values.len() != rows {
                    let found = values.len();
                    return Err(wrong(format!(
                        "{place}, row group {}: {found} values where {rows} rows are told",
                        self.group
                    )));
                }
                self.columns.push(values);
            }
            self.row = 0;
            if rows > 0 {
                return Ok(true);
            }
        }
        Ok(false)
    }
}

impl Source for ParquetRows {
    fn file(&self) -> &Path {
        &self.path
    }

    fn description(&self) -> String {
        format!("Parquet, {} columns, {} rows", self.titles.len(), self.progress[1])
    }

    fn titles(&self) -> &[Title] {
        &self.titles
    }

    fn remarks(&self) -> &[String] {
        &self.remarks
    }

    fn progress(&self) -> [u64; 2] {
        self.progress
    }

    fn numeric(&self) -> Vec<usize> {
        (0..self.kinds.len()).filter(|&index| self.kinds[index].is_ok()).collect()
    }

    fn next(&mut self, wanted: &[usize], values: &mut Vec<f64>) -> Result<Next, RecordingError> {
        if self.columns.first().is_none_or(|column| self.row >= column.len()) {
            let file = self.path.clone();
            if !guarded(&file, || self.advance(wanted))? {
                return Ok(Next::End);
            }
        }
        values.clear();
        values.extend(self.columns.iter().map(|column| column[self.row]));
        self.row += 1;
        self.progress[0] += 1;
        Ok(Next::Row(self.progress[0]))
    }
}

/// A column's title; one within another is called by both names.
fn title(column: &ColumnDescriptor, kind: Result<Kind, &str>) -> Title {
    let parts = column.path().parts();
    // A list's own names below its name are its writer's.
    let parts = if column.max_rep_level() > 0 { &parts[..parts.len().min(1)] } else { parts };
    let title = Title::parse(&parts.join("."));
    let unit = match kind {
        Ok(Kind::Duration(_)) => Some("s".to_owned()),
        _ => title.unit,
    };
    Title { stamps: kind.is_ok_and(Kind::stamps), unit, ..title }
}

/// What a library says, on one line.
fn one_line(error: &dyn std::fmt::Display) -> String {
    super::super::error::shortened(&error.to_string())
}
