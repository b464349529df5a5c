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

/// The same where each value counts as much as its weight says, which none must lack: (value, weight).
pub(super) fn weighted_median(values: &mut [(f64, f64)]) -> f64 {
    values.sort_by(|a, b| a.0.total_cmp(&b.0));
    let half = 0.5 * values.iter().map(|(_, weight)| weight).sum::<f64>();
    let mut below = 0.0;
    for (value, weight) in values.iter() {
        below += weight;
        if below > half {
            return *value;
        }
    }
    values.last().map_or(0.0, |(value, _)| *value)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_sure_value_outweighs_three_that_are_not() {
        let mut values = [(1.0, 10.0), (5.0, 1.0), (7.0, 2.0), (-3.0, 3.0)];
        assert_eq!(weighted_median(&mut values), 1.0);
        let mut alike = [3.0, 1.0, 4.0, 2.0];
        let mut weighted = alike.map(|value| (value, 0.5));
        assert_eq!(weighted_median(&mut weighted), median(&mut alike));
        assert_eq!(weighted_median(&mut []), 0.0);
    }
}
