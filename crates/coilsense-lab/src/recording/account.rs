//! What became of every row of a log: read, cleaned, left out, and why.
//!
//! Next door: the same in words (`telling`), the stages that fill it in (`order`, `complete`, `spacing`).

use std::collections::BTreeMap;
use std::path::PathBuf;

use coilsense::measures::ClockOffset;

/// Why rows are left out.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Reason {
    /// The mapping says to skip them.
    Skipped,
    /// Before `--from` or after `--to`.
    OutsideWindow,
    /// They have more or fewer cells than there are columns.
    CellCount,
    /// A cell is not a number.
    NoNumber,
    /// A number is infinite, or larger than the science takes.
    TooLarge,
    /// A value is missing.
    MissingValue,
    /// They are one with another row of the same time.
    Merged,
    /// Before the first or after the last value of another channel.
    Ends,
    /// Where the other device has no values.
    OtherDevice,
}

impl Reason {
    /// In words, for people.
    pub fn words(self) -> &'static str {
        match self {
            Self::Skipped => "skipped, as the mapping says",
            Self::OutsideWindow => "outside of the window of time",
            Self::CellCount => "with too many or too few columns",
            Self::NoNumber => "with a cell that is not a number",
            Self::TooLarge => "with a number that is too large",
            Self::MissingValue => "with a missing value",
            Self::Merged => "merged into another row of the same time",
            Self::Ends => "before the first or after the last value of another channel",
            Self::OtherDevice => "where the other device has no values",
        }
    }
}

/// How many, and where the first one is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Tally {
    /// How many.
    pub count: u64,
    /// Line of the first; 0 where that is no longer known.
    pub line: u64,
}

/// A gap of a log: a step of time of more than one and a half times the usual one.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Gaps {
    /// How many.
    pub count: u64,
    /// The longest \[s\].
    pub longest: f64,
    /// Line behind the first.
    pub line: u64,
}

/// What became of a log's rows. `read` less what is left out, plus `filled_rows`, is `rows`, unless the log was resampled.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Account {
    /// The file.
    pub file: PathBuf,
    /// How it is written.
    pub description: String,
    /// What was taken: name and column, in the order of the channels.
    pub taken: Vec<(&'static str, String)>,
    /// Columns that were not taken.
    pub not_taken: Vec<String>,
    /// Rows that were there.
    pub read: u64,
    /// Rows that were left out.
    pub left_out: BTreeMap<Reason, Tally>,
    /// Where time was counted on behind a turn of its clock \[s\]: how often, and the line of the first.
    pub turns: Option<(f64, Tally)>,
    /// Rows that stood behind later ones and were sorted.
    pub sorted: u64,
    /// Missing values that were filled, by channel, and the longest stretch \[s\] over which that was.
    pub filled_values: BTreeMap<&'static str, (u64, f64)>,
    /// Rows that were added in gaps.
    pub filled_rows: u64,
    /// Gaps as they were, before any repair.
    pub gaps: Gaps,
    /// The usual step of time \[s\], as it was.
    pub interval: Option<f64>,
    /// The smallest and the largest step of time \[s\], as they were.
    pub steps: Option<[f64; 2]>,
    /// The rate \[Hz\] to which it was resampled.
    pub resampled: Option<f64>,
    /// Rows that came out.
    pub rows: u64,
    /// Their first and last time \[s\].
    pub span: Option<[f64; 2]>,
    /// The second device, where one was joined.
    pub joined: Option<Box<Joined>>,
    /// What else is to be said.
    pub notes: Vec<String>,
}

/// A second device whose channels were added.
#[derive(Debug, Clone, PartialEq)]
pub struct Joined {
    /// What became of its own rows.
    pub account: Account,
    /// What was added to its times \[s\]; with a drift, in the middle of what tells it.
    pub offset: f64,
    /// By which channels, of the first and the second device, that was found, and how surely; `None` where it was given.
    pub found: Option<([&'static str; 2], ClockOffset)>,
}

impl Joined {
    /// Its own time at a time of the first device \[s\].
    pub fn own(&self, time: f64) -> f64 {
        self.found.as_ref().map_or(time - self.offset, |(_, found)| found.of_second(time))
    }

    /// The first device's time at one of its own \[s\].
    pub fn of_first(&self, time: f64) -> f64 {
        time + self.found.as_ref().map_or(self.offset, |(_, found)| found.added(time))
    }
}

impl Account {
    /// Counts a row that is left out.
    pub(super) fn leave_out(&mut self, reason: Reason, line: u64) {
        self.left_out.entry(reason).or_insert(Tally { count: 0, line }).count += 1;
    }

    /// Counts a turn of the clock.
    pub(super) fn turned(&mut self, turn: f64, line: u64) {
        self.turns.get_or_insert((turn, Tally { count: 0, line })).1.count += 1;
    }

    /// How many rows were left out.
    pub fn left_out(&self) -> u64 {
        self.left_out.values().map(|tally| tally.count).sum()
    }
}
