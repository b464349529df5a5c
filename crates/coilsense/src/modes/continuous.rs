//! The continuous coil with each kind of far end, and the rule of thumb that takes a third of its mass.
//!
//! Next door: the chain, whose limit N → ∞ this is (the parent); its roots with an end mass (`end_mass`).

use std::f64::consts::{FRAC_PI_2, PI};

use super::continuous_frequency;
use super::end_mass::bracketed_newton;
use crate::error::{Error, above_zero, check, not_negative};
use crate::mount::FarEnd;
use crate::spring::Spring;

/// The first `count` frequencies of the continuous coil, end 1 held, end 2 tied to `far_end` \[rad/s\], lowest first; shape `count`.
///
/// ω_j = j π/τ (position), (j − ½) π/τ (force), β_j/τ with β tan β = m/M, one root in each ((j−1)π, (j−½)π) (mass M)
///
/// - `far_end`: what end 2 is tied to; `count`: how many, 1 to 1 000 000
///
/// Source:   `[Weijde2017]` eq. 3 (held ends); the wave equation k u″ = m ü over the coil's fraction 0 to 1, with k u′ = 0 or −M ü at
///           end 2 (the others), as for the bar of `[Rao2011]` chapter 8.
/// Valid:    a uniform undamped coil; the limit N → ∞ of [`super::ChainModes`], which nears it as 1/N².
/// Accuracy: 1e-15 relative for m/M from 1e-9 to 1e9, modes 1 to 1000, against 40 digits (`tests/geometry`; 2.2e-16 measured).
///
/// # Errors
/// [`Error::Value`] for an end mass that is not above zero, or a count outside of its range.
///
/// ```
/// # let spring = coilsense::paper::s_t();
/// use coilsense::{FarEnd, modes::continuous_frequencies};
///
/// let hertz = continuous_frequencies(&spring, FarEnd::Mass(0.065), 1)?[0] / std::f64::consts::TAU;
/// assert!((hertz - 14.806).abs() < 1e-3); // β tan β = 1 at β = 0.8603
/// # Ok::<(), coilsense::Error>(())
/// ```
pub fn continuous_frequencies(spring: &Spring, far_end: FarEnd, count: usize) -> Result<Vec<f64>, Error> {
    check((1..=MAX_COUNT).contains(&count), "count", count as f64, "", format!("from 1 to {MAX_COUNT}"))?;
    if let FarEnd::Mass(mass) = far_end {
        above_zero("end_mass", mass, "kg")?;
    }
    let tau = spring.transit_time();
    let frequency = |mode: usize| match far_end {
        FarEnd::Position => continuous_frequency(tau, mode),
        FarEnd::Force => (mode as f64 - 0.5) * PI / tau,
        FarEnd::Mass(mass) => end_mass_root(spring.mass() / mass, mode) / tau,
    };
    Ok((1..=count).map(frequency).collect())
}

/// First frequency of a mass on the spring by the rule of thumb \[rad/s\], end 1 held.
///
/// ω = √(k / (M + m/3))
///
/// - `end_mass`: M \[kg\], zero or above
///
/// Source:   Rayleigh: the kinetic energy of a coil that is stretched uniformly is that of a third of its mass at its end.
/// Valid:    always above the true one, by what [`third_rule_error`] says; it knows nothing of the surge.
/// Accuracy: 3e-16 relative to the formula.
///
/// # Errors
/// [`Error::Value`] for an end mass that is not finite or below zero.
///
/// ```
/// # let spring = coilsense::paper::s_t();
/// let hertz = coilsense::modes::third_rule_frequency(&spring, 0.065)? / std::f64::consts::TAU;
/// assert!((hertz - 14.904).abs() < 1e-3); // 14.806 Hz in truth
/// # Ok::<(), coilsense::Error>(())
/// ```
pub fn third_rule_frequency(spring: &Spring, end_mass: f64) -> Result<f64, Error> {
    not_negative("end_mass", end_mass, "kg")?;
    Ok((spring.stiffness() / (end_mass + spring.mass() / 3.0)).sqrt())
}

/// How far the rule of thumb lies above the continuous coil \[1\], relative.
///
/// √(k / (M + m/3)) τ / β_1 − 1
///
/// - `end_mass`: M \[kg\], zero or above
///
/// Source:   [`third_rule_frequency`] against [`continuous_frequencies`].
/// Valid:    always; (m/M)²/90 for a heavy end mass, 2√3/π − 1 without one.
/// Accuracy: 5e-16 absolute. +0.1 % at m/M = ⅓, +10.3 % without end mass (`tests/geometry`).
///
/// # Errors
/// [`Error::Value`] for an end mass that is not finite or below zero.
///
/// ```
/// # let spring = coilsense::paper::s_t();
/// assert!((coilsense::modes::third_rule_error(&spring, 0.0)? - 0.1027).abs() < 1e-4);
/// # Ok::<(), coilsense::Error>(())
/// ```
pub fn third_rule_error(spring: &Spring, end_mass: f64) -> Result<f64, Error> {
    let rule = third_rule_frequency(spring, end_mass)? * spring.transit_time();
    // A mass too small to count leaves the end free: β = π/2, where m/M has no number.
    let ratio = spring.mass() / end_mass;
    let root = if ratio.is_finite() { end_mass_root(ratio, 1) } else { FRAC_PI_2 };
    Ok(rule / root - 1.0)
}

/// β_j: the root of β tan β = m/M in ((j−1)π, (j−½)π).
pub(crate) fn end_mass_root(mass_ratio: f64, mode: usize) -> f64 {
    let base = PI * (mode - 1) as f64;
    base + bracketed_newton(0.0, FRAC_PI_2, |x| {
        let (sin, cos) = x.sin_cos();
        ((base + x) * sin - mass_ratio * cos, sin + (base + x) * cos + mass_ratio * sin)
    })
}

/// Most frequencies at a time: far above what is heard of a coil, and no burden on memory.
const MAX_COUNT: usize = 1_000_000;
