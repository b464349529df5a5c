//! Whether a quantity drifts from run to run: a test that one outlier, such as a resonance, does not upset.
//!
//! Next door: one series against another (`deviation`).

use crate::error::{Error, all_finite, called, check, number_of};

/// Most values of a trend: the exact distribution takes their cube.
const MOST: usize = 200;

/// Drift of a quantity over values in the order in which they were recorded.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Trend {
    /// S: pairs that rise less pairs that fall.
    pub rises: i64,
    /// Probability of an S at least this large either way where there is no drift \[1\].
    pub p: f64,
    /// Median of the slopes between all pairs \[unit of the values per step\].
    pub slope: f64,
}

impl Trend {
    /// Kendall's test of values against their order, and the slope of Theil and Sen.
    ///
    /// S = Σ_{i<j} sgn(x_j − x_i); p = P(|S'| ≥ |S|) over all orders, each as likely; slope = median (x_j − x_i)/(j − i)
    ///
    /// - `values`: x, shape `runs`, 3 to 200 of them, in recorded order
    ///
    /// Source:   `[Kendall1938]` (test), `[Sen1968]` (slope).
    /// Valid:    values that are independent but for the drift. Values that are equal count neither way, which makes p too large.
    /// Accuracy: p to 1e-12 relative; without a normal approximation.
    ///
    /// # Errors
    /// [`Error::Count`] for too few or too many values; [`Error::Value`] for one that is not finite.
    ///
    /// ```
    /// let trend = coilsense::measures::Trend::of(&[1.0, 2.0, 3.0, 9.0, 5.0])?;
    /// assert_eq!((trend.rises, trend.slope), (8, 1.0));
    /// assert!((trend.p - 10.0 / 120.0).abs() < 1e-15); // 5 of 120 orders rise at least so often, 5 fall
    /// # Ok::<(), coilsense::Error>(())
    /// ```
    pub fn of(values: &[f64]) -> Result<Self, Error> {
        if !(3..=MOST).contains(&values.len()) {
            return Err(number_of(called("values", "values of a trend"), values.len(), format!("3 to {MOST}")));
        }
        all_finite("values", values, "")?;
        let mut rises = 0;
        let mut slopes = Vec::with_capacity(values.len() * (values.len() - 1) / 2);
        for (later, x) in values.iter().enumerate() {
            for (earlier, before) in values[..later].iter().enumerate() {
                rises += i64::from(x > before) - i64::from(x < before);
                slopes.push((x - before) / (later - earlier) as f64);
            }
        }
        slopes.sort_by(f64::total_cmp);
        let middle = slopes.len() / 2;
        let slope = if slopes.len() % 2 == 1 { slopes[middle] } else { 0.5 * (slopes[middle - 1] + slopes[middle]) };
        check(slope.is_finite(), "slope of the trend", slope, "", "finite")?;
        Ok(Self { rises, p: probability(values.len(), rises.unsigned_abs() as usize), slope })
    }
}

/// P(|S| ≥ s) over all orders of n values.
///
/// The number of inversions of a random order is the sum of independent ones, 0 to i of the i-th value: S = n(n − 1)/2 − 2 inversions.
fn probability(n: usize, s: usize) -> f64 {
    let most = n * (n - 1) / 2;
    let mut shares = vec![1.0];
    for value in 1..n {
        let mut next = vec![0.0; shares.len() + value];
        for (inversions, share) in shares.iter().enumerate() {
            for more in 0..=value {
                next[inversions + more] += share / (value + 1) as f64;
            }
        }
        shares = next;
    }
    let beyond = |(inversions, share): (usize, &f64)| if most.abs_diff(2 * inversions) >= s { *share } else { 0.0 };
    shares.iter().enumerate().map(beyond).sum()
}
