//! What nulls all surge frequencies at once: means and combs of one surge period 2τ.
//!
//! Next door: single notches (`notch`), a window fitted to noise and tolerances (`window`).

use std::f64::consts::PI;

use coilsense_rt::{Boxcar, Comb, DoubleBoxcar};

use super::sampled_spring::SampledSpring;
use crate::error::{Error, called, check};

/// The mean over `length` samples, at least 1.
fn mean(length: f64) -> Boxcar<f64> {
    Boxcar { whole: length as usize, fraction: length.fract(), scale: 1.0 / length }
}

/// The mean over one surge period 2τ: a filter of forces, or, on a command, a ramp of that length in place of every step.
///
/// H(f) = sinc(f/f1) e^(−iπf/f1), nearly: zero at every n·f1, late by τ
///
/// Source:   surge frequencies n·f1 with f1 = 1/2τ, `[Weijde2017]` eq. 3.
/// Valid:    2τ of at least 2 samples, as [`SampledSpring`] sees to; modes at n·f1 (the chain's mode 5 of S_T lies 0.38 % below).
/// Accuracy: where 2τ is no whole number of samples, zeros are off by at most (ωT)²/8: 0.2 % of a sine at f1 for S_T at 2.5 kHz.
///
/// ```
/// # let spring = coilsense::paper::s_t();
/// use coilsense::{Damping, mitigation::{SampledSpring, surge_mean}};
/// let mean = surge_mean(&SampledSpring::new(&spring, &Damping::None, 2500.0)?);
/// assert_eq!(mean.whole, 46);
/// # Ok::<(), coilsense::Error>(())
/// ```
pub fn surge_mean(spring: &SampledSpring) -> Boxcar<f64> {
    mean(spring.surge_period())
}

/// Means over 2τ(1 + `spread`) and 2τ(1 − `spread`), one after the other: small over a band around each n·f1; `spread` 0 doubles the zeros.
///
/// # Errors
/// [`Error::Value`] for a spread below 0 or from ½ on.
pub fn double_mean(spring: &SampledSpring, spread: f64) -> Result<DoubleBoxcar<f64>, Error> {
    check((0.0..0.5).contains(&spread), called("spread", "spread of the means"), spread, "", "from 0 to below 0.5")?;
    let period = spring.surge_period();
    Ok(DoubleBoxcar { first: mean(period * (1.0 + spread)), second: mean(period * (1.0 - spread)) })
}

/// A comb with a notch `width` \[Hz\] wide (−3 dB) at every n·f1, n ≥ 1.
///
/// ρ = e^(−π·width/f_s)
///
/// Source:   [`Comb`]; a pole at radius ρ within a zero on the circle makes a notch −(f_s/π) ln ρ wide.
/// Valid:    widths small against f1; from f1 on it is hardly a comb and nears the mean.
/// Accuracy: −3 dB to 5 % of the width for widths up to f1/4.
///
/// # Errors
/// [`Error::Value`] for a width that is not above zero or beyond f1.
pub fn surge_comb(spring: &SampledSpring, width: f64) -> Result<Comb<f64>, Error> {
    let first = spring.spring().surge_frequency();
    let allowed = format!("above zero and at most the first surge frequency of {first:.3} Hz");
    check(width > 0.0 && width <= first, called("width", "notch width"), width, "Hz", allowed)?;
    let length = spring.surge_period();
    let exponent = -PI * width / spring.rate();
    // 1 − ρ and 1 − ρᴸ without cancellation.
    let scale = (exponent * length).exp_m1() / (length * exponent.exp_m1());
    Ok(Comb { period: Boxcar { scale, ..mean(length) }, radius: exponent.exp(), feedback: (exponent * length).exp() })
}
