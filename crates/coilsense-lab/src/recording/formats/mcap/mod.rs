//! An MCAP file, as robots record: the numbers of its messages of JSON, each topic at the times when its messages were logged.
//!
//! | file | holds |
//! |---|---|
//! | `records` | the records of a file, those of its chunks unpacked |
//! | `json` | the numbers in a text |
//! | `topics` | the numbers of each topic's messages, field by field |
//!
//! Next door: other files of several clocks (`mdf`, `tdms`), groups on one clock (`grouped`).
//!
//! Source: "MCAP Format Specification", mcap.dev.

mod json;
mod records;
mod topics;

use std::io::BufReader;

use super::super::error::RecordingError;
use super::super::input::Input;
use super::super::table::Table;
use super::grouped::one_table;
use records::{Record, Records};
use topics::Topics;

/// Reads a file.
pub(super) fn read(input: Input) -> Result<Table, RecordingError> {
    let path = input.path().to_owned();
    let path = path.as_path();
    let wrong = |message: String| RecordingError::of_file(path, message);
    let damaged = |message: String| wrong(format!("is no MCAP file that can be read: {message}"));
    let mut topics = Topics::default();
    let mut records = Records::of(BufReader::with_capacity(1 << 16, input.stream().bytes)).map_err(damaged)?;
    while let Some(record) = records.next().map_err(damaged)? {
        match record {
            Record::Channel { number, topic, encoding } => topics.add(number, &topic, &encoding).map_err(damaged)?,
            Record::Message { channel, time, data } => topics.message(channel, time, &data).map_err(damaged)?,
        }
    }
    if let Some(advice) = topics.advice(path) {
        return Err(wrong(advice));
    }
    let cut = if records.is_cut() { ", cut off" } else { "" };
    let remarks = if records.is_cut() { vec!["the file is cut off".to_owned()] } else { Vec::new() };
    let (groups, apart) = topics.groups();
    let description = format!("MCAP, {} topics of numbers{cut}{}", groups.len(), apart.told());
    if groups.is_empty() {
        return Err(wrong(format!("has no message of numbers{}", apart.told())));
    }
    one_table(path, description, remarks, groups)
}
