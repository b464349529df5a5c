//! What a column of Parquet holds: its types, old and new, and what Arrow notes beside them.
//!
//! Next door: its values (`values`), what they mean (`super::super::columnar`).

use std::collections::HashMap;

use parquet::basic::{ConvertedType, LogicalType, TimeUnit, Type};
use parquet::schema::types::ColumnDescriptor;

use super::super::columnar::Kind;

/// What a column's numbers mean, or what it holds in place of numbers.
pub(super) fn kind(column: &ColumnDescriptor, durations: &HashMap<String, i32>) -> Result<Kind, &'static str> {
    if column.max_rep_level() > 0 {
        return Err("lists");
    }
    let physical = column.physical_type();
    if matches!(physical, Type::INT32 | Type::INT64)
        && let Some(digits) = durations.get(column.path().string().as_str())
    {
        return Ok(Kind::Duration(*digits));
    }
    match column.logical_type_ref() {
        Some(LogicalType::Decimal(decimal)) => Ok(Kind::Decimal(decimal.scale)),
        Some(LogicalType::Integer(whole)) if !whole.is_signed => Ok(Kind::Unsigned),
        Some(LogicalType::Timestamp(stamp)) => Ok(Kind::Stamp(digits(&stamp.unit))),
        Some(LogicalType::Time(time)) => Ok(Kind::Stamp(digits(&time.unit))),
        Some(LogicalType::Date) => Ok(Kind::Day),
        Some(LogicalType::Float16) => Ok(Kind::Half),
        Some(LogicalType::Unknown) => Err("nothing"),
        _ => by_old_types(column),
    }
}

/// By the types that stand in files beside the new ones, or in their place.
fn by_old_types(column: &ColumnDescriptor) -> Result<Kind, &'static str> {
    use ConvertedType::{
        DATE, DECIMAL, INTERVAL, TIME_MICROS, TIME_MILLIS, TIMESTAMP_MICROS, TIMESTAMP_MILLIS, UINT_8, UINT_16,
        UINT_32, UINT_64,
    };
    match (column.converted_type(), column.physical_type()) {
        (UINT_8 | UINT_16 | UINT_32 | UINT_64, _) => Ok(Kind::Unsigned),
        (DECIMAL, _) => Ok(Kind::Decimal(column.type_scale())),
        (TIMESTAMP_MILLIS | TIME_MILLIS, _) => Ok(Kind::Stamp(3)),
        (TIMESTAMP_MICROS | TIME_MICROS, _) => Ok(Kind::Stamp(6)),
        (DATE, _) => Ok(Kind::Day),
        (INTERVAL, _) => Err("stretches of months and days"),
        (_, Type::INT96) => Ok(Kind::Stamp(9)),
        (_, Type::BOOLEAN) => Err("true and false"),
        (_, Type::BYTE_ARRAY | Type::FIXED_LEN_BYTE_ARRAY) => Err("texts"),
        _ => Ok(Kind::Plain),
    }
}

/// Digits of a second behind the point.
fn digits(unit: &TimeUnit) -> i32 {
    match unit {
        TimeUnit::MILLIS => 3,
        TimeUnit::MICROS => 6,
        TimeUnit::NANOS => 9,
    }
}

/// Columns that are stretches of time, which Parquet itself does not know, and the digits of their seconds: by the schema that Arrow's writers put
/// beside the data.
#[cfg(feature = "arrow")]
pub(super) fn durations(schema: Option<&str>) -> HashMap<String, i32> {
    use base64::Engine;
    let bytes = schema.and_then(|text| base64::engine::general_purpose::STANDARD.decode(text).ok());
    let schema = bytes.and_then(|bytes| arrow_ipc::convert::try_schema_from_ipc_buffer(&bytes).ok());
    let fields = schema.iter().flat_map(|schema| schema.fields().iter());
    fields.filter_map(|field| Some((field.name().clone(), super::super::arrow::duration(field.data_type())?))).collect()
}

/// The same without a reader of Arrow's schemas.
#[cfg(not(feature = "arrow"))]
pub(super) fn durations(_schema: Option<&str>) -> HashMap<String, i32> {
    HashMap::new()
}
