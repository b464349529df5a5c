//! What a channel's last digit is worth.
//!
//! Next door: the other checks of a channel (`channel_check`).

/// How many pairs of neighbours are looked at, about.
const PAIRS: usize = 65_536;
/// How near a difference must lie to a multiple of the digit, as a share of it; and the share of differences that must.
const NEAR: f64 = 0.05;
const SHARE: f64 = 0.98;
/// Fewest differences that tell a step.
const LEAST: usize = 32;
/// Differences may be this many digits at most: beyond, the digit is of no account.
const MOST: f64 = 1e6;

/// The step of which all differences of neighbours are multiples; none where none shows.
///
/// From the least difference on, larger ones make the step sharper: q = Σ m d/Σ m², m = round(d/q).
pub(super) fn of(values: &[f64]) -> Option<f64> {
    let stride = (values.len() / PAIRS).max(1);
    let differences = (1..values.len()).step_by(stride).map(|index| (values[index] - values[index - 1]).abs());
    let largest = values.iter().fold(0.0, |most: f64, value| most.max(value.abs()));
    // Below the rounding of the numbers themselves there is no digit.
    let mut differences: Vec<f64> = differences.filter(|difference| *difference > 1e-13 * largest).collect();
    if differences.len() < LEAST {
        return None;
    }
    differences.sort_by(f64::total_cmp);
    (1..=4).map(|part| differences[0] / f64::from(part)).find_map(|guess| step(&differences, guess))
}

/// A guess made sharp over ever larger differences, where nearly all are its multiples.
fn step(sorted: &[f64], guess: f64) -> Option<f64> {
    let mut digit = guess;
    let mut reach = 4.0;
    while reach < MOST {
        let (mut product, mut square) = (0.0, 0.0);
        for difference in sorted.iter().take_while(|difference| **difference < reach * digit) {
            let multiple = (difference / digit).round();
            product += multiple * difference;
            square += multiple * multiple;
        }
        if square > 0.0 {
            digit = product / square;
        }
        reach *= 4.0;
    }
    let near = |difference: &&f64| {
        let multiple = **difference / digit;
        (multiple - multiple.round()).abs() < NEAR
    };
    let enough = sorted.iter().filter(near).count() as f64 >= SHARE * sorted.len() as f64;
    enough.then_some(digit)
}
