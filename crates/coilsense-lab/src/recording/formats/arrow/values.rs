//! What a column of Arrow's holds, and its numbers in one record batch.
//!
//! Next door: what numbers mean (`super::super::columnar`), the batches (`super`).

use arrow_array::cast::AsArray;
use arrow_array::types::{
    ArrowPrimitiveType, Decimal128Type, Decimal256Type, Float16Type, Float32Type, Float64Type, Int8Type, Int16Type,
    Int32Type, Int64Type, UInt8Type, UInt16Type, UInt32Type, UInt64Type,
};
use arrow_array::{Array, ArrayRef, make_array};
use arrow_schema::{DataType, TimeUnit};

use super::super::super::error::shortened;
use super::super::columnar::{Kind, half, whole};

/// What a column's numbers mean, or what it holds in place of numbers.
pub(super) fn kind(data: &DataType) -> Result<Kind, &'static str> {
    use DataType::{
        Boolean, Date32, Date64, Decimal32, Decimal64, Decimal128, Decimal256, Dictionary, Float16, Float32, Float64,
        Int8, Int16, Int32, Int64, Interval, LargeUtf8, Null, Time32, Time64, Timestamp, UInt8, UInt16, UInt32, UInt64,
        Utf8, Utf8View,
    };
    match data {
        Int8 | Int16 | Int32 | Int64 | Float32 | Float64 => Ok(Kind::Plain),
        UInt8 | UInt16 | UInt32 | UInt64 => Ok(Kind::Unsigned),
        Float16 => Ok(Kind::Half),
        Decimal32(_, scale) | Decimal64(_, scale) | Decimal128(_, scale) | Decimal256(_, scale) => {
            Ok(Kind::Decimal((*scale).into()))
        }
        Timestamp(unit, _) | Time32(unit) | Time64(unit) => Ok(Kind::Stamp(digits(*unit))),
        Date32 => Ok(Kind::Day),
        Date64 => Ok(Kind::Stamp(3)),
        Dictionary(_, inner) => kind(inner),
        Boolean => Err("true and false"),
        Utf8 | LargeUtf8 | Utf8View => Err("texts"),
        Interval(_) => Err("stretches of months and days"),
        Null => Err("nothing"),
        _ => duration(data).map(Kind::Duration).ok_or("lists or the like"),
    }
}

/// Digits of a second behind the point, of a stretch of time.
pub(in super::super) fn duration(data: &DataType) -> Option<i32> {
    match data {
        DataType::Duration(unit) => Some(digits(*unit)),
        _ => None,
    }
}

fn digits(unit: TimeUnit) -> i32 {
    match unit {
        TimeUnit::Second => 0,
        TimeUnit::Millisecond => 3,
        TimeUnit::Microsecond => 6,
        TimeUnit::Nanosecond => 9,
    }
}

/// A column's numbers, NaN where there is none; `first` is its first instant.
pub(super) fn numbers(array: &ArrayRef, kind: Kind, first: &mut Option<i128>) -> Result<Vec<f64>, String> {
    if let Some(pairs) = array.as_any_dictionary_opt() {
        let values = numbers(pairs.values(), kind, first)?;
        let keys = if values.is_empty() { vec![0; pairs.len()] } else { pairs.normalized_keys() };
        let number = |(row, key): (usize, usize)| match pairs.keys().is_null(row) {
            true => f64::NAN,
            false => values.get(key).copied().unwrap_or(f64::NAN),
        };
        return Ok(keys.into_iter().enumerate().map(number).collect());
    }
    let mut number = |value: i128| kind.number(value, first);
    let mut is_too_long = false;
    let found = match array.data_type() {
        DataType::Float64 => all::<Float64Type>(array, |value| value),
        DataType::Float32 => all::<Float32Type>(array, f64::from),
        DataType::Float16 => all::<Float16Type>(array, |value| half(value.to_bits())),
        DataType::Int64 => all::<Int64Type>(array, |value| value as f64),
        DataType::UInt64 => all::<UInt64Type>(array, |value| value as f64),
        DataType::Int32 => all::<Int32Type>(array, f64::from),
        DataType::UInt32 => all::<UInt32Type>(array, f64::from),
        DataType::Int16 => all::<Int16Type>(array, f64::from),
        DataType::UInt16 => all::<UInt16Type>(array, f64::from),
        DataType::Int8 => all::<Int8Type>(array, f64::from),
        DataType::UInt8 => all::<UInt8Type>(array, f64::from),
        DataType::Decimal128(..) => all::<Decimal128Type>(array, number),
        DataType::Decimal256(..) => all::<Decimal256Type>(array, |value| {
            whole(&value.to_be_bytes()).map(&mut number).unwrap_or_else(|| {
                is_too_long = true;
                f64::NAN
            })
        }),
        DataType::Time32(_) | DataType::Date32 | DataType::Decimal32(..) => {
            all::<Int32Type>(&stored(array, DataType::Int32)?, |value| number(value.into()))
        }
        _ => all::<Int64Type>(&stored(array, DataType::Int64)?, |value| number(value.into())),
    };
    match found {
        Some(_) if is_too_long => Err("a number has more than 38 digits".to_owned()),
        Some(found) => Ok(found),
        None => Err("it holds no numbers".to_owned()),
    }
}

/// An array of instants or the like as the whole numbers by which they are stored.
fn stored(array: &ArrayRef, kind: DataType) -> Result<ArrayRef, String> {
    let data = array.to_data().into_builder().data_type(kind).build();
    data.map(make_array).map_err(|error| shortened(&error.to_string()))
}

fn all<T: ArrowPrimitiveType>(array: &ArrayRef, mut number: impl FnMut(T::Native) -> f64) -> Option<Vec<f64>> {
    let array = array.as_primitive_opt::<T>()?;
    let value = |row| if array.is_null(row) { f64::NAN } else { number(array.value(row)) };
    Some((0..array.len()).map(value).collect())
}
