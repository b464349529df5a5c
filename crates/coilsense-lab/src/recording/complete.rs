//! The second stage: rows that have a value of every channel.
//!
//! Next door: times that rise (`order`), gaps and rates (`spacing`).

use std::collections::VecDeque;
use std::path::PathBuf;

use super::account::{Account, Reason};
use super::cleaning::Cleaning;
use super::error::{RecordingError, leave_out};
use super::order::MOST_NUMBERS;
use super::row::{Onward, Row, between};
use super::telling::seconds;
use crate::message::{Hint, Message};

/// Lets complete rows through; fills or leaves out where it may.
pub(super) struct Complete {
    file: PathBuf,
    cleaning: Cleaning,
    channels: Vec<&'static str>,
    /// Rows since the last one that went on: the first lacks a value that may still come.
    waiting: VecDeque<Row>,
    /// The last value of each channel: its time, itself.
    last: Vec<Option<(f64, f64)>>,
    /// Its first value.
    first: Vec<Option<(f64, f64)>>,
}

impl Complete {
    pub fn new(file: PathBuf, cleaning: Cleaning, channels: Vec<&'static str>) -> Self {
        let (last, first) = (vec![None; channels.len()], vec![None; channels.len()]);
        Self { file, cleaning, channels, waiting: VecDeque::new(), last, first }
    }

    fn fills(&self) -> bool {
        self.cleaning.fill_gaps.is_some() || self.cleaning.resample.is_some()
    }

    pub fn push(&mut self, row: Row, account: &mut Account, onward: &mut Onward<'_>) -> Result<(), RecordingError> {
        let lacking = row.values.iter().position(|value| value.is_nan());
        if !self.fills() {
            return match lacking {
                None => onward(row, account),
                Some(channel) => self.lacks(&row, channel, account),
            };
        }
        for channel in 0..self.channels.len() {
            let value = row.values.get(channel).copied().unwrap_or(f64::NAN);
            if !value.is_nan() {
                self.fill(channel, (row.time, value), account);
                self.last[channel] = Some((row.time, value));
                self.first[channel].get_or_insert((row.time, value));
            }
        }
        if lacking.is_none() && self.waiting.is_empty() {
            return onward(row, account);
        }
        self.waiting.push_back(row);
        if self.waiting.len() * (self.channels.len() + 4) > MOST_NUMBERS {
            let message = "has a channel without values for too many rows to hold in memory";
            return Err(RecordingError::of_file(&self.file, message));
        }
        self.release(false, account, onward)
    }

    /// Lets the last rows go.
    pub fn finish(&mut self, account: &mut Account, onward: &mut Onward<'_>) -> Result<(), RecordingError> {
        self.release(true, account, onward)
    }

    /// Fills what waits for a value of `channel`, now that the next one is there.
    fn fill(&mut self, channel: usize, next: (f64, f64), account: &mut Account) {
        let Some(last) = self.last.get(channel).copied().flatten() else { return };
        let length = next.0 - last.0;
        if !self.cleaning.bridges(length) {
            return;
        }
        // What waits lacks the channel from behind its last value on, so that a look from the end suffices.
        for row in self.waiting.iter_mut().rev().take_while(|row| row.time > last.0) {
            if let Some(value) = row.values.get_mut(channel).filter(|value| value.is_nan()) {
                *value = between(last, next, row.time);
                let entry = account.filled_values.entry(self.channels[channel]).or_insert((0, 0.0));
                *entry = (entry.0 + 1, entry.1.max(length));
            }
        }
    }

    /// Lets rows go whose values are all there, and those that lack one which will not come.
    fn release(&mut self, end: bool, account: &mut Account, onward: &mut Onward<'_>) -> Result<(), RecordingError> {
        while let Some(row) = self.waiting.front() {
            let missing: Vec<usize> =
                row.values.iter().enumerate().filter(|(_, value)| value.is_nan()).map(|(channel, _)| channel).collect();
            // A value will not come any more once the channel has had one after this row.
            let passed = |&channel: &usize| self.last[channel].is_some_and(|(time, _)| time > row.time);
            let lost = missing.iter().copied().find(|channel| end || passed(channel));
            if !missing.is_empty() && lost.is_none() {
                return Ok(());
            }
            let Some(row) = self.waiting.pop_front() else { return Ok(()) };
            match lost {
                None => onward(row, account)?,
                Some(channel) => self.lost(&row, channel, account)?,
            }
        }
        Ok(())
    }

    /// A row whose value will not come: at the log's ends there is nothing to fill it from, else its neighbours are too far apart.
    fn lost(&self, row: &Row, channel: usize, account: &mut Account) -> Result<(), RecordingError> {
        let at = |ends: &[Option<(f64, f64)>]| ends.get(channel).copied().flatten().map(|(time, _)| time);
        match (at(&self.first), at(&self.last)) {
            (Some(first), Some(last)) if row.time < first || row.time > last => {
                account.leave_out(Reason::Ends, row.line);
                Ok(())
            }
            (None, _) if !self.cleaning.drop_incomplete => {
                Err(RecordingError::of_file(&self.file, format!("{} has no value at all", self.channels[channel])))
            }
            _ => self.lacks(row, channel, account),
        }
    }

    fn lacks(&self, row: &Row, channel: usize, account: &mut Account) -> Result<(), RecordingError> {
        if self.cleaning.drop_incomplete {
            account.leave_out(Reason::MissingValue, row.line);
            return Ok(());
        }
        let lacks = Message::from(format!("{} has no value", self.channels[channel]));
        let message = match self.cleaning.fill_gaps {
            Some(longest) => {
                lacks + " for longer than " + Hint::Value("fill_gaps", seconds(longest)) + "; " + leave_out()
            }
            None => {
                lacks
                    + "; "
                    + leave_out()
                    + ", "
                    + Hint::Option("fill_gaps", "TIME")
                    + " fills them along straight lines, and so does "
                    + Hint::Option("resample", "RATE")
                    + " where channels have different rates"
            }
        };
        Err(RecordingError::of_line(&self.file, row.line, message))
    }
}
