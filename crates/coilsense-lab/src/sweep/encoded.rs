//! Columns as the bytes of a Parquet file, and back.
//!
//! Next door: the columns (`chunk`), the files (`dataset`).

use std::fs::File;
use std::path::Path;
use std::sync::Arc;

use parquet::basic::{Compression, LogicalType, Repetition, Type as Physical};
use parquet::data_type::{BoolType, ByteArray, ByteArrayType, DataType, DoubleType, Int64Type};
use parquet::errors::ParquetError;
use parquet::file::properties::WriterProperties;
use parquet::file::reader::{FileReader, SerializedFileReader};
use parquet::file::writer::{SerializedFileWriter, SerializedRowGroupWriter};
use parquet::schema::types::Type;

use super::SweepError;
use super::chunk::{Chunk, Data};
use super::plan::Plan;

impl Chunk {
    /// The bytes of its file: one row group; numbers and truths that are not there are null.
    ///
    /// # Errors
    /// [`SweepError`] with what the writer says.
    pub fn to_parquet(&self) -> Result<Vec<u8>, SweepError> {
        self.written().map_err(|error| SweepError::of("a chunk as Parquet", error.to_string()))
    }

    fn written(&self) -> Result<Vec<u8>, ParquetError> {
        let fields = self.columns.iter().map(|(title, data)| field(title, data).map(Arc::new));
        let fields = fields.collect::<Result<Vec<_>, _>>()?;
        let schema = Arc::new(Type::group_type_builder("sweep").with_fields(fields).build()?);
        let properties = WriterProperties::builder().set_compression(Compression::SNAPPY).build();
        let mut bytes = Vec::new();
        let mut writer = SerializedFileWriter::new(&mut bytes, schema, Arc::new(properties))?;
        let mut group = writer.next_row_group()?;
        for (_, data) in &self.columns {
            column(&mut group, data)?;
        }
        group.close()?;
        writer.close()?;
        Ok(bytes)
    }
}

impl Plan {
    /// The bytes of a chunk's file; `None` where `go_on` says no.
    ///
    /// # Errors
    /// As [`Plan::chunk`] and [`Chunk::to_parquet`].
    pub fn chunk_bytes(&self, index: u64, go_on: &(dyn Fn() -> bool + Sync)) -> Result<Option<Vec<u8>>, SweepError> {
        self.chunk(index, go_on)?.map(|chunk| chunk.to_parquet()).transpose()
    }
}

fn field(title: &str, data: &Data) -> Result<Type, ParquetError> {
    let (physical, repetition) = match data {
        Data::Whole(_) => (Physical::INT64, Repetition::REQUIRED),
        Data::Numbers(_) => (Physical::DOUBLE, Repetition::OPTIONAL),
        Data::Texts(_) => (Physical::BYTE_ARRAY, Repetition::REQUIRED),
        Data::Flags(_) => (Physical::BOOLEAN, Repetition::OPTIONAL),
    };
    let logical = matches!(data, Data::Texts(_)).then_some(LogicalType::String);
    Type::primitive_type_builder(title, physical).with_repetition(repetition).with_logical_type(logical).build()
}

fn column(group: &mut SerializedRowGroupWriter<'_, &mut Vec<u8>>, data: &Data) -> Result<(), ParquetError> {
    match data {
        Data::Whole(values) => values_of::<Int64Type>(group, values, None),
        Data::Numbers(values) => {
            let there: Vec<f64> = values.iter().copied().filter(|value| !value.is_nan()).collect();
            let levels: Vec<i16> = values.iter().map(|value| i16::from(!value.is_nan())).collect();
            values_of::<DoubleType>(group, &there, Some(&levels))
        }
        Data::Texts(values) => {
            let bytes: Vec<ByteArray> = values.iter().map(|text| ByteArray::from(text.as_bytes().to_vec())).collect();
            values_of::<ByteArrayType>(group, &bytes, None)
        }
        Data::Flags(values) => {
            let there: Vec<bool> = values.iter().flatten().copied().collect();
            let levels: Vec<i16> = values.iter().map(|value| i16::from(value.is_some())).collect();
            values_of::<BoolType>(group, &there, Some(&levels))
        }
    }
}

fn values_of<T: DataType>(
    group: &mut SerializedRowGroupWriter<'_, &mut Vec<u8>>,
    values: &[T::T],
    levels: Option<&[i16]>,
) -> Result<(), ParquetError> {
    let Some(mut column) = group.next_column()? else { return Ok(()) };
    column.typed::<T>().write_batch(values, levels, None)?;
    column.close()
}

/// Some columns of a file, by their titles, in their order; `None` of those that are not there.
pub(super) fn read(path: &Path, titles: &[&str]) -> Result<Vec<Option<Data>>, SweepError> {
    let fault = |error: ParquetError| SweepError::new(format!("{}: cannot be read: {error}", path.display()));
    let file =
        File::open(path).map_err(|error| SweepError::new(format!("{}: cannot be read: {error}", path.display())))?;
    let reader = SerializedFileReader::new(file).map_err(fault)?;
    titles.iter().map(|title| one(&reader, title).map_err(fault)).collect()
}

fn one(reader: &SerializedFileReader<File>, title: &str) -> Result<Option<Data>, ParquetError> {
    let metadata = reader.metadata();
    let schema = metadata.file_metadata().schema_descr();
    let Some(index) = schema.columns().iter().position(|column| column.name() == title) else { return Ok(None) };
    let mut data = match schema.column(index).physical_type() {
        Physical::INT64 => Data::Whole(Vec::new()),
        Physical::DOUBLE => Data::Numbers(Vec::new()),
        Physical::BOOLEAN => Data::Flags(Vec::new()),
        _ => Data::Texts(Vec::new()),
    };
    for group in 0..reader.num_row_groups() {
        let group = reader.get_row_group(group)?;
        let rows = usize::try_from(group.metadata().num_rows()).unwrap_or(0);
        let column = group.get_column_reader(index)?;
        match &mut data {
            Data::Whole(values) => values.extend(levelled::<Int64Type>(column, rows)?.into_iter().flatten()),
            Data::Numbers(values) => {
                let read = levelled::<DoubleType>(column, rows)?;
                values.extend(read.into_iter().map(|value| value.unwrap_or(f64::NAN)));
            }
            Data::Flags(values) => values.extend(levelled::<BoolType>(column, rows)?),
            Data::Texts(values) => {
                let text = |bytes: Option<ByteArray>| {
                    bytes.map_or_else(String::new, |bytes| String::from_utf8_lossy(bytes.data()).into_owned())
                };
                values.extend(levelled::<ByteArrayType>(column, rows)?.into_iter().map(text));
            }
        }
    }
    Ok(Some(data))
}

/// The values of a column, `None` where one is null.
fn levelled<T: DataType>(
    column: parquet::column::reader::ColumnReader,
    rows: usize,
) -> Result<Vec<Option<T::T>>, ParquetError> {
    let mut reader = parquet::column::reader::get_typed_column_reader::<T>(column);
    let (mut values, mut levels) = (Vec::with_capacity(rows), Vec::with_capacity(rows));
    while reader.read_records(rows, Some(&mut levels), None, &mut values)?.0 > 0 {}
    if levels.is_empty() {
        return Ok(values.into_iter().map(Some).collect());
    }
    let mut values = values.into_iter();
    Ok(levels.into_iter().map(|level| if level > 0 { values.next() } else { None }).collect())
}
