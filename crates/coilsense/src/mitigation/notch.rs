//! Notches: one, or a set on the surge frequencies.
//!
//! Next door: all of them for the price of a ring (`surge`), low-passes (`butterworth`).

use std::f64::consts::PI;

use coilsense_rt::Biquad;

use super::butterworth::below_nyquist;
use super::sampled_spring::SampledSpring;
use crate::error::{Error, above_zero, called, check};

/// A notch: nothing at `frequency`, −3 dB at the edges of a band of `frequency / quality` around it.
///
/// H(z) = g (1 − 2 cos ω z⁻¹ + z⁻²) / (1 − 2g cos ω z⁻¹ + (2g − 1) z⁻²), ω = 2πf/f_s, g = 1/(1 + tan(ω/2Q))
///
/// - `frequency`: f \[Hz\], above zero and below half of `rate`; `quality`: Q \[1\], above zero; `rate`: f_s \[Hz\]
///
/// Source:   bilinear transform of the analog notch, centre and width prewarped, `[Oppenheim2010]` section 7.2.
/// Valid:    f/Q below f_s/2.
/// Accuracy: response 1e-12, against SciPy's `iirnotch` (`reference/mitigation.py`).
///
/// # Errors
/// [`Error::Value`] for a frequency or quality outside of that.
///
/// ```
/// let notch = coilsense::mitigation::notch(54.065, 2.0, 2500.0)?;
/// assert!((notch.b0 + notch.b1 + notch.b2) - (1.0 + notch.a1 + notch.a2) < 1e-15);
/// # Ok::<(), coilsense::Error>(())
/// ```
pub fn notch(frequency: f64, quality: f64, rate: f64) -> Result<Biquad<f64>, Error> {
    below_nyquist(called("frequency", "notch frequency"), frequency, rate)?;
    above_zero(called("quality", "notch quality"), quality, "")?;
    let omega = 2.0 * PI * frequency / rate;
    let allowed = format!("above {} at this frequency and sampling rate", omega / PI);
    check(omega / quality < PI, called("quality", "notch quality"), quality, "", allowed)?;
    let gain = 1.0 / (1.0 + (0.5 * omega / quality).tan());
    let middle = -2.0 * gain * omega.cos();
    Ok(Biquad { b0: gain, b1: middle, b2: gain, a1: middle, a2: 2.0 * gain - 1.0 })
}

/// Notches at n·f1 for n = 1…`count`, one Q for all, so that each covers the same share of a tolerance of f1.
///
/// # Errors
/// [`Error::Value`] where the highest is not below half of the sampling rate, for no notch at all, and as [`notch()`].
pub fn surge_notches(spring: &SampledSpring, count: usize, quality: f64) -> Result<Vec<Biquad<f64>>, Error> {
    let first = spring.spring().surge_frequency();
    let most = (0.5 * spring.rate() / first).ceil() as usize - 1;
    let allowed = format!("from 1 to {most}, so that {first:.3} Hz times it stays below half of the sampling rate");
    check((1..=most).contains(&count), called("count", "number of notches"), count as f64, "", allowed)?;
    (1..=count).map(|n| notch(n as f64 * first, quality, spring.rate())).collect()
}
