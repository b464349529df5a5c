//! Normal numbers by a seed and a count, the same bits everywhere.
//!
//! Next door: who needs them (`readout`), roots and sines (`elementary`). C has them line by line (`coilsense-lab`, `plant/readout.h`).

use crate::elementary::{natural_logarithm, quarter_turns, sine_and_cosine_less_one, square_root};

/// 2⁻⁵³.
const LAST: f64 = 1.110_223_024_625_156_5e-16;
/// The golden ratio's fractional part in 64 bits, which is odd.
const STRIDE: u64 = 0x9E37_79B9_7F4A_7C15;

/// One of a series of independent normal numbers of variance 1.
///
/// z = √(−2 ln u) cos 2πv, u and v uniform
///
/// - `seed`: which series; `count`: which of its numbers
///
/// Source:   Box and Muller 1958; uniform numbers by SplitMix64 (Steele, Lea and Flood 2014), mixed from seed and count.
/// Valid:    2⁶³ numbers a seed; up to 8.6 in size.
/// Accuracy: moments, distribution and whiteness within four standard errors for a million numbers (test).
pub fn normal(seed: u64, count: u64) -> f64 {
    let begin = mixed(seed.wrapping_add(STRIDE));
    let place = begin.wrapping_add(count.wrapping_mul(2).wrapping_mul(STRIDE));
    let [first, second] = [place, place.wrapping_add(STRIDE)].map(|place| mixed(place) >> 11);
    // Above zero, at most 1.
    let u = (first as f64 + 1.0) * LAST;
    let (quarters, rest) = quarter_turns(second as f64 * (LAST * core::f64::consts::TAU));
    let [sine, less] = sine_and_cosine_less_one(rest);
    let cosine = match quarters {
        0 => 1.0 + less,
        1 => -sine,
        2 => -(1.0 + less),
        _ => sine,
    };
    let square = -2.0 * natural_logarithm(u);
    if square > 0.0 { square_root(square) * cosine } else { 0.0 }
}

/// SplitMix64's finish.
fn mixed(place: u64) -> u64 {
    let once = (place ^ (place >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    let twice = (once ^ (once >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
    twice ^ (twice >> 31)
}

#[cfg(test)]
mod tests {
    extern crate std;
    use std::vec::Vec;

    use super::*;

    const COUNT: usize = 1_000_000;

    fn series(seed: u64) -> Vec<f64> {
        (0..COUNT as u64).map(|count| normal(seed, count)).collect()
    }

    #[test]
    fn numbers_are_normal_and_white() {
        for seed in [0, 1, u64::MAX] {
            let numbers = series(seed);
            let count = COUNT as f64;
            let moment = |power: i32| numbers.iter().map(|z| z.powi(power)).sum::<f64>() / count;
            // Four standard errors: of z, z², z³, z⁴ with variances 1, 2, 15, 96.
            for (power, expected, variance) in [(1, 0.0, 1.0), (2, 1.0, 2.0), (3, 0.0, 15.0), (4, 3.0, 96.0)] {
                let off = moment(power) - expected;
                assert!(off.abs() < 4.0 * f64::sqrt(variance / count), "seed {seed}, power {power}: {off}");
            }
            for lag in 1..6 {
                let together: f64 = numbers.windows(lag + 1).map(|pair| pair[0] * pair[lag]).sum::<f64>() / count;
                assert!(together.abs() < 4.0 / f64::sqrt(count), "seed {seed}, {lag} apart: {together}");
            }
            // Shares beyond 1, 2, 3 and 4.
            for (beyond, share) in [(1.0, 0.317_310_508), (2.0, 0.045_500_264), (3.0, 0.002_699_796), (4.0, 6.334e-5)] {
                let found = numbers.iter().filter(|z| z.abs() > beyond).count() as f64 / count;
                assert!(
                    (found - share).abs() < 4.0 * f64::sqrt(share / count),
                    "seed {seed}, beyond {beyond}: {found}"
                );
            }
        }
    }

    #[test]
    fn seeds_that_are_neighbours_have_nothing_in_common() {
        let (one, other) = (series(7), series(8));
        let together: f64 = one.iter().zip(&other).map(|(a, b)| a * b).sum::<f64>() / COUNT as f64;
        assert!(together.abs() < 4e-3, "{together}");
        let shifted: f64 = one[1..].iter().zip(&other).map(|(a, b)| a * b).sum::<f64>() / COUNT as f64;
        assert!(shifted.abs() < 4e-3, "{shifted}");
        assert_eq!(normal(7, 3).to_bits(), one[3].to_bits());
    }
}
