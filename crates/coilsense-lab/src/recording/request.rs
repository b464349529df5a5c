//! What may be asked of a log: the options of every verb that reads one, of Python's `open_log` and of the page, in one table.
//!
//! Next door: what a row says (`crate::request`), what is cleaned up (`cleaning`), which column is what (`mapping`).

use super::{Cleaning, Clock, Mapping, PRESETS, RecordingError};
use crate::quantity::Dimension;
use crate::request::{Allowed, Door, Given, IfAbsent, Row, Takes};

/// The log, and what is in it.
pub const LAYOUT: [Row; 12] =
    [LOG, COLUMN, UNITS, GAIN, OFFSET, NEGATE, CONSTANT, MAPPING, PRESET, DELIMITER, DECIMAL, SAMPLE_RATE];
/// What may be cleaned up, in one log or in all of an experiment.
pub const CLEANING: [Row; 7] = [DROP_INCOMPLETE, SORT, MERGE_REPEATED, UNWRAP, FILL_GAPS, RESAMPLE, REPAIR_UP_TO];
/// The window of time.
pub const WINDOW: [Row; 2] = [FROM, TO];
/// A second device.
pub const SECOND: [Row; 4] = [WITH, WITH_COLUMN, WITH_MAPPING, CLOCK];

/// A row of what is in the log.
const IN_LOG: Row = Row { heading: "What is in the log", ..Row::PLAIN };
/// A row of what may be cleaned up.
const CLEAN: Row = Row { heading: "What may be cleaned up (by default nothing)", ..Row::PLAIN };
/// A row of the second device.
const OTHER: Row = Row { heading: "A second device", requires: &["with"], ..Row::PLAIN };
/// A rate that instruments have.
const RATE: Row =
    Row { takes: Takes::Quantity(Dimension::Frequency), allowed: Allowed::Within(1e-9, 1e9), ..Row::PLAIN };

