//! The middle of values, which a few of them do not move.

/// The middle one of an odd number, the mean of both of an even number; none of none.
pub(crate) fn median(values: impl Iterator<Item = f64>) -> Option<f64> {
    let mut values: Vec<f64> = values.collect();
    values.sort_by(f64::total_cmp);
    let middle = values.get(values.len() / 2)?;
    Some(0.5 * (middle + values[(values.len() - 1) / 2]))
}
