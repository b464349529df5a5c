//! Butterworth low-passes as biquads.
//!
//! Next door: the analog one that instruments have (`sensors`), notches (`notch`).

use std::f64::consts::PI;

use coilsense_rt::Biquad;

use crate::error::{Error, Subject, called, check};

/// Butterworth low-pass of order `order` as biquads, the pair of poles nearest to the circle last.
///
/// |H(f)|² = 1 / (1 + (tan(πf/f_s) / tan(πf_c/f_s))^2n)
///
/// - `order`: n, 1 to 8; `cutoff`: f_c \[Hz\], above zero and below half of `rate`; `rate`: f_s \[Hz\]
///
/// Source:   `[Butterworth1930]`; `[Oppenheim2010]` section 7.2.1, bilinear with f_c prewarped.
/// Valid:    0 < f_c < f_s/2.
/// Accuracy: response 1e-12, against SciPy's `butter` (`reference/mitigation.py`).
///
/// # Errors
/// [`Error::Value`] for an order or cut-off outside of that.
///
/// ```
/// let sections = coilsense::mitigation::low_pass(2, 27.0, 2500.0)?;
/// let gain: f64 = sections.iter().map(|s| (s.b0 + s.b1 + s.b2) / (1.0 + s.a1 + s.a2)).product();
/// assert!((gain - 1.0).abs() < 1e-12);
/// # Ok::<(), coilsense::Error>(())
/// ```
pub fn low_pass(order: usize, cutoff: f64, rate: f64) -> Result<Vec<Biquad<f64>>, Error> {
    check((1..=8).contains(&order), "order", order as f64, "", "from 1 to 8")?;
    below_nyquist("cut-off", cutoff, rate)?;
    let warped = (PI * cutoff / rate).tan();
    let mut sections: Vec<Biquad<f64>> = (0..order / 2)
        .map(|pair| {
            let angle = PI * (2 * pair + 1) as f64 / (2 * order) as f64;
            second_order(warped, 2.0 * angle.sin())
        })
        .collect();
    if order % 2 == 1 {
        sections.push(first_order(warped));
    }
    sections.reverse();
    Ok(sections)
}

/// 1/(s² + ds + 1) with s = (1 − z⁻¹)/(1 + z⁻¹)/w.
fn second_order(w: f64, damping: f64) -> Biquad<f64> {
    let scale = 1.0 / (1.0 + damping * w + w * w);
    let b = w * w * scale;
    Biquad { b0: b, b1: 2.0 * b, b2: b, a1: 2.0 * (w * w - 1.0) * scale, a2: (1.0 - damping * w + w * w) * scale }
}

/// 1/(s + 1).
fn first_order(w: f64) -> Biquad<f64> {
    let b = w / (1.0 + w);
    Biquad { b0: b, b1: b, b2: 0.0, a1: (w - 1.0) / (w + 1.0), a2: 0.0 }
}

/// Lets through a frequency \[Hz\] above zero and below half of the sampling rate.
pub(super) fn below_nyquist(quantity: impl Into<Subject>, frequency: f64, rate: f64) -> Result<f64, Error> {
    check(rate.is_finite() && rate > 0.0, called("rate", "sampling rate"), rate, "Hz", "above zero and finite")?;
    let allowed = format!("above zero and below half of the sampling rate of {rate} Hz");
    check(frequency > 0.0 && frequency < 0.5 * rate, quantity, frequency, "Hz", allowed)
}
