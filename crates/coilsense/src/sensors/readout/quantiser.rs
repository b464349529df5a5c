//! Resolution: readings in steps.
//!
//! Next door: noise before the steps (`noise`), which makes their error independent of the quantity.

/// The step nearest to a value.
///
/// y = q round(x/q), mid-tread (zero is a step), halves to the even step, so that rounding favours neither side
///
/// - `value`: x, `step`: q above zero, both in one unit
///
/// Source:   `[Oppenheim2010]` section 4.8.3.
/// Valid:    any size; beyond 2^52 steps a double has no digits left to round, and x is returned.
/// Accuracy: 4e-16 relative (one division, one product); its error has the variance q²/12 where x runs over many steps.
pub(super) fn round(value: f64, step: f64) -> f64 {
    let steps = value / step;
    if steps.abs() < 4_503_599_627_370_496.0 { step * steps.round_ties_even() } else { value }
}
