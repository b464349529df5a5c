//! The normal distribution.
//!
//! Next door: what is judged by it (`ends`, `decays`, `coil`).

use std::f64::consts::{FRAC_1_SQRT_2, TAU};

/// Density at a distance from the mean.
pub(super) fn density(x: f64, spread: f64) -> f64 {
    (-0.5 * (x / spread).powi(2)).exp() / (TAU.sqrt() * spread)
}

/// Φ(z).
pub(super) fn below(z: f64) -> f64 {
    0.5 * libm::erfc(-z * FRAC_1_SQRT_2)
}
