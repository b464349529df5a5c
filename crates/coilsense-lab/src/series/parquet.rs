//! Series as Parquet.
//!
//! Next door: the other formats (`csv`, `json`).

use std::io;
use std::sync::Arc;

use parquet::basic::{Compression, LogicalType, Repetition, Type as Physical};
use parquet::data_type::{ByteArray, ByteArrayType, DoubleType};
use parquet::errors::ParquetError;
use parquet::file::properties::WriterProperties;
use parquet::file::writer::{SerializedFileWriter, SerializedRowGroupWriter};
use parquet::schema::types::Type;

use super::Run;

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
    let number =
        |name: &str| Type::primitive_type_builder(name, Physical::DOUBLE).with_repetition(Repetition::REQUIRED).build();
    let mut fields = vec![Arc::new(label("condition")?), Arc::new(label("damping")?)];
    for column in &run.columns {
        fields.push(Arc::new(number(&column.title())?));
    }
    Ok(Arc::new(Type::group_type_builder("signals").with_fields(fields).build()?))
}
