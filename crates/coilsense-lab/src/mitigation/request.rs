//! What may be asked of a study: the options of `coilsense mitigate`, of Python's function and of the page, in one table.
//!
//! Next door: what a row says (`crate::request`), the study (`study`), the log's own options (`crate::recording::request`).

use coilsense::Error;
use coilsense::mitigation::ToleranceBox;

use crate::calibration::request as of_calibration;
use crate::quantity::Dimension;
use crate::recording::request as log;
use crate::request::{Allowed, Door, Given, IfAbsent, LENGTH, Row, Takes, Wrong};

/// What it is judged on in place of the spec's conditions.
pub const BASIS: [Row; 2] = [STATED, LOG];
/// The options, in the order in which they are told.
pub const OPTIONS: [Row; 7] = [RATE, NOISE, BANDWIDTH, STIFFNESS_TOLERANCE, MASS_TOLERANCE, MOST_LAG, SEEDS];

/// What is known of a log's positions.
pub const OF_LOG: [Row; 4] = [LENGTH_AT_ZERO, CALIBRATION, RE_ZERO, END2];
/// How the log is read, as by every other verb.
pub const READING: [Row; 24] = [
    of_log(log::COLUMN),
    of_log(log::UNITS),
    of_log(log::GAIN),
    of_log(log::OFFSET),
    of_log(log::NEGATE),
    of_log(log::CONSTANT),
    of_log(log::MAPPING),
    of_log(log::PRESET),
    of_log(log::DELIMITER),
    of_log(log::DECIMAL),
    of_log(log::SAMPLE_RATE),
    of_log(log::DROP_INCOMPLETE),
    of_log(log::SORT),
    of_log(log::MERGE_REPEATED),
    of_log(log::UNWRAP),
    of_log(log::FILL_GAPS),
    of_log(log::RESAMPLE),
    of_log(log::REPAIR_UP_TO),
    of_log(log::FROM),
    of_log(log::TO),
    of_log(log::WITH),
    of_log(log::WITH_COLUMN),
    of_log(log::WITH_MAPPING),
    of_log(log::CLOCK),
];

/// A row of a log that is judged on.
const fn of_log(row: Row) -> Row {
    let requires = if row.requires.is_empty() { &["log"] } else { row.requires };
    Row { requires, elsewhere: &[(Door::Python, "record"), (Door::Page, "the tab Log")], ..row }
}

/// The stated scenario.
pub const STATED: Row = Row {
    name: "stated",
    meaning: "Judge on the stated scenario in place of the spec's conditions: an impact while end 1 moves, 2.5 kHz, 0.24 N of noise, 50 seeds",
    conflicts: &["rate", "noise", "bandwidth", "stiffness_tolerance", "mass_tolerance", "most_lag", "seeds"],
    elsewhere: &[(Door::Page, "Judge on")],
    ..Row::PLAIN
};
/// A record.
pub const LOG: Row = Row {
    name: "log",
    takes: Takes::File("LOG"),
    meaning: "Judge on a log in place of the spec's conditions: F_i, u1, u2 (none where end 2 is held) and, for estimators, F_o",
    conflicts: &["stated", "rate", "seeds"],
    elsewhere: &[(Door::Python, "record"), (Door::Page, "Judge on")],
    ..Row::PLAIN
};
/// Where positions count from.
pub const LENGTH_AT_ZERO: Row = Row {
    name: "length_at_zero",
    if_absent: IfAbsent::Found("by the mean of F_i"),
    meaning: "Length of the coil where u1 and u2 of the log read zero",
    requires: &["log"],
    elsewhere: &[(Door::Page, "by the mean of F_i")],
    ..LENGTH
};
/// Length by the log's inductance.
pub const CALIBRATION: Row = Row {
    meaning: "A stored calibration (calibration.toml of coilsense calibrate --out): the coil's length by the log's L, in place of an end that was not recorded, or as the length where u1 and u2 read zero",
    requires: &["log"],
    conflicts: &["length_at_zero"],
    elsewhere: &[(Door::Page, "coilsense mitigate")],
    ..of_calibration::CALIBRATION
};
/// A spring that was mounted anew since.
pub const RE_ZERO: Row = Row {
    requires: &["calibration"],
    elsewhere: &[(Door::Python, "StoredCalibration.re_zeroed"), (Door::Page, "coilsense mitigate")],
    ..of_calibration::RE_ZERO
};
/// Whether the log needs a u2.
pub const END2: Row = Row {
    name: "end2",
    takes: Takes::Word(&["held", "free", "mass"]),
    if_absent: IfAbsent::Found("as in the spec's [mount]"),
    meaning: "What end 2 is tied to in the log; where it is held, no u2 is needed",
    requires: &["log"],
    elsewhere: &[(Door::Page, "the spec's [mount]")],
    ..Row::PLAIN
};
/// In which numbers the target computes.
pub const PRECISION: Row = Row {
    name: "precision",
    takes: Takes::Word(&["single", "double"]),
    if_absent: IfAbsent::Value("single"),
    meaning: "Numbers of the exported settings: f32 and float, or f64 and double",
    elsewhere: &[(Door::Python, "Mitigation.save(precision=)"), (Door::Page, "its buttons that save")],
    ..Row::PLAIN
};
/// How often the controller samples.
pub const RATE: Row = Row {
    name: "rate",
    takes: Takes::Quantity(Dimension::Frequency),
    allowed: Allowed::AboveZero,
    if_absent: IfAbsent::Found("1/sample_time of the spec's [control], or 2.5 kHz"),
    meaning: "Sampling rate of the controller",
    ..Row::PLAIN
};
/// White noise of F_i.
pub const NOISE: Row = Row {
    name: "noise",
    takes: Takes::Quantity(Dimension::Force),
    allowed: Allowed::AboveZero,
    if_absent: IfAbsent::Found("that of the spec's quietest load cell at end 1, or 0.2 % of the nominal force"),
    meaning: "White noise of the force at end 1, rms per sample",
    ..Row::PLAIN
};
/// Up to where the force is wanted.
pub const BANDWIDTH: Row = Row {
    name: "bandwidth",
    takes: Takes::Quantity(Dimension::Frequency),
    allowed: Allowed::AboveZero,
    if_absent: IfAbsent::Found("the goal's bandwidth, or f1/20"),
    meaning: "Highest frequency of the force itself, without ringing",
    ..Row::PLAIN
};
/// How far the stiffness may be off.
pub const STIFFNESS_TOLERANCE: Row = Row {
    name: "stiffness_tolerance",
    takes: Takes::Quantity(Dimension::Share),
    allowed: Allowed::Below(0.0, 1.0),
    if_absent: IfAbsent::Found("the spec's own, or 10 %"),
    meaning: "Tolerance of the stiffness, to either side",
    ..Row::PLAIN
};
/// How far the mass may be off.
pub const MASS_TOLERANCE: Row = Row {
    name: "mass_tolerance",
    takes: Takes::Quantity(Dimension::Share),
    allowed: Allowed::Below(0.0, 1.0),
    if_absent: IfAbsent::Found("the spec's own with the model's uncertainty of f1, or 10 %"),
    meaning: "Tolerance of the mass, to either side",
    ..Row::PLAIN
};
/// How late an advised candidate may be.
pub const MOST_LAG: Row = Row {
    name: "most_lag",
    takes: Takes::Quantity(Dimension::Angle),
    allowed: Allowed::Any,
    if_absent: IfAbsent::Value("30 deg"),
    meaning: "Largest lag at the bandwidth that a recommendation may have",
    ..Row::PLAIN
};
/// Series of noise.
pub const SEEDS: Row = Row {
    name: "seeds",
    takes: Takes::Count,
    allowed: Allowed::Within(1.0, 1000.0),
    if_absent: IfAbsent::Value("5"),
    meaning: "Number of noise realisations",
    ..Row::PLAIN
};

