//! A number with its 95 % interval.
//!
//! Next door: everything that is identified.

/// What was found, and how far to trust it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Estimate {
    /// The value, in SI units.
    pub value: f64,
    /// Standard uncertainty, in the same unit.
    pub standard: f64,
    /// Half the width of the interval that holds the true value with a probability of 95 %.
    pub expanded: f64,
}

impl Estimate {
    /// A value with its standard uncertainty and how many of these the 95 % take.
    pub(super) fn new(value: f64, standard: f64, factor: f64) -> Self {
        Self { value, standard, expanded: factor * standard }
    }

    /// Both multiplied by a number that is known.
    pub fn scaled(self, by: f64) -> Self {
        Self { value: self.value * by, standard: self.standard * by.abs(), expanded: self.expanded * by.abs() }
    }

    /// Whether a value lies inside of the interval.
    pub fn holds(&self, value: f64) -> bool {
        (value - self.value).abs() <= self.expanded
    }
}
