//! A coil's inductance over its length, whatever the theory.
//!
//! Next door: Maxwell's sum (`maxwell`), turns of magnetic wire (`permeable`).

use std::fmt::Debug;

use super::maxwell::MaxwellSum;

/// A coil whose inductance is known at any length, its turns evenly spread.
pub trait OverLength: Debug + Send + Sync {
    /// L \[H\] at a length \[m\].
    fn at_length(&self, length: f64) -> f64;

    /// The same for many lengths at once, shape `lengths`.
    fn at_lengths(&self, lengths: &[f64]) -> Vec<f64> {
        lengths.iter().map(|&length| self.at_length(length)).collect()
    }
}

impl OverLength for MaxwellSum {
    fn at_length(&self, length: f64) -> f64 {
        Self::at_length(self, length)
    }

    fn at_lengths(&self, lengths: &[f64]) -> Vec<f64> {
        Self::at_lengths(self, lengths)
    }
}
