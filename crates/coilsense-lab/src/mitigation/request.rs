//! What may be asked of a study: the options of `coilsense mitigate`, of Python's function and of the page, in one table.
//!
//! Next door: what a row says (`crate::request`), the study (`study`).

use coilsense::Error;
use coilsense::mitigation::ToleranceBox;

use crate::quantity::Dimension;
use crate::request::{Allowed, IfAbsent, Row, Takes, Wrong, values};

/// The options, in the order in which they are told.
pub const OPTIONS: [Row; 7] = [RATE, NOISE, BANDWIDTH, STIFFNESS_TOLERANCE, MASS_TOLERANCE, MOST_LAG, SEEDS];

/// How often the controller samples.
pub(super) const RATE: Row = Row {
    name: "rate",
    takes: Takes::Quantity(Dimension::Frequency),
    allowed: Allowed::AboveZero,
    if_absent: IfAbsent::Value("2.5 kHz"),
    meaning: "Sampling rate of the controller",
};
/// White noise of F_i.
pub(super) const NOISE: Row = Row {
    name: "noise",
    takes: Takes::Quantity(Dimension::Force),
    allowed: Allowed::AboveZero,
    if_absent: IfAbsent::Found("0.2 % of the nominal force"),
    meaning: "White noise of the force at end 1, rms per sample",
};
/// Up to where the force is wanted.
pub(super) const BANDWIDTH: Row = Row {
    name: "bandwidth",
    takes: Takes::Quantity(Dimension::Frequency),
    allowed: Allowed::AboveZero,
    if_absent: IfAbsent::Found("the goal's bandwidth, or f1/20"),
    meaning: "Highest frequency of the force itself, without ringing",
};
const STIFFNESS_TOLERANCE: Row = Row {
    name: "stiffness_tolerance",
    takes: Takes::Quantity(Dimension::Share),
    allowed: Allowed::Below(0.0, 1.0),
    if_absent: IfAbsent::Value("10 %"),
    meaning: "Tolerance of the stiffness, to either side",
};
const MASS_TOLERANCE: Row = Row {
    name: "mass_tolerance",
    takes: Takes::Quantity(Dimension::Share),
    allowed: Allowed::Below(0.0, 1.0),
    if_absent: IfAbsent::Value("10 %"),
    meaning: "Tolerance of the mass, to either side",
};
const MOST_LAG: Row = Row {
    name: "most_lag",
    takes: Takes::Quantity(Dimension::Angle),
    allowed: Allowed::Any,
    if_absent: IfAbsent::Value("30 deg"),
    meaning: "Largest lag at the bandwidth that a recommendation may have",
};
/// Series of noise.
pub(super) const SEEDS: Row = Row {
    name: "seeds",
    takes: Takes::Count,
    allowed: Allowed::Within(1.0, 1000.0),
    if_absent: IfAbsent::Value("5"),
    meaning: "Number of noise realisations",
};

/// What is asked beside a spec.
#[derive(Debug, Clone, Copy)]
pub struct Asked {
    /// Sampling rate \[Hz\].
    pub rate: f64,
    /// Noise \[N rms\].
    pub noise: Option<f64>,
    /// Bandwidth \[Hz\].
    pub bandwidth: Option<f64>,
    /// Tolerances of k and m.
    pub tolerances: ToleranceBox,
    /// Most lag at the bandwidth \[rad\].
    pub most_lag: f64,
    /// Series of noise.
    pub seeds: u64,
}

impl Asked {
    /// From texts, such as those of a form; `given` is nothing for an option that nobody set.
    ///
    /// # Errors
    /// [`Wrong`] for the first option that cannot be.
    pub fn of(given: impl Fn(&Row) -> Option<String>) -> Result<Self, Wrong> {
        Self::of_values(values(&OPTIONS, given)?)
    }

    /// From values in SI units, in the order of [`OPTIONS`]; what is not there holds as the table says.
    ///
    /// # Errors
    /// [`Wrong`] for the first option that cannot be.
    pub fn of_values(mut given: [Option<f64>; OPTIONS.len()]) -> Result<Self, Wrong> {
        for (value, row) in given.iter_mut().zip(&OPTIONS) {
            *value = value.or_else(|| row.default_value()).map(|value| row.checked(value)).transpose()?;
        }
        let [rate, noise, bandwidth, stiffness, mass, most_lag, seeds] = given;
        let [rate, stiffness, mass, most_lag, seeds] =
            [rate, stiffness, mass, most_lag, seeds].map(Option::unwrap_or_default);
        let tolerances = ToleranceBox::new(stiffness, mass);
        let tolerances = tolerances.map_err(|_| {
            STIFFNESS_TOLERANCE.wrong("must be above zero where the mass has no tolerance either: the box is empty")
        })?;
        Ok(Self { rate, noise, bandwidth, tolerances, most_lag, seeds: seeds as u64 })
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
