//! The values of a column of Parquet in one row group, as numbers.
//!
//! Next door: what they mean (`kind`), the file (`super`).

use parquet::column::reader::{ColumnReader, ColumnReaderImpl};
use parquet::data_type::{DataType, Int96};
use parquet::errors::ParquetError;

use super::super::columnar::{Kind, half, whole};

/// A column's numbers, NaN for nulls; `most` is the level of a value that is there, `first` the column's first instant.
pub(super) fn numbers(
    reader: ColumnReader,
    kind: Kind,
    rows: usize,
    most: i16,
    first: &mut Option<i128>,
) -> Result<Vec<f64>, ParquetError> {
    let unsigned = kind == Kind::Unsigned;
    let mut number = |value: i128| kind.number(value, first);
    match reader {
        ColumnReader::DoubleColumnReader(reader) => all(reader, rows, most, |value| Some(*value)),
        ColumnReader::FloatColumnReader(reader) => all(reader, rows, most, |value| Some(f64::from(*value))),
        ColumnReader::Int32ColumnReader(reader) if unsigned => {
            all(reader, rows, most, |value| Some(f64::from(value.cast_unsigned())))
        }
        ColumnReader::Int64ColumnReader(reader) if unsigned => {
            all(reader, rows, most, |value| Some(value.cast_unsigned() as f64))
        }
        ColumnReader::Int32ColumnReader(reader) => all(reader, rows, most, |value| Some(number((*value).into()))),
        ColumnReader::Int64ColumnReader(reader) => all(reader, rows, most, |value| Some(number((*value).into()))),
        ColumnReader::Int96ColumnReader(reader) => all(reader, rows, most, |value| Some(number(nanoseconds(value)))),
        ColumnReader::FixedLenByteArrayColumnReader(reader) if kind == Kind::Half => {
            all(reader, rows, most, |value| Some(half(u16::from_le_bytes(value.data().try_into().ok()?))))
        }
        ColumnReader::FixedLenByteArrayColumnReader(reader) => {
            all(reader, rows, most, |value| Some(number(whole(value.data())?)))
        }
        ColumnReader::ByteArrayColumnReader(reader) => {
            all(reader, rows, most, |value| Some(number(whole(value.data())?)))
        }
        ColumnReader::BoolColumnReader(_) => Err(ParquetError::General("true and false are no numbers".to_owned())),
    }
}

/// Nanoseconds since 1970 of a stamp as old writers have it: the time of day, and the day of the Julian calendar.
fn nanoseconds(stamp: &Int96) -> i128 {
    const DAY_OF_1970: i128 = 2_440_588;
    let [low, high, day] = [0, 1, 2].map(|word| i128::from(stamp.data().get(word).copied().unwrap_or(0)));
    (day - DAY_OF_1970) * 86_400_000_000_000 + (high << 32 | low)
}

fn all<T: DataType>(
    mut reader: ColumnReaderImpl<T>,
    rows: usize,
    most: i16,
    mut number: impl FnMut(&T::T) -> Option<f64>,
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
        let mut present = values.iter().map(|value| {
            number(value).ok_or_else(|| ParquetError::General("a number has more than 38 digits".to_owned()))
        });
        if most == 0 {
            for value in present {
                numbers.push(value?);
            }
        } else {
            for &level in &levels {
                let value = if level == most { present.next().transpose()? } else { None };
                numbers.push(value.unwrap_or(f64::NAN));
            }
        }
    }
    Ok(numbers)
}
