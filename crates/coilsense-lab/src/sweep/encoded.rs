//! Columns as the bytes of a Parquet file, and back.
//!
//! Next door: the columns (`chunk`), what a file says of itself (`seal`), the files (`dataset`).

use std::path::Path;
use std::sync::Arc;

use bytes::Bytes;

use parquet::basic::{Compression, LogicalType, Repetition, Type as Physical};
use parquet::data_type::{BoolType, ByteArray, ByteArrayType, DataType, DoubleType, Int64Type};
use parquet::errors::ParquetError;
use parquet::file::metadata::KeyValue;
use parquet::file::properties::WriterProperties;
use parquet::file::reader::{FileReader, SerializedFileReader};
use parquet::file::writer::{SerializedFileWriter, SerializedRowGroupWriter};
use parquet::schema::types::Type;

use super::SweepError;
use super::chunk::{Chunk, Data};
use super::plan::Plan;
use super::seal::{self, Seal};
use crate::guarded::guarded;

impl Chunk {
    /// The bytes of its file: one row group; numbers and truths that are not there are null.
    ///
    /// # Errors
    /// [`SweepError`] with what the writer says.
    pub fn to_parquet(&self) -> Result<Vec<u8>, SweepError> {
        self.written(None).map_err(|error| SweepError::of("a chunk as Parquet", error.to_string()))
    }

    /// The same as a chunk of a sweep, which says of itself what it is.
    pub(super) fn sealed(&self, seal: &Seal) -> Result<Vec<u8>, SweepError> {
        let refused = |why: String| SweepError::of("a chunk as Parquet", why);
        let mut bytes = self.written(Some(seal.open())).map_err(|error| refused(error.to_string()))?;
        match seal::close(&mut bytes) {
            true => Ok(bytes),
            false => Err(refused("its footer has no place for a digest".to_owned())),
        }
    }

    fn written(&self, metadata: Option<Vec<KeyValue>>) -> Result<Vec<u8>, ParquetError> {
        let fields = self.columns.iter().map(|(title, data)| field(title, data).map(Arc::new));
        let fields = fields.collect::<Result<Vec<_>, _>>()?;
        let schema = Arc::new(Type::group_type_builder("sweep").with_fields(fields).build()?);
        let properties = WriterProperties::builder().set_compression(Compression::SNAPPY);
        let properties = properties.set_key_value_metadata(metadata).build();
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
    /// What a chunk's file says of itself, in a sweep of some digest.
    pub(super) fn seal(&self, chunk: u64, digest: String) -> Seal {
        Seal { plan: digest, chunk, rows: self.rows_of(chunk) }
    }

    /// The bytes of a chunk's file; `None` where `go_on` says no.
    ///
    /// # Errors
    /// As [`Plan::chunk`], and what the writer says.
    pub fn chunk_bytes(&self, index: u64, go_on: &(dyn Fn() -> bool + Sync)) -> Result<Option<Vec<u8>>, SweepError> {
        self.chunk(index, go_on)?.map(|chunk| chunk.sealed(&self.seal(index, self.digest()))).transpose()
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

/// Why a file cannot be taken for a chunk, said after its name.
type Fault = String;

/// Whether a file's bytes are those of a chunk as it was written.
pub(super) fn check(file: &Path, bytes: Vec<u8>, seal: &Seal) -> Result<(), Fault> {
    opened(file, bytes, seal).map(|_| ())
}

/// Some columns of a chunk, by their titles, in their order; `None` of those that are not there.
pub(super) fn read(file: &Path, bytes: Vec<u8>, seal: &Seal, titles: &[&str]) -> Result<Vec<Option<Data>>, Fault> {
    let reader = opened(file, bytes, seal)?;
    let columns = || titles.iter().map(|title| one(&reader, title).map_err(|error| unreadable(&error))).collect();
    guarded(file, columns)
}

/// A chunk whose bytes are whole, and which is the one that is looked for.
fn opened(file: &Path, bytes: Vec<u8>, seal: &Seal) -> Result<SerializedFileReader<Bytes>, Fault> {
    seal::whole(&bytes)?;
    let reader = guarded(file, || SerializedFileReader::new(Bytes::from(bytes)).map_err(|error| unreadable(&error)))?;
    let metadata = reader.metadata().file_metadata();
    seal.check(metadata.key_value_metadata().map_or(&[], Vec::as_slice))?;
    let (there, wanted) = (metadata.num_rows(), seal.rows.end - seal.rows.start);
    match u64::try_from(there) == Ok(wanted) {
        true => Ok(reader),
        false => Err(format!("has {there} rows instead of {wanted}")),
    }
}

fn unreadable(error: &ParquetError) -> Fault {
    format!("cannot be read: {}", error.to_string().replace('\n', " "))
}

fn one(reader: &SerializedFileReader<Bytes>, title: &str) -> Result<Option<Data>, ParquetError> {
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