/// The log.
pub const LOG: Row = Row {
    name: "log",
    takes: Takes::File("LOG"),
    if_absent: IfAbsent::Refused,
    meaning: "The log: a text with columns (CSV and the like), Parquet, Arrow, a workbook and others; - is standard input",
    by_place: true,
    elsewhere: &[(Door::Python, "path"), (Door::Page, "dropped")],
    ..Row::PLAIN
};
/// Which column is which channel.
pub const COLUMN: Row = Row {
    name: "column",
    takes: Takes::Text("NAME=\"TITLE [UNIT]\""),
    meaning: "Which column is which channel (time, u1, u2, F_i, F_o, F_x, F_L, L, R), by its title or, as in #3, its number; columns that carry a channel's name need none",
    repeated: true,
    elsewhere: &[(Door::Python, "columns"), (Door::Page, "the table of columns")],
    ..IN_LOG
};
/// Units of columns whose titles carry none.
pub const UNITS: Row = Row {
    name: "units",
    takes: Takes::Text("UNIT"),
    meaning: "Units by channel, where titles carry none",
    repeated: true,
    elsewhere: &[(Door::Command, "column"), (Door::Page, "the table of columns")],
    ..IN_LOG
};
/// What a sensor's own signal means.
pub const GAIN: Row = Row {
    name: "gain",
    takes: Takes::Text("NAME=\"GAIN\""),
    meaning: "What a sensor's own signal means: F_o=\"12.5 N/V\" for a column in V or mV, u1=\"0.5 um/count\", or F_o=\"12.5 N\" for one of the column's numbers",
    repeated: true,
    elsewhere: &[(Door::Page, "mapping")],
    ..IN_LOG
};
/// What is added to a channel.
pub const OFFSET: Row = Row {
    name: "offset",
    takes: Takes::Text("NAME=\"VALUE\""),
    meaning: "What is added to a channel in the end, such as F_o=\"0.2 N\"",
    repeated: true,
    elsewhere: &[(Door::Page, "mapping")],
    ..IN_LOG
};
/// Whose sign is turned.
pub const NEGATE: Row = Row {
    name: "negate",
    takes: Takes::Text("NAME"),
    meaning: "A channel whose sign is turned: forces are positive in tension, u1 and u2 count in one direction, u2 - u1 rising as the spring grows longer",
    repeated: true,
    elsewhere: &[(Door::Page, "mapping")],
    ..IN_LOG
};
/// A channel that stands still.
pub const CONSTANT: Row = Row {
    name: "constant",
    takes: Takes::Text("NAME=\"VALUE\""),
    meaning: "A channel that is the same in every row, such as u2=\"104 mm\" of an end that is held",
    repeated: true,
    elsewhere: &[(Door::Page, "mapping")],
    ..IN_LOG
};
/// The same as a file.
pub const MAPPING: Row = Row {
    name: "mapping",
    takes: Takes::File("FILE"),
    meaning: "The same, and how the text is written, as a TOML file: see book/src/guide/logs.md",
    conflicts: &["preset"],
    ..IN_LOG
};
/// A known layout.
pub const PRESET: Row = Row {
    name: "preset",
    takes: Takes::Text("NAME"),
    meaning: "A known layout: lab-data",
    elsewhere: &[(Door::Page, "layout")],
    ..IN_LOG
};
/// What parts the columns.
pub const DELIMITER: Row = Row {
    name: "delimiter",
    takes: Takes::Word(&[",", ";", "|", "tab", "space"]),
    if_absent: IfAbsent::Found("what is found"),
    meaning: "What separates the columns",
    ..IN_LOG
};
/// The decimal sign.
pub const DECIMAL: Row = Row {
    name: "decimal",
    takes: Takes::Word(&[".", ","]),
    if_absent: IfAbsent::Found("what is found"),
    meaning: "The decimal sign",
    ..IN_LOG
};
/// The rate of a log without a time column.
pub const SAMPLE_RATE: Row = Row {
    name: "sample_rate",
    meaning: "How often a log without a time column was sampled, such as \"2.5 kHz\"",
    heading: IN_LOG.heading,
    ..RATE
};
/// Whether incomplete rows go.
pub const DROP_INCOMPLETE: Row =
    Row { name: "drop_incomplete", meaning: "Leave out rows that lack a value or cannot be read", ..CLEAN };
/// Whether rows are put into order.
pub const SORT: Row = Row { name: "sort", meaning: "Put rows into the order of their times", ..CLEAN };
/// Whether rows of one time are merged.
pub const MERGE_REPEATED: Row =
    Row { name: "merge_repeated", meaning: "Take the mean of rows that have the same time", ..CLEAN };
/// Whether time counts on.
pub const UNWRAP: Row =
    Row { name: "unwrap", meaning: "Count on where midnight passes or a counter rolls over", ..CLEAN };
/// How many rows a repair may touch.
pub const REPAIR_UP_TO: Row = Row {
    name: "repair_up_to",
    takes: Takes::Quantity(Dimension::Share),
    allowed: Allowed::Within(0.0, 1.0),
    if_absent: IfAbsent::Value("1 %"),
    meaning: "Share of the rows that each of these may leave out, move, merge or fill; ten rows are never too many",
    ..CLEAN
};
/// Up to where gaps are filled.
pub const FILL_GAPS: Row = Row {
    name: "fill_gaps",
    takes: Takes::Quantity(Dimension::Time),
    allowed: Allowed::AboveZero,
    meaning: "Fill gaps and missing values up to this length along straight lines, such as \"10 ms\"",
    ..CLEAN
};
/// The rate that all are brought to.
pub const RESAMPLE: Row = Row {
    name: "resample",
    meaning: "Bring all channels to this rate along straight lines, such as \"2.5 kHz\"",
    heading: CLEAN.heading,
    ..RATE
};
/// Where it begins.
pub const FROM: Row = Row {
    name: "from",
    takes: Takes::Quantity(Dimension::Time),
    meaning: "Leave out what is before this time, such as \"2 s\"",
    elsewhere: &[(Door::Python, "from_")],
    ..CLEAN
};
/// Where it ends.
pub const TO: Row =
    Row { name: "to", takes: Takes::Quantity(Dimension::Time), meaning: "Leave out what is after this time", ..CLEAN };
