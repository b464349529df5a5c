//! A log without a clock: rows of measured values in SI, as a calibration takes them.
//!
//! Next door: logs over time (`mod`).

use std::path::Path;

use coilsense::Channel;

use super::Recording;
use super::account::{Account, Reason};
use super::cleaning::Cleaning;
use super::error::{RecordingError, leave_out};
use super::handed::Handed;
use super::mapping::Mapping;
use super::order::MOST_NUMBERS;
use super::pipeline::{Rows, nothing_left};
use super::source::Source;
use super::{held, open};
use crate::message::Message;

/// Values of each channel row by row, all of one length; time plays no part.
#[derive(Debug, Clone, PartialEq)]
pub struct Points {
    channels: Vec<(Channel, Vec<f64>)>,
    lines: Vec<u64>,
    account: Account,
    remarks: Vec<String>,
}

impl Points {
    /// Reads a log. Of the cleaning only `drop_incomplete` has a meaning here.
    ///
    /// # Errors
    /// [`RecordingError`] as [`super::Recording::read`], but for times.
    pub fn read(path: &Path, mapping: &Mapping, cleaning: &Cleaning) -> Result<Self, RecordingError> {
        Self::of_source(open(path, mapping)?, mapping, cleaning)
    }

    /// Reads the text of a log, under a name for messages.
    ///
    /// # Errors
    /// As [`Self::read`]; for what is no text, too.
    pub fn of_text(name: &str, text: Vec<u8>, mapping: &Mapping, cleaning: &Cleaning) -> Result<Self, RecordingError> {
        Self::of_handed(Handed::text(name, text), mapping, cleaning)
    }

    /// The same of a log that is handed over piece by piece.
    ///
    /// # Errors
    /// As [`Self::of_text`].
    pub fn of_handed(log: Handed, mapping: &Mapping, cleaning: &Cleaning) -> Result<Self, RecordingError> {
        Self::of_source(held(log, mapping)?, mapping, cleaning)
    }

    fn of_source(mut source: Box<dyn Source>, mapping: &Mapping, cleaning: &Cleaning) -> Result<Self, RecordingError> {
        let path = source.file().to_owned();
        let path = path.as_path();
        let remarks = source.remarks().to_vec();
        let mut rows = Rows::of(source.as_mut(), mapping, cleaning, false)?;
        let mut channels: Vec<(Channel, Vec<f64>)> =
            rows.channels().into_iter().map(|channel| (channel, Vec::new())).collect();
        let mut lines = Vec::new();
        while let Some(reading) = rows.next()? {
            if let Some(place) = reading.values.iter().position(|value| value.is_nan()) {
                if !cleaning.drop_incomplete {
                    let message = Message::from(format!("{} has no value; ", channels[place].0.name())) + leave_out();
                    return Err(RecordingError::of_line(path, reading.line, message));
                }
                rows.account.leave_out(Reason::MissingValue, reading.line);
                continue;
            }
            if (lines.len() + 1) * (channels.len() + 1) > MOST_NUMBERS {
                return Err(RecordingError::of_file(path, "is too large to be held in memory"));
            }
            lines.push(reading.line);
            for ((_, values), value) in channels.iter_mut().zip(reading.values) {
                values.push(value);
            }
        }
        let mut account = rows.account;
        account.rows = lines.len() as u64;
        if lines.is_empty() {
            return Err(RecordingError::of_file(path, nothing_left(&account)));
        }
        account.check_repairs(cleaning)?;
        Ok(Self { channels, lines, account, remarks })
    }

    /// The rows of a recording, counted from 1 where their lines are no longer known.
    pub fn of(recording: &Recording) -> Self {
        let signals = recording.signals();
        Self {
            channels: signals.channels().map(|(channel, values)| (channel, values.to_vec())).collect(),
            lines: (1..=signals.time().len() as u64).collect(),
            account: recording.account().clone(),
            remarks: recording.remarks().to_vec(),
        }
    }

    /// A channel's values in SI, shape `rows`.
    ///
    /// # Errors
    /// [`RecordingError`] where the log has no such channel.
    pub fn channel(&self, channel: Channel) -> Result<&[f64], RecordingError> {
        let found = self.channels.iter().find(|(present, _)| *present == channel).map(|(_, values)| values.as_slice());
        found.ok_or_else(|| super::lacks(&self.account.file, channel))
    }

    /// Which channels are there.
    pub fn channels(&self) -> impl Iterator<Item = Channel> {
        self.channels.iter().map(|(channel, _)| *channel)
    }

    /// The file's line of each row, shape `rows`.
    pub fn lines(&self) -> &[u64] {
        &self.lines
    }

    /// What became of the log's rows.
    pub fn account(&self) -> &Account {
        &self.account
    }

    /// Comment lines and what else stands above the rows.
    pub fn remarks(&self) -> &[String] {
        &self.remarks
    }

    /// What the log says of its being simulated, where it does.
    pub fn simulated(&self) -> Option<&str> {
        super::simulated(&self.remarks)
    }
}
