//! Impulse shapers for commands: ZV and ZVD on the first surge mode.
//!
//! Next door: ramps over a surge period, which spare every mode (`surge`).

use std::f64::consts::PI;

use coilsense_rt::{Delay, Impulse, Shaper};

use super::sampled_spring::SampledSpring;

/// ZV: two impulses half a period of mode 1 apart, after which it does not ring. Modes 3, 5, … are spared, too; even ones are not.
///
/// A = (1, κ)/(1 + κ), κ = e^(−ζπ/√(1−ζ²)), t = (0, π/(ω1 √(1−ζ²)))
///
/// Source:   `[Singer1990]`.
/// Valid:    ζ below 1, the mode where the model has it.
/// Accuracy: no ringing left to 1e-12 for whole delays; else to the error of [`Delay`].
pub fn zero_vibration(spring: &SampledSpring) -> Shaper<f64, 2> {
    let (decay, half) = half_period(spring);
    shaper([1.0, decay], half)
}

/// ZVD: three impulses; the residual's derivative by frequency is zero, too, at the price of another half period.
///
/// A = (1, 2κ, κ²)/(1 + κ)², t = 0, 1, 2 times half a period
///
/// Source:   `[Singer1990]`.
/// Valid:    as [`zero_vibration`].
/// Accuracy: as [`zero_vibration`]; 10 % off in frequency leaves 2.4 % of the ringing, where ZV leaves 16 %.
///
/// ```
/// # let spring = coilsense::paper::s_t();
/// use coilsense::{Damping, mitigation::{SampledSpring, zero_vibration_derivative}};
/// let shaper = zero_vibration_derivative(&SampledSpring::new(&spring, &Damping::None, 2500.0)?);
/// assert_eq!(shaper.impulses.map(|impulse| impulse.amplitude), [0.25, 0.5, 0.25]);
/// # Ok::<(), coilsense::Error>(())
/// ```
pub fn zero_vibration_derivative(spring: &SampledSpring) -> Shaper<f64, 3> {
    let (decay, half) = half_period(spring);
    shaper([1.0, 2.0 * decay, decay * decay], half)
}

/// κ \[1\], and half a damped period of mode 1 \[samples\].
fn half_period(spring: &SampledSpring) -> (f64, f64) {
    let (omega, ratio) = (spring.modes().frequencies()[0], spring.ratios()[0]);
    let swing = (1.0 - ratio * ratio).sqrt();
    ((-ratio * PI / swing).exp(), PI * spring.rate() / (omega * swing))
}

fn shaper<const IMPULSES: usize>(weights: [f64; IMPULSES], spacing: f64) -> Shaper<f64, IMPULSES> {
    let total: f64 = weights.iter().sum();
    let impulse = |index: usize| {
        let late = index as f64 * spacing;
        Impulse { amplitude: weights[index] / total, delay: Delay { whole: late as usize, fraction: late.fract() } }
    };
    Shaper { impulses: std::array::from_fn(impulse) }
}