/// The second log.
pub const WITH: Row = Row {
    name: "with",
    takes: Takes::File("LOG"),
    meaning: "A second device's log, whose channels are added to the first's rows",
    requires: &[],
    elsewhere: &[(Door::Python, "Recording.joined"), (Door::Page, "dropped")],
    ..OTHER
};
/// Which of its columns is which.
pub const WITH_COLUMN: Row = Row {
    name: "with_column",
    takes: Takes::Text("NAME=\"TITLE [UNIT]\""),
    meaning: "Which of its columns is which channel",
    repeated: true,
    elsewhere: &[(Door::Python, "Recording.joined"), (Door::Page, "the table of columns")],
    ..OTHER
};
/// The same as a file.
pub const WITH_MAPPING: Row = Row {
    name: "with_mapping",
    takes: Takes::File("FILE"),
    meaning: "The same as a TOML file",
    elsewhere: &[(Door::Python, "Recording.joined"), (Door::Page, "the table of columns")],
    ..OTHER
};
/// What is known of its clock.
pub const CLOCK: Row = Row {
    name: "clock",
    takes: Takes::Form("OFFSET|auto|A=B", |text| Clock::parse(text).map(|_| ())),
    if_absent: IfAbsent::Value("auto"),
    meaning: "What to add to its times, such as \"-0.2 s\"; or auto, by a channel that both have; or two channels that saw the same motion, as in F_o=F_x",
    elsewhere: &[(Door::Python, "Recording.joined")],
    ..OTHER
};

impl Cleaning {
    /// Of what was given.
    pub fn of(given: &Given) -> Self {
        Self {
            drop_incomplete: given.holds(&DROP_INCOMPLETE),
            sort: given.holds(&SORT),
            merge_repeated: given.holds(&MERGE_REPEATED),
            unwrap: given.holds(&UNWRAP),
            repair_up_to: given.number(&REPAIR_UP_TO),
            fill_gaps: given.number(&FILL_GAPS),
            resample: given.number(&RESAMPLE),
            from: given.number(&FROM),
            to: given.number(&TO),
        }
    }
}

impl Clock {
    /// Of what was given.
    pub fn of(given: &Given) -> Self {
        given.text(&CLOCK).and_then(|text| Self::parse(&text).ok()).unwrap_or(Self::Found(None))
    }
}

impl Mapping {
    /// Of what was given beside it: columns and what their numbers mean, how the text is written, its rate.
    ///
    /// # Errors
    /// [`RecordingError`] with the option and what it may be.
    pub fn told(mut self, given: &Given) -> Result<Self, RecordingError> {
        let delimiter = given.text(&DELIMITER).and_then(|word| match word.as_str() {
            "tab" => Some('\t'),
            "space" => Some(' '),
            sign => sign.chars().next(),
        });
        self.format.delimiter = delimiter.or(self.format.delimiter);
        self.format.decimal_comma = given.text(&DECIMAL).map(|sign| sign == ",").or(self.format.decimal_comma);
        self.format.sample_rate = given.number(&SAMPLE_RATE).or(self.format.sample_rate);
        given.texts(&COLUMN).iter().try_for_each(|text| self.set(text))?;
        given.texts(&CONSTANT).iter().try_for_each(|text| self.set_constant(text))?;
        given.texts(&GAIN).iter().try_for_each(|text| self.set_gain(text))?;
        given.texts(&OFFSET).iter().try_for_each(|text| self.set_offset(text))?;
        given.texts(&NEGATE).iter().try_for_each(|text| self.set_negated(text))?;
        Ok(self)
    }
}

/// The preset that is processed as its authors do.
pub const LAB_DATA: &str = PRESETS[0].0;

/// Whether a log has the layout of the measured runs.
pub fn is_lab_data(given: &Given) -> bool {
    given.text(&PRESET).as_deref() == Some(LAB_DATA)
}
