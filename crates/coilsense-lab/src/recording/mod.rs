//! Measured logs: from a file of any layout to `Signals` in SI on one rising clock, with an account of every row.
//!
//! | file | holds |
//! |---|---|
//! | `mapping`, `mapping_file`, `quantity`, `title`, `unit` | which column is which channel, in which unit |
//! | `selection`, `guess`, `proposal`, `first_look` | finding those columns in a file, and asking for what is not told of them |
//! | `source`, `text`, `layout`, `trial`, `dialect`, `cell`, `numeral`, `stamp`, `formats`, `table`, `whole` | where rows come from |
//! | `input`, `handed`, `packing`, `unicode` | what a log is read from: files, pipes, compressed or not, or what is handed over |
//! | `request` | what may be asked of a log |
//! | `cleaning`, `pipeline`, `clock`, `nominal`, `repairs`, `order`, `complete`, `spacing`, `row` | what is cleaned on their way |
//! | `account`, `telling` | what became of every row |
//! | `points` | logs without a clock |
//! | `join` | two devices on one clock |
//! | `overview`, `summary` | what is in a log, before anything is taken from it |
//! | `convert` | from file to file, in bounded memory |
//!
//! Next door: what writes such files (`crate::series`).

mod account;
mod cell;
mod cleaning;
mod clock;
mod complete;
mod convert;
mod dialect;
mod error;
mod first_look;
mod formats;
mod guess;
mod handed;
mod input;
mod join;
mod layout;
mod mapping;
mod mapping_file;
mod nominal;
mod numeral;
mod order;
mod overview;
mod packing;
mod pipeline;
mod points;
mod proposal;
mod quantity;
mod repairs;
pub mod request;
mod row;
mod selection;
mod source;
mod spacing;
mod stamp;
mod summary;
mod table;
mod telling;
mod text;
mod title;
mod trial;
mod unicode;
mod unit;
mod whole;

pub use account::{Account, Gaps, Joined, Reason, Tally};
pub use cleaning::Cleaning;
pub use convert::{ImportError, import, write_recording, write_recording_with};
pub use error::RecordingError;
pub use first_look::{FirstLook, Meant};
pub use handed::Handed;
pub use join::Clock;
pub use mapping::{Format, Mapping, PRESETS};
pub use mapping_file::{COLUMN_KEYS, LOG_KEYS, keys_markdown};
pub use overview::{ClockOverview, ColumnOverview, Overview};
pub use pipeline::Watch;
pub use points::Points;
pub use quantity::Quantity;
pub use summary::Summary;
pub use table::Table;
pub(crate) use telling::hertz;
pub use title::Title;

use std::path::Path;

use coilsense::{Channel, Signals};

use crate::message::{Hint, Message};
use order::MOST_NUMBERS;
use pipeline::Rows;
use source::Source;
use telling::seconds;

/// A log in SI, on one rising clock.
#[derive(Debug, Clone, PartialEq)]
pub struct Recording {
    signals: Signals,
    account: Account,
    remarks: Vec<String>,
}