/// What is asked beside a spec.
#[derive(Debug, Clone, Copy)]
pub struct Request {
    /// Sampling rate \[Hz\]; as the spec's `[control]` says without.
    pub rate: Option<f64>,
    /// Noise \[N rms\]; that of the spec's load cell at end 1 without.
    pub noise: Option<f64>,
    /// Bandwidth \[Hz\].
    pub bandwidth: Option<f64>,
    /// How far k may be off, as a share; the spec's own without.
    pub stiffness_tolerance: Option<f64>,
    /// How far m may be off, as a share; the spec's own without.
    pub mass_tolerance: Option<f64>,
    /// Most lag at the bandwidth \[rad\].
    pub most_lag: f64,
    /// Series of noise.
    pub seeds: u64,
    /// Length of the coil where u1 and u2 of a log read zero \[m\]; by the mean of F_i without.
    pub length_at_zero: Option<f64>,
    /// Whether end 2 is held in a log; as the spec says without.
    pub end2_held: Option<bool>,
}

impl Request {
    /// Of what was given; what was not holds as the table says.
    ///
    /// # Errors
    /// [`Wrong`] where the tolerances leave nothing between them.
    pub fn of(given: &Given) -> Result<Self, Wrong> {
        let number = |row: &Row| given.number(row).unwrap_or_default();
        let tolerances = [&STIFFNESS_TOLERANCE, &MASS_TOLERANCE].map(|row| given.number(row));
        if let [Some(stiffness), Some(mass)] = tolerances {
            ToleranceBox::new(stiffness, mass).map_err(|_| {
                STIFFNESS_TOLERANCE.wrong("must be above zero where the mass has no tolerance either: the box is empty")
            })?;
        }
        Ok(Self {
            rate: given.number(&RATE),
            noise: given.number(&NOISE),
            bandwidth: given.number(&BANDWIDTH),
            stiffness_tolerance: tolerances[0],
            mass_tolerance: tolerances[1],
            most_lag: number(&MOST_LAG),
            seeds: given.count(&SEEDS).unwrap_or_default(),
            length_at_zero: given.number(&LENGTH_AT_ZERO),
            end2_held: given.text(&END2).map(|word| word == "held"),
        })
    }
}

/// What the science refuses of a study, and which option it is about, where it is about one.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("{error}")]
pub struct Refused {
    /// The option's name.
    pub option: Option<&'static str>,
    /// Why.
    pub error: Error,
}

impl Refused {
    /// Of an option.
    pub(super) fn of(row: &Row, error: Error) -> Self {
        Self { option: Some(row.name), error }
    }

    /// The option as the command has it and a colon before the reason, where it is about one.
    pub fn placed(&self) -> String {
        let wrong = self.option.map(|option| Wrong { option, reason: self.error.to_string() });
        wrong.map_or_else(|| self.error.to_string(), |wrong| wrong.to_string())
    }
}

impl From<Error> for Refused {
    fn from(error: Error) -> Self {
        Self { option: None, error }
    }
}
