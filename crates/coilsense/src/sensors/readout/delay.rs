//! A reading that comes late: y(t) = x(t − T_d).
//!
//! Next door: a mean, which lags by half its window (`boxcar`).

use super::straight::Straight;

/// `values` a `delay` T_d \[s\] later, at the same `times` \[s\], shape `samples`.
///
/// y(t) = x(t − T_d)
///
/// Source:   definition.
/// Valid:    x straight between samples, constant before the first.
/// Accuracy: 4e-16 of the largest value, and the slope times the last digit of t.
pub(super) fn by(delay: f64, times: &[f64], values: &[f64]) -> Vec<f64> {
    let mut series = Straight::new(times, values);
    times.iter().map(|time| series.at(time - delay)).collect()
}
