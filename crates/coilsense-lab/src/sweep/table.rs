//! Designs as CSV: all columns of the sweep, all digits.
//!
//! Next door: the same as Parquet (`encoded`).

use std::io::{self, Write};

use super::chunk::{Chunk, Data};
use super::dataset::Dataset;
use crate::series::text_cell;

impl Chunk {
    /// Writes titles and rows; what is not there is empty.
    pub(crate) fn write_csv(&self, to: &mut impl Write) -> io::Result<()> {
        let mut writer = ::csv::Writer::from_writer(to);
        writer.write_record(self.columns.iter().map(|(title, _)| text_cell(title).into_owned()))?;
        let columns: Vec<&Data> = self.columns.iter().map(|(_, data)| data).collect();
        write_rows(&columns, &mut writer)?;
        writer.flush()
    }
}

impl Dataset {
    /// Writes titles and the rows that are there as CSV, one chunk in memory at a time; what is not there is empty.
    ///
    /// # Errors
    /// That of what is written to; [`super::SweepError`] inside of one for a chunk that cannot be read.
    pub fn write_csv(&self, to: &mut impl Write) -> io::Result<()> {
        let mut writer = ::csv::Writer::from_writer(to);
        let titles = self.plan().titles();
        writer.write_record(titles.iter().map(|title| text_cell(title).into_owned()))?;
        let words: Vec<&str> = titles.iter().map(String::as_str).collect();
        let mut written = Ok(());
        let read = self.for_each_chunk(&words, |columns| {
            if written.is_ok() {
                written = write_rows(&columns.iter().collect::<Vec<_>>(), &mut writer);
            }
        });
        read.map_err(io::Error::other)?;
        written?;
        writer.flush()
    }
}

fn write_rows(columns: &[&Data], writer: &mut ::csv::Writer<impl Write>) -> io::Result<()> {
    for row in 0..columns.first().map_or(0, |data| data.len()) {
        let cells = columns.iter().map(|data| match data {
            Data::Texts(_) => text_cell(&cell(data, row)).into_owned(),
            _ => cell(data, row),
        });
        writer.write_record(cells)?;
    }
    Ok(())
}

/// A value with all its digits.
pub(crate) fn cell(data: &Data, row: usize) -> String {
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
