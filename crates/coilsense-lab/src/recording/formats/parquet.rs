//! Rows of a Parquet file, one row group in memory at a time.
//!
//! Next door: who writes such files here (`crate::series`), texts (`text`).

use std::fs::File;
use std::path::{Path, PathBuf};

use parquet::basic::{LogicalType, TimeUnit, Type};
use parquet::column::reader::{ColumnReader, ColumnReaderImpl};
use parquet::data_type::DataType;
use parquet::errors::ParquetError;
use parquet::file::reader::{FileReader, SerializedFileReader};
use parquet::schema::types::ColumnDescriptor;

use super::super::error::RecordingError;
use super::super::input::Input;
use super::super::order::MOST_NUMBERS;
use super::super::source::{Next, Source};
use super::super::title::Title;
use crate::guarded::guarded;
use crate::series::parquet::REMARKS;

/// A Parquet file that is being read.
pub(super) struct ParquetRows {
    path: PathBuf,
    reader: SerializedFileReader<File>,
    titles: Vec<Title>,
    remarks: Vec<String>,
    /// First stamp of each column that holds stamps.
    origins: Vec<Option<i64>>,
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
        let reader = SerializedFileReader::new(file).map_err(|error| wrong(&error))?;
        let metadata = reader.metadata().file_metadata();
        let schema = metadata.schema_descr();
        let titles: Vec<Title> = schema.columns().iter().map(|column| title(column)).collect();
        let texts = metadata.key_value_metadata().into_iter().flatten().filter(|pair| pair.key == REMARKS);
        let remarks = texts.filter_map(|pair| pair.value.as_deref()).flat_map(str::lines).map(str::to_owned).collect();
        let rows = u64::try_from(metadata.num_rows()).unwrap_or(0);
        let origins = vec![None; titles.len()];
        let (path, progress) = (path.to_owned(), [0, rows]);
        Ok(Self { path, reader, titles, remarks, origins, group: 0, columns: Vec::new(), row: 0, progress })
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
                let reader = group.get_column_reader(index).map_err(failed)?;
                let descriptor = group.metadata().schema_descr().column(index);
                let values = numbers(reader, &descriptor, rows, &mut self.origins[index]).map_err(failed)?;
                let values = values.ok_or_else(|| wrong(format!("{place}: it holds no numbers")))?;
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
        let is_number = |column: &ColumnDescriptor| {
            let kind = column.physical_type();
            column.max_rep_level() == 0 && matches!(kind, Type::DOUBLE | Type::FLOAT | Type::INT32 | Type::INT64)
        };
        let columns = self.reader.metadata().file_metadata().schema_descr().columns().iter().enumerate();
        columns.filter(|(_, column)| is_number(column)).map(|(index, _)| index).collect()
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

fn title(column: &ColumnDescriptor) -> Title {
    let stamps = matches!(column.logical_type_ref(), Some(LogicalType::Timestamp(_) | LogicalType::Time(_)));
    Title { stamps, ..Title::parse(column.name()) }
}

/// Seconds of one unit of a stamp.
fn tick(column: &ColumnDescriptor) -> Option<f64> {
    let (Some(LogicalType::Timestamp(stamp)) | Some(LogicalType::Time(stamp))) = column.logical_type_ref() else {
        return None;
    };
    Some(match stamp.unit {
        TimeUnit::MILLIS => 1e3,
        TimeUnit::MICROS => 1e6,
        TimeUnit::NANOS => 1e9,
    })
}

/// A column's numbers, NaN for nulls; `None` where it holds none.
fn numbers(
    reader: ColumnReader,
    column: &ColumnDescriptor,
    rows: usize,
    origin: &mut Option<i64>,
) -> Result<Option<Vec<f64>>, ParquetError> {
    if column.max_rep_level() > 0 {
        return Ok(None);
    }
    let ticks = tick(column);
    let mut whole = |value: i64| match ticks {
        Some(ticks) => value.wrapping_sub(*origin.get_or_insert(value)) as f64 / ticks,
        None => value as f64,
    };
    let most = column.max_def_level();
    Ok(Some(match reader {
        ColumnReader::DoubleColumnReader(reader) => all(reader, rows, most, |value| value)?,
        ColumnReader::FloatColumnReader(reader) => all(reader, rows, most, f64::from)?,
        ColumnReader::Int32ColumnReader(reader) => all(reader, rows, most, |value| whole(i64::from(value)))?,
        ColumnReader::Int64ColumnReader(reader) => all(reader, rows, most, whole)?,
        _ => return Ok(None),
    }))
}

fn all<T: DataType>(
    mut reader: ColumnReaderImpl<T>,
    rows: usize,
    most: i16,
    mut number: impl FnMut(T::T) -> f64,
) -> Result<Vec<f64>, ParquetError> {
    let mut numbers = Vec::new();
    let (mut values, mut levels) = (Vec::new(), Vec::new());
    while numbers.len() < rows {
        values.clear();
        levels.clear();
        let (records, ..) =
            reader.read_records((rows - numbers.len()).min(1 << 16), Some(&mut levels), None, &mut values)?;
        if records == 0 {
            break;
        }
        let mut present = values.drain(..);
        if most == 0 {
            numbers.extend(present.map(&mut number));
        } else {
            let levels = levels.iter();
            numbers.extend(
                levels
                    .map(|&level| if level == most { present.next().map_or(f64::NAN, &mut number) } else { f64::NAN }),
            );
        }
    }
    Ok(numbers)
}

/// What a library says, on one line.
fn one_line(error: &dyn std::fmt::Display) -> String {
    super::super::error::shortened(&error.to_string())
}
