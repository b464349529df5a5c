//! Settings of the fusion of F_L with F_i.
//!
//! Next door: F_L itself (`sensors`).

use std::f64::consts::PI;

use coilsense_rt::{Delay, Fusion};

use super::butterworth::below_nyquist;
use crate::error::{Error, called, check, not_negative};

/// Below `crossover` the slow force counts, above it the fast one.
///
/// g = 1 − e^(−2πf_c/f_L)
///
/// - `crossover`: f_c \[Hz\], above zero and below half of `slow_rate`; `slow_rate`: f_L \[Hz\], how often there is a new F_L
/// - `lateness`: how late F_L is \[s\]; `rate`: how often F_i is read \[Hz\], at least `slow_rate`
///
/// Source:   [`Fusion`]; a pole at e^(−2πf_c/f_L) is a low-pass of first order at f_c.
/// Valid:    f_c below f1, so that the bias does not follow the ringing by which both ends differ.
/// Accuracy: −3 dB at f_c to (πf_c/f_L)²/6 relative.
///
/// # Errors
/// [`Error::Value`] for rates, crossover or lateness outside of that.
///
/// ```
/// let fusion = coilsense::mitigation::inductance_fusion(1.0, 25.0, 0.02, 2500.0)?;
/// assert_eq!(fusion.lateness.whole, 50);
/// assert!((fusion.gain - 0.2222).abs() < 1e-4);
/// # Ok::<(), coilsense::Error>(())
/// ```
pub fn inductance_fusion(crossover: f64, slow_rate: f64, lateness: f64, rate: f64) -> Result<Fusion<f64>, Error> {
    below_nyquist("crossover", crossover, slow_rate)?;
    let allowed = format!("finite and at least the rate of the slow force of {slow_rate} Hz");
    check(rate.is_finite() && rate >= slow_rate, called("rate", "sampling rate"), rate, "Hz", allowed)?;
    not_negative(called("lateness", "lateness of the slow force"), lateness, "s")?;
    let late = lateness * rate;
    let most = 1e6;
    let allowed = format!("at most {most:e} samples of the fast force");
    check(late <= most, called("lateness", "lateness of the slow force"), lateness, "s", allowed)?;
    let gain = -(-2.0 * PI * crossover / slow_rate).exp_m1();
    Ok(Fusion { gain, lateness: Delay { whole: late as usize, fraction: late.fract() } })
}
