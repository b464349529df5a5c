//! From a log to a file of series, row by row: neither is in memory as a whole.
//!
//! Next door: the same in memory (`mod`), the writers (`crate::series`).

use std::cell::{Cell, RefCell};
use std::io::{self, Write};
use std::path::Path;

use super::account::Account;
use super::cleaning::Cleaning;
use super::error::RecordingError;
use super::mapping::Mapping;
use super::pipeline::{Rows, Watch};
use super::{Recording, open};
use crate::output::{Output, OutputError};
use crate::series::{self, Column, Format, Run, Stream};

/// Why a log was not imported.
#[derive(Debug, thiserror::Error)]
pub enum ImportError {
    /// The log.
    #[error(transparent)]
    Log(#[from] RecordingError),
    /// The file that was to be written.
    #[error(transparent)]
    Output(#[from] OutputError),
    /// Somebody asked to stop.
    #[error("interrupted; nothing was written")]
    Interrupted,
}

/// Reads a log, mends it, and writes `name` into the folder of `output`: CSV and Parquet row by row, JSON from memory. Remarks of the log
/// stand above the columns, so that what is simulated still says so.
///
/// # Errors
/// [`ImportError`]; then nothing is written.
pub fn import(
    log: &Path,
    mapping: &Mapping,
    cleaning: &Cleaning,
    watch: &Watch<'_>,
    format: Format,
    name: &str,
    output: &mut Output,
) -> Result<Account, ImportError> {
    if format == Format::Json {
        let recording = Recording::read(log, mapping, cleaning)?;
        return write_recording(&recording, format, name, output);
    }
    let mut source = open(log, mapping)?;
    let remarks = source.remarks().to_vec();
    let rows = Rows::of(source.as_mut(), mapping, cleaning, true)?;
    let channels = rows.channels();
    let columns: Vec<(&str, &'static str)> =
        std::iter::once(("time", "s")).chain(channels.iter().map(|channel| (channel.name(), channel.unit()))).collect();
    let (stopped, fault, mut account) = (Cell::new(false), RefCell::new(None), None);
    let watched = |done, of| {
        let go_on = watch(done, of);
        stopped.set(!go_on);
        go_on
    };
    let written = output.write(name, |file| {
        let mut stream = Stream::begin(&columns, &remarks, format, file.by_ref())?;
        let mut unwritten = None;
        let cleaned = rows.clean(&watched, &mut |row, _| {
            stream.row(row.time, &row.values).map_err(|error| {
                unwritten = Some(error);
                RecordingError::of_words("cannot be written")
            })
        });
        match (unwritten, cleaned) {
            (Some(error), _) => Err(error),
            (None, Ok(done)) => {
                account = Some(done);
                stream.end()
            }
            (None, Err(error)) => {
                fault.replace(Some(error));
                Err(io::Error::other("the log cannot be read"))
            }
        }
    });
    match (stopped.get(), fault.into_inner()) {
        (true, _) => Err(ImportError::Interrupted),
        (false, Some(error)) => Err(error.into()),
        (false, None) => {
            written?;
            Ok(account.unwrap_or_default())
        }
    }
}

/// Writes a recording that is in memory, as [`import`] does a log.
///
/// # Errors
/// [`ImportError`]; then nothing is written.
pub fn write_recording(
    recording: &Recording,
    format: Format,
    name: &str,
    output: &mut Output,
) -> Result<Account, ImportError> {
    write_recording_with(recording, &[], format, name, output)
}

/// The same with more columns behind the channels, each of one value a sample; a channel of such a column's name is left out for it.
///
/// # Errors
/// [`ImportError`]; then nothing is written.
pub fn write_recording_with(
    recording: &Recording,
    more: &[Column<'_>],
    format: Format,
    name: &str,
    output: &mut Output,
) -> Result<Account, ImportError> {
    let signals = &recording.signals;
    let is_kept = |channel: &coilsense::Channel| more.iter().all(|column| column.name != channel.name());
    let channels: Vec<_> = signals.channels().filter(|(channel, _)| is_kept(channel)).collect();
    let units = channels.iter().map(|(channel, _)| (channel.name(), channel.unit()));
    let others = more.iter().map(|column| (column.name.as_ref(), column.unit));
    let columns: Vec<(&str, &'static str)> = std::iter::once(("time", "s")).chain(units).chain(others).collect();
    output.write(name, |file| {
        if format == Format::Json {
            // JSON has no comments: what says that it is simulated stands in the place of the condition.
            let mut run = Run::of(recording.simulated().unwrap_or("log"), "unknown", signals);
            run.columns.retain(|column| more.iter().all(|other| other.name != column.name));
            run.columns.extend(more.iter().cloned());
            return series::write(&[run], format, file);
        }
        let mut stream = Stream::begin(&columns, &recording.remarks, format, file.by_ref())?;
        let mut row = Vec::with_capacity(channels.len());
        for (index, &time) in signals.time().iter().enumerate() {
            row.clear();
            row.extend(channels.iter().map(|(_, values)| values[index]));
            row.extend(more.iter().map(|column| column.values[index]));
            stream.row(time, &row)?;
        }
        stream.end()
    })?;
    Ok(recording.account.clone())
}
