//! Frequencies at this door are hertz; the science computes its modes in rad/s.
//!
//! Next door: quantities with their unit as texts (`quantity`).

use std::f64::consts::TAU;

/// \[rad/s\] to \[Hz\].
pub fn in_hertz(angular: f64) -> f64 {
    angular / TAU
}

/// The same for all of a series.
pub fn all_in_hertz(angular: &[f64]) -> Vec<f64> {
    angular.iter().copied().map(in_hertz).collect()
}

/// \[Hz\] to \[rad/s\].
pub fn angular(frequency: f64) -> f64 {
    TAU * frequency
}
