//! Designs as CSV: all columns of the sweep, all digits.
//!
//! Next door: the same as Parquet (`crate::sweep::Chunk::to_parquet`).

use std::io::{self, Write};

use crate::series::text_cell;
use crate::sweep::{Chunk, Data};

/// Writes titles and rows; what is not there is empty.
pub(super) fn write(chunk: &Chunk, to: &mut impl Write) -> io::Result<()> {
    let mut writer = ::csv::Writer::from_writer(to);
    writer.write_record(chunk.columns.iter().map(|(title, _)| text_cell(title).into_owned()))?;
    let rows = chunk.columns.first().map_or(0, |(_, data)| data.len());
    for row in 0..rows {
        let cells = chunk.columns.iter().map(|(_, data)| match data {
            Data::Texts(_) => text_cell(&cell(data, row)).into_owned(),
            _ => cell(data, row),
        });
        writer.write_record(cells)?;
    }
    writer.flush()
}

/// A value with all its digits.
pub(super) fn cell(data: &Data, row: usize) -> String {
    match data {
        Data::Whole(values) => values.get(row).map_or_else(String::new, i64::to_string),
        Data::Numbers(values) => {
            values.get(row).filter(|value| !value.is_nan()).map_or_else(String::new, |value| format!("{value:?}"))
        }
        Data::Texts(values) => values.get(row).cloned().unwrap_or_default(),
        Data::Flags(values) => values
            .get(row)
            .copied()
            .flatten()
            .map_or_else(String::new, |flag| if flag { "yes" } else { "no" }.to_owned()),
    }
}
