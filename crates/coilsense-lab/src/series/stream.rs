//! Series that come row by row and need not fit into memory: CSV and Parquet.
//!
//! Next door: series that are there as a whole (`csv`, `json`, `parquet`).

use std::io::{self, Write};

use super::{Format, text_cell};

/// Where rows of numbers go.
pub struct Stream<W: Write + Send> {
    inner: Inner<W>,
}

enum Inner<W: Write + Send> {
    Csv(W),
    #[cfg(feature = "parquet")]
    Parquet(Box<super::parquet::Groups<W>>),
}

impl<W: Write + Send> Stream<W> {
    /// Begins a file with columns of these names and SI units; `remarks` stand above them, in Parquet in the file's metadata.
    ///
    /// # Errors
    /// What the writer says; JSON, which holds each column as a whole, cannot be written row by row.
    pub fn begin(columns: &[(&str, &'static str)], remarks: &[String], format: Format, out: W) -> io::Result<Self> {
        let titles = || columns.iter().map(|(name, unit)| format!("{name} [{unit}]"));
        let inner = match format {
            Format::Csv => {
                let mut out = out;
                for remark in remarks {
                    writeln!(out, "# {remark}")?;
                }
                let titles = titles().map(|title| text_cell(&title).into_owned());
                writeln!(out, "{}", titles.collect::<Vec<_>>().join(","))?;
                Inner::Csv(out)
            }
            #[cfg(feature = "parquet")]
            Format::Parquet => Inner::Parquet(Box::new(super::parquet::Groups::begin(titles(), remarks, out)?)),
            Format::Json => return Err(io::Error::other("JSON cannot be written row by row")),
        };
        Ok(Self { inner })
    }

    /// Adds a row: one number per column.
    ///
    /// # Errors
    /// What the writer says.
    pub fn row(&mut self, first: f64, others: &[f64]) -> io::Result<()> {
        match &mut self.inner {
            Inner::Csv(out) => {
                write!(out, "{first}")?;
                others.iter().try_for_each(|value| write!(out, ",{value}"))?;
                out.write_all(b"\n")
            }
            #[cfg(feature = "parquet")]
            Inner::Parquet(groups) => groups.row(first, others),
        }
    }

    /// Ends the file.
    ///
    /// # Errors
    /// What the writer says.
    pub fn end(self) -> io::Result<()> {
        match self.inner {
            Inner::Csv(mut out) => out.flush(),
            #[cfg(feature = "parquet")]
            Inner::Parquet(groups) => groups.end(),
        }
    }
}
