//! The median of values, which a few strange ones do not move.
//!
//! Next door: spectra's floors (`welch`), noise (`whitening`, `quasi_static`), what hits and lines have in common (`refine`, `explain`).

/// The value in the middle, the upper one of two; zero where there is none. Leaves the values in another order.
pub(super) fn median(values: &mut [f64]) -> f64 {
    if values.is_empty() {
        return 0.0;
    }
    let middle = values.len() / 2;
    *values.select_nth_unstable_by(middle, f64::total_cmp).1
}
