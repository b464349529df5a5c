//! Samples at a rate of the instrument's own, each held until the next.
//!
//! Next door: the noise that comes with each sample (`noise`).

use super::straight::Straight;

/// What an instrument that samples at `rate` f_s \[Hz\] shows at `times` \[s\], shape `samples`.
///
/// y(t) = x(k/f_s), k = ⌊t f_s⌋
///
/// Source:   `[Oppenheim2010]` section 4.8.4, the zero-order hold.
/// Valid:    x straight between samples, constant before the first; samples at whole multiples of 1/f_s from t = 0.
/// Accuracy: 4e-16 of the largest value. A time that rounds to just before a sample (1e-6 of the interval) still means that sample.
pub(super) fn at_rate(rate: f64, times: &[f64], values: &[f64]) -> Vec<f64> {
    let mut series = Straight::new(times, values);
    times.iter().map(|&time| series.at(sample_at(time, rate) / rate)).collect()
}

/// k: number of the sample that is shown at a time \[s\]; a whole number, kept as a float because times may be far from zero.
pub(super) fn sample_at(time: f64, rate: f64) -> f64 {
    (time * rate + 1e-6).floor()
}
