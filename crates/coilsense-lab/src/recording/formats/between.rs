//! Straight lines between the points of a table, as scales and conversions of instruments have them.
//!
//! Next door: the readers whose files hold such tables (`tdms`, `mdf3`).

/// The value on the line between two points, whose first numbers rise; beyond the outer points their own.
pub(super) fn between(points: &[[f64; 2]], x: f64) -> f64 {
    let after = points.partition_point(|point| point[0] <= x);
    match (after.checked_sub(1).map(|before| points[before]), points.get(after)) {
        _ if x.is_nan() => x,
        (None, Some(first)) => first[1],
        (Some(last), None) => last[1],
        (Some(before), Some(after)) => (after[1] - before[1]) / (after[0] - before[0]) * (x - before[0]) + before[1],
        (None, None) => f64::NAN,
    }
}
