//! Running means of a stretch of a series, as they are of the whole of it.
//!
//! Next door: what they are taken of (`forces`).

use std::ops::Range;

/// Means over `window` samples about each sample of `range`, fewer at the ends of the `samples` that there are, taken twice.
///
/// `at` is asked for samples as far from the range as the means reach, and not beyond.
pub(super) fn smoothed(at: impl Fn(usize) -> f64, samples: usize, window: usize, range: Range<usize>) -> Vec<f64> {
    let half = window / 2;
    let wider = |range: &Range<usize>| range.start.saturating_sub(half)..(range.end + half).min(samples);
    let once = wider(&range);
    let raw = wider(&once);
    let values: Vec<f64> = raw.clone().map(at).collect();
    let means = means(&values, raw.start, samples, half, once.clone());
    self::means(&means, once.start, samples, half, range)
}

/// Means at `range` of values that begin with sample `first`.
fn means(values: &[f64], first: usize, samples: usize, half: usize, range: Range<usize>) -> Vec<f64> {
    // Sums count from the first value, so that a large offset does not eat their digits.
    let offset = values.first().copied().unwrap_or(0.0);
    let mut sums = Vec::with_capacity(values.len() + 1);
    let mut sum = 0.0;
    sums.push(sum);
    sums.extend(values.iter().map(|value| {
        sum += value - offset;
        sum
    }));
    let mean = |index: usize| {
        // As many on either side: a slope then leaves no trace.
        let reach = half.min(index).min(samples - 1 - index);
        let (from, to) = (index - reach - first, index + reach + 1 - first);
        offset + (sums[to] - sums[from]) / (2 * reach + 1) as f64
    };
    range.map(mean).collect()
}

#[cfg(test)]
mod tests {
    use super::smoothed;

    #[test]
    fn a_stretch_has_the_means_of_the_whole() {
        let values: Vec<f64> = (0..500).map(|n| (0.3 * f64::from(n)).sin() + 1e-5 * f64::from(n * n)).collect();
        for window in [1, 2, 7, 80, 125] {
            let whole = smoothed(|index| values[index], 500, window, 0..500);
            for range in [0..500, 0..3, 200..217, 470..500, 499..500] {
                let part = smoothed(|index| values[index], 500, window, range.clone());
                let off = part.iter().zip(&whole[range]).fold(0.0, |most: f64, (a, b)| most.max((a - b).abs()));
                // Sums of a stretch are rounded otherwise: those of the whole reach some 400, whose last digit is 6e-14.
                assert!(off < 1e-12, "{window}: {off:e}");
            }
        }
    }

    #[test]
    fn a_slope_is_its_own_mean_up_to_the_ends() {
        let means = smoothed(|index| 3.0 * index as f64, 100, 21, 0..100);
        assert!(means.iter().enumerate().all(|(index, mean)| (mean - 3.0 * index as f64).abs() < 1e-11));
    }
}
