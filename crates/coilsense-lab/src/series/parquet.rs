//! Series as Parquet.
//!
//! Next door: the other formats (`csv`, `json`), rows one by one in any of them (`stream`).

use std::io;
use std::sync::Arc;

use parquet::basic::{Compression, LogicalType, Repetition, Type as Physical};
use parquet::data_type::{ByteArray, ByteArrayType, DoubleType};
use parquet::errors::ParquetError;
use parquet::file::metadata::KeyValue;
use parquet::file::properties::WriterProperties;
use parquet::file::writer::{SerializedFileWriter, SerializedRowGroupWriter};
use parquet::schema::types::Type;

use super::Run;

/// Rows in each group of a file that is written row by row: 4 MB a column stay in memory.
const GROUP: usize = 1 << 19;

/// Key under which a file's remarks stand in its metadata, one a line.
pub(crate) const REMARKS: &str = "coilsense.remarks";

/// A Parquet file of numbers that is written row by row.
pub(super) struct Groups<W: io::Write + Send> {
    writer: SerializedFileWriter<W>,
    columns: Vec<Vec<f64>>,
}

impl<W: io::Write + Send> Groups<W> {
    pub fn begin(titles: impl Iterator<Item = String>, remarks: &[String], out: W) -> io::Result<Self> {
        let fields: Result<Vec<Arc<Type>>, ParquetError> = titles.map(|title| number(&title).map(Arc::new)).collect();
        let fields = fields.map_err(io::Error::other)?;
        let columns = vec![Vec::new(); fields.len()];
        let schema = Type::group_type_builder("signals").with_fields(fields).build().map_err(io::Error::other)?;
        let pairs = (!remarks.is_empty()).then(|| vec![KeyValue::new(REMARKS.to_owned(), remarks.join("\n"))]);
        let properties =
            WriterProperties::builder().set_compression(Compression::SNAPPY).set_key_value_metadata(pairs).build();
        let writer =
            SerializedFileWriter::new(out, Arc::new(schema), Arc::new(properties)).map_err(io::Error::other)?;
        Ok(Self { writer, columns })
    }

    pub fn row(&mut self, first: f64, others: &[f64]) -> io::Result<()> {
        for (column, value) in self.columns.iter_mut().zip(std::iter::once(&first).chain(others)) {
            column.push(*value);
        }
        if self.columns.first().is_some_and(|column| column.len() == GROUP) { self.flush() } else { Ok(()) }
    }

    pub fn end(mut self) -> io::Result<()> {
        self.flush()?;
        self.writer.close().map(|_| ()).map_err(io::Error::other)
    }

    fn flush(&mut self) -> io::Result<()> {
        if self.columns.first().is_none_or(Vec::is_empty) {
            return Ok(());
        }
        let mut write = || -> Result<(), ParquetError> {
            let mut group = self.writer.next_row_group()?;
            for values in &self.columns {
                if let Some(mut next) = group.next_column()? {
                    next.typed::<DoubleType>().write_batch(values, None, None)?;
                    next.close()?;
                }
            }
            group.close().map(|_| ())
        };
        write().map_err(io::Error::other)?;
        self.columns.iter_mut().for_each(Vec::clear);
        Ok(())
    }
}

/// A row group for each run; columns `condition`, `damping`, then the numbers under their titles.
pub(super) fn write(runs: &[Run<'_>], out: &mut (impl io::Write + Send)) -> io::Result<()> {
    let Some(first) = runs.first() else { return Ok(()) };
    rows(runs, first, out).map_err(io::Error::other)
}

fn rows(runs: &[Run<'_>], first: &Run<'_>, out: &mut (impl io::Write + Send)) -> Result<(), ParquetError> {
    let properties = WriterProperties::builder().set_compression(Compression::SNAPPY).build();
    let mut writer = SerializedFileWriter::new(out, schema(first)?, Arc::new(properties))?;
    for run in runs {
        let mut group = writer.next_row_group()?;
        for label in [&run.condition, &run.damping] {
            let values = vec![ByteArray::from(label.as_bytes().to_vec()); run.samples()];
            label_column(&mut group, &values)?;
        }
        for column in &run.columns {
            if let Some(mut next) = group.next_column()? {
                next.typed::<DoubleType>().write_batch(&column.values, None, None)?;
                next.close()?;
            }
        }
        group.close()?;
    }
    writer.close().map(|_| ())
}

fn label_column<W: io::Write + Send>(
    group: &mut SerializedRowGroupWriter<'_, W>,
    values: &[ByteArray],
) -> Result<(), ParquetError> {
    let Some(mut column) = group.next_column()? else { return Ok(()) };
    column.typed::<ByteArrayType>().write_batch(values, None, None)?;
    column.close()
}

fn schema(run: &Run<'_>) -> Result<Arc<Type>, ParquetError> {
    let label = |name: &str| {
        Type::primitive_type_builder(name, Physical::BYTE_ARRAY)
            .with_logical_type(Some(LogicalType::String))
            .with_repetition(Repetition::REQUIRED)
            .build()
    };
    let mut fields = vec![Arc::new(label("condition")?), Arc::new(label("damping")?)];
    for column in &run.columns {
        fields.push(Arc::new(number(&column.title())?));
    }
    Ok(Arc::new(Type::group_type_builder("signals").with_fields(fields).build()?))
}

fn number(name: &str) -> Result<Type, ParquetError> {
    Type::primitive_type_builder(name, Physical::DOUBLE).with_repetition(Repetition::REQUIRED).build()
}
