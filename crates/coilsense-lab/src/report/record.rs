//! What of a record is whole, and what is asked for: as text and as JSON.
//!
//! Next door: what is looked at (`crate::record`).

use std::path::Path;

use serde::Serialize;

use super::outcome::{Outcome, to_json};
use crate::record::{Check, Record, State};

/// What was looked at in a record of a real spring.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "reference", derive(schemars::JsonSchema))]
pub struct RecordOutcome<'a> {
    /// Where the record is.
    pub folder: &'a Path,
    /// The archive that was written; null where none was.
    pub out: Option<&'a Path>,
    /// Whether nothing is missing, so that it may be sent.
    pub whole: bool,
    /// What was looked at, in order.
    pub checks: Vec<CheckRow<'a>>,
}

/// Something that was looked at.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "reference", derive(schemars::JsonSchema))]
pub struct CheckRow<'a> {
    /// A key of `record.toml`, a log, or what all logs together should hold.
    pub of: &'a str,
    /// `ok`, `doubtful` (may be sent, and is worth less) or `missing` (cannot be sent).
    pub state: &'static str,
    /// What was found, or what to do.
    pub says: &'a str,
}

impl<'a> From<&'a Check> for CheckRow<'a> {
    fn from(check: &'a Check) -> Self {
        Self { of: &check.of, state: check.state.name(), says: &check.says }
    }
}

impl Outcome for RecordOutcome<'_> {
    const SCHEMA: &'static str = "coilsense/record/1";
}

/// As machines read it.
///
/// # Errors
/// What `serde_json` says.
pub fn record_json(record: &Record, folder: &Path, out: Option<&Path>) -> Result<String, serde_json::Error> {
    let checks = record.checks.iter().map(CheckRow::from).collect();
    to_json(RecordOutcome { folder, out, whole: record.is_whole(), checks })
}

/// As people read it: the answer, then each thing, what is wrong first.
pub fn record_text(record: &Record) -> String {
    let of = |state: State| record.checks.iter().filter(move |check| check.state == state);
    let (missing, doubtful) = (of(State::Missing).count(), of(State::Doubtful).count());
    let mut text = match (missing, doubtful) {
        (0, 0) => "The record is whole.\n".to_owned(),
        (0, count) => format!("The record may be sent; {count} of its parts would make it worth more.\n"),
        (count, _) => format!("The record cannot be sent yet: {count} of its parts are missing.\n"),
    };
    for check in [State::Missing, State::Doubtful, State::Fine].into_iter().flat_map(of) {
        text += &format!("{:9} {}: {}\n", check.state.name(), check.of, check.says);
    }
    text
}