impl Recording {
    /// Reads a log and cleans what `cleaning` allows.
    ///
    /// # Errors
    /// [`RecordingError`], one line with file, line and column, for what cannot be read, is wrong, and may not be cleaned.
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
        let rows = Rows::of(source.as_mut(), mapping, cleaning, true)?;
        let channels = rows.channels();
        let mut time = Vec::new();
        let mut values = vec![Vec::new(); channels.len()];
        let account = rows.clean(&|_, _| true, &mut |row, _| {
            if (time.len() + 1) * (channels.len() + 1) > MOST_NUMBERS {
                let message =
                    Message::from("is too large to be held in memory; take a part of it by ") + error::window();
                return Err(RecordingError::of_file(path, message));
            }
            time.push(row.time);
            for (series, value) in values.iter_mut().zip(row.values) {
                series.push(value);
            }
            Ok(())
        })?;
        let science = |error: coilsense::Error| RecordingError::of_file(path, error);
        let mut signals = Signals::new(time).map_err(science)?;
        for (channel, series) in channels.into_iter().zip(values) {
            signals.insert(channel, series).map_err(science)?;
        }
        Ok(Self { signals, account, remarks })
    }

    /// Signals that were not read from a file, under a name for messages and reports.
    pub fn of_signals(name: &str, signals: Signals) -> Self {
        let time = signals.time();
        let rows = time.len() as u64;
        let steps = time.windows(2).map(|pair| pair[1] - pair[0]);
        let (least, largest) =
            steps.fold((f64::INFINITY, 0.0), |(least, most): (f64, f64), step| (least.min(step), most.max(step)));
        let span = time.first().zip(time.last()).map(|(first, last)| [*first, *last]);
        let interval = span.filter(|_| rows > 1).map(|[first, last]| (last - first) / (rows - 1) as f64);
        let account = Account {
            file: name.into(),
            description: "signals in memory".to_owned(),
            read: rows,
            rows,
            span,
            interval,
            steps: interval.map(|_| [least, largest]),
            ..Account::default()
        };
        Self { signals, account, remarks: Vec::new() }
    }

    /// The signals.
    pub fn signals(&self) -> &Signals {
        &self.signals
    }

    /// The signals, moved out.
    pub fn into_signals(self) -> Signals {
        self.signals
    }

    /// What became of the log's rows.
    pub fn account(&self) -> &Account {
        &self.account
    }

    /// Comment lines and what else stands above the rows.
    pub fn remarks(&self) -> &[String] {
        &self.remarks
    }

    /// What the log says of its being simulated, where it does: the comment line that begins with that word.
    pub fn simulated(&self) -> Option<&str> {
        simulated(&self.remarks)
    }

    /// A channel, shape `samples`.
    ///
    /// # Errors
    /// [`RecordingError`] where the log has no such channel.
    pub fn channel(&self, channel: Channel) -> Result<&[f64], RecordingError> {
        self.signals.channel(channel).map_err(|_| lacks(&self.account.file, channel))
    }

    /// Samples per second \[Hz\] of a log whose times all lie within a quarter of a sample of an even clock.
    ///
    /// # Errors
    /// [`RecordingError`] that names the first time which does not, and the repair.
    pub fn sample_rate(&self) -> Result<f64, RecordingError> {
        let time = self.signals.time();
        let (Some(first), Some(last)) = (time.first(), time.last().filter(|_| time.len() > 1)) else {
            return Err(RecordingError::of_file(&self.account.file, "a single row has no sample rate"));
        };
        let interval = (last - first) / (time.len() - 1) as f64;
        let even = |index: usize, time: f64| (time - first - index as f64 * interval).abs() <= 0.25 * interval;
        if time.iter().enumerate().all(|(index, &time)| even(index, time)) {
            return Ok(1.0 / interval);
        }
        let message = self.uneven(interval);
        Err(RecordingError::of_file(&self.account.file, message))
    }

    /// How the times are uneven, whose mean step is `interval` \[s\], and what makes them even.
    fn uneven(&self, interval: f64) -> Message {
        let time = self.signals.time();
        let first = time.first().copied().unwrap_or(0.0);
        let off = |(index, time): (usize, &f64)| (time - first - index as f64 * interval).abs();
        let jitter = time.iter().enumerate().map(off).fold(0.0, f64::max);
        // A row that is missing makes a long step, and jitter short ones, too.
        let usual = self.account.interval.unwrap_or(interval);
        let jitters = self.account.steps.is_some_and(|[least, _]| least < 0.75 * usual);
        if self.account.gaps.count == 0 || jitters && jitter <= MOST_JITTER * interval {
            let rate = telling::hertz(nominal::nominal(1.0 / interval));
            let text = format!(
                "is not evenly sampled: its time stamps jitter by up to {} around an even clock of {rate}; ",
                seconds(jitter)
            );
            return Message::from(text)
                + Hint::Value("resample", rate.clone())
                + " interpolates linearly; if only the stamps jitter and the samples are evenly spaced, "
                + Hint::Value("sample_rate", rate)
                + " takes them so";
        }
        let (step, at) = time
            .windows(2)
            .map(|pair| (pair[1] - pair[0], pair[0]))
            .fold((0.0, first), |most, next| if next.0 > most.0 { next } else { most });
        let (usual_step, longest) = (seconds(usual), seconds(step));
        let text =
            format!("is not evenly sampled: its steps of time are usually {usual_step}, and {longest} at {at} s; ");
        let rate = telling::hertz(nominal::nominal(1.0 / usual));
        Message::from(text) + Hint::Value("resample", rate) + " makes them even"
    }
}

/// Stamps that are off by at most so many steps jitter; beyond that rows are missing.
const MOST_JITTER: f64 = 3.0;

/// Opens a log of any format.
fn open(path: &Path, mapping: &Mapping) -> Result<Box<dyn Source>, RecordingError> {
    formats::open(path, &mapping.format)
}

/// A text that is handed over as a source.
fn held(log: Handed, mapping: &Mapping) -> Result<Box<dyn Source>, RecordingError> {
    Ok(Box::new(formats::held(log, &mapping.format)?))
}

fn lacks(file: &Path, channel: Channel) -> RecordingError {
    let (name, unit) = (channel.name(), channel.unit());
    let message = Message::from(format!("has no {name}; say which column it is, as in "));
    RecordingError::of_file(file, message + Hint::Column(name, format!("title [{unit}]")))
}

/// The remark that says that a log is simulated.
fn simulated(remarks: &[String]) -> Option<&str> {
    remarks.iter().map(|remark| remark.trim()).find(|remark| remark.to_lowercase().starts_with("simulated"))
}
