//! A smooth curve that comes back to where it began, as polynomials.
//!
//! Next door: the cam that it is laid through (`cam`).

/// The cubic spline of period 1 through `values` at `places` (ascending, from 0 to below 1, at least three), twice differentiable everywhere: of each
/// piece the powers of what lies behind its begin.
pub(super) fn periodic_spline(places: &[f64], values: &[f64]) -> Vec<Vec<f64>> {
    let count = places.len();
    let step = |index: usize| match index + 1 < count {
        true => places[index + 1] - places[index],
        false => 1.0 + places[0] - places[index],
    };
    let next = |index: usize| (index + 1) % count;
    let before = |index: usize| (index + count - 1) % count;
    let slope = |index: usize| (values[next(index)] - values[index]) / step(index);
    let diagonal: Vec<f64> = (0..count).map(|index| 2.0 * (step(before(index)) + step(index))).collect();
    let right: Vec<f64> = (0..count).map(|index| 6.0 * (slope(index) - slope(before(index)))).collect();
    // Cyclic: the corner is taken off as a product of two vectors, and put back after Sherman and Morrison.
    let corner = step(count - 1);
    let gamma = -diagonal[0];
    let mut reduced = diagonal;
    reduced[0] -= gamma;
    reduced[count - 1] -= corner * corner / gamma;
    let beside: Vec<f64> = (0..count - 1).map(step).collect();
    let mut column = vec![0.0; count];
    (column[0], column[count - 1]) = (gamma, corner);
    let (plain, turned) = (tridiagonal(&reduced, &beside, right), tridiagonal(&reduced, &beside, column));
    let share = |of: &[f64]| of[0] + corner / gamma * of[count - 1];
    let factor = share(&plain) / (1.0 + share(&turned));
    let curvature: Vec<f64> = plain.iter().zip(&turned).map(|(plain, turned)| plain - factor * turned).collect();
    let piece = |index: usize| {
        let (step, here, after) = (step(index), curvature[index], curvature[next(index)]);
        let rate = slope(index) - step * (2.0 * here + after) / 6.0;
        vec![values[index], rate, 0.5 * here, (after - here) / (6.0 * step)]
    };
    (0..count).map(piece).collect()
}

/// A symmetric tridiagonal system that needs no exchange of rows.
fn tridiagonal(diagonal: &[f64], beside: &[f64], mut right: Vec<f64>) -> Vec<f64> {
    let count = diagonal.len();
    let mut pivots = diagonal.to_vec();
    for index in 1..count {
        let share = beside[index - 1] / pivots[index - 1];
        pivots[index] -= share * beside[index - 1];
        right[index] -= share * right[index - 1];
    }
    right[count - 1] /= pivots[count - 1];
    for index in (0..count - 1).rev() {
        right[index] = (right[index] - beside[index] * right[index + 1]) / pivots[index];
    }
    right
}

/// A polynomial about a place that lies `since` behind its begin.
pub(super) fn shifted(powers: &[f64], since: f64) -> Vec<f64> {
    let mut moved = powers.to_vec();
    for from in 0..moved.len() {
        for power in (from..moved.len() - 1).rev() {
            moved[power] += since * moved[power + 1];
        }
    }
    moved
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_period_of_a_sine_is_met_to_the_fourth_power_of_the_step() {
        for (count, most) in [(20_usize, 1e-4), (40, 7e-6)] {
            let places: Vec<f64> = (0..count).map(|index| 0.01 + index as f64 / count as f64).collect();
            let values: Vec<f64> = places.iter().map(|x| (std::f64::consts::TAU * x).sin()).collect();
            let pieces = periodic_spline(&places, &values);
            for (index, piece) in pieces.iter().enumerate() {
                let since = 0.4 / count as f64;
                let value = shifted(piece, since)[0];
                let expected = (std::f64::consts::TAU * (places[index] + since)).sin();
                assert!((value - expected).abs() < most, "{index}: {:e}", value - expected);
                // As smooth where pieces meet, the last and the first among them.
                let end =
                    shifted(piece, if index + 1 < count { places[index + 1] } else { 1.0 + places[0] } - places[index]);
                let begin = &pieces[(index + 1) % count];
                for order in 0..3 {
                    assert!((end[order] - begin[order]).abs() < 1e-9, "{index} {order}");
                }
            }
        }
    }
}
