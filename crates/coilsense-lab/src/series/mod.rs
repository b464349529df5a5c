//! Series on disk: signals and readings as CSV, Parquet or JSON, from one writer.
//!
//! Next door: where they come from (`analysis`, `reproduce`), how files come to disk whole (`output`).

mod cell;
mod csv;
mod json;
#[cfg(feature = "parquet")]
pub(crate) mod parquet;
mod stream;

pub(crate) use cell::text_cell;
pub use stream::Stream;

use std::borrow::Cow;
use std::io;

use coilsense::Signals;

/// A format of series on disk.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Format {
    /// Comma-separated values: a header `name [unit]`, one row per sample, each number with the digits that bring back the same double.
    Csv,
    /// JSON with `schema`, one object per run, one array per column.
    Json,
    /// Parquet: a row group per run, every number a 64-bit double.
    #[cfg(feature = "parquet")]
    Parquet,
}

impl Format {
    /// Every format, by the ending of its files.
    pub const ALL: &[(&'static str, Self)] = &[
        ("csv", Self::Csv),
        ("json", Self::Json),
        #[cfg(feature = "parquet")]
        ("parquet", Self::Parquet),
    ];

    /// The format of a file's ending, without the dot.
    pub fn of_ending(ending: &str) -> Option<Self> {
        Self::ALL.iter().find(|(name, _)| *name == ending).map(|(_, format)| *format)
    }
}

/// One column: a quantity over time.
#[derive(Debug, Clone, PartialEq)]
pub struct Column<'a> {
    /// Its name, such as `F_i` or a sensor's.
    pub name: Cow<'a, str>,
    /// Its SI unit.
    pub unit: &'static str,
    /// Its values, shape `samples`.
    pub values: Cow<'a, [f64]>,
}

/// What was simulated or measured in one go: columns of one length.
#[derive(Debug, Clone, PartialEq)]
pub struct Run<'a> {
    /// The condition of use.
    pub condition: Cow<'a, str>,
    /// The damping.
    pub damping: Cow<'a, str>,
    /// Time first.
    pub columns: Vec<Column<'a>>,
}

impl<'a> Run<'a> {
    /// Time and all channels of `signals`.
    pub fn of(condition: &'a str, damping: &'a str, signals: &'a Signals) -> Self {
        let mut columns = vec![Column::new("time", "s", signals.time())];
        columns.extend(signals.channels().map(|(channel, values)| Column::new(channel.name(), channel.unit(), values)));
        Self { condition: condition.into(), damping: damping.into(), columns }
    }

    /// How many samples it has.
    pub fn samples(&self) -> usize {
        self.columns.first().map_or(0, |column| column.values.len())
    }
}

impl<'a> Column<'a> {
    /// A column of borrowed values.
    pub fn new(name: impl Into<Cow<'a, str>>, unit: &'static str, values: &'a [f64]) -> Self {
        Self { name: name.into(), unit, values: values.into() }
    }

    /// `F_i [N]`.
    fn title(&self) -> String {
        format!("{} [{}]", self.name, self.unit)
    }
}

/// A name in snake case, as JSON's keys have it: two columns of one unit must differ in it.
pub(crate) fn key_of(name: &str) -> String {
    let plain = |c: char| if c.is_alphanumeric() { c } else { '_' };
    name.to_lowercase().chars().map(plain).collect()
}

/// Writes runs, which all have the same columns. CSV of a single run has numbers only; of several, `condition` and `damping` come first, as
/// they always do in Parquet.
///
/// # Errors
/// What the writer says.
pub fn write(runs: &[Run<'_>], format: Format, out: &mut (impl io::Write + Send)) -> io::Result<()> {
    match format {
        Format::Csv => csv::write(runs, out),
        Format::Json => json::write(runs, out),
        #[cfg(feature = "parquet")]
        Format::Parquet => parquet::write(runs, out),
    }
}
