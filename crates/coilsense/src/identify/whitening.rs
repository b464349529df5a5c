//! What of a series its own past does not predict: linear prediction.
//!
//! Ringing goes on as it did, so it is predicted; a hit is not. Next door: hits are looked for in what is left (`hits`).

use realfft::RealFftPlanner;

/// How many past samples predict the next.
pub(super) const ORDER: usize = 64;
/// White noise put under the series, relative to its power, so that a pure sine has a solution.
const FLOOR: f64 = 1e-10;

/// Errors of prediction over their own noise, shape `samples`, the first few zero; and that noise.
///
/// e_n = x_n − Σ_p a_p x_(n−p), a from the Yule–Walker equations of the whole record
///
/// Source:   Levinson's recursion, `[Oppenheim2010]` section 11.3.
/// Valid:    a record whose ringing is steady but for hits.
/// Accuracy: what matters is the ratio to the noise, not its last digits.
pub(super) fn innovations(values: &[f64]) -> (Vec<f64>, f64) {
    let order = ORDER.min(values.len() / 4);
    let correlation = autocorrelation(values, order);
    if correlation[0] <= 0.0 {
        return (vec![0.0; values.len()], 0.0);
    }
    // Turned round, so that it runs the same way as the samples do.
    let mut filter = levinson(&correlation);
    filter.resize(order, 0.0);
    filter.reverse();
    let mut errors = vec![0.0; values.len()];
    for index in order..values.len() {
        errors[index] = values[index] - dot(&values[index - order..index], &filter);
    }
    let noise = median_deviation(&errors[order..]).max(1e-6 * correlation[0].sqrt() / (values.len() as f64).sqrt());
    errors.iter_mut().for_each(|error| *error /= noise);
    (errors, noise)
}

/// Σ a_n b_n in eight sums side by side, which the processor can add at once.
fn dot(left: &[f64], right: &[f64]) -> f64 {
    let mut sums = [0.0; 8];
    let (lefts, rights) = (left.chunks_exact(8), right.chunks_exact(8));
    let rest: f64 = lefts.remainder().iter().zip(rights.remainder()).map(|(a, b)| a * b).sum();
    for (a, b) in lefts.zip(rights) {
        for ((sum, a), b) in sums.iter_mut().zip(a).zip(b) {
            *sum += a * b;
        }
    }
    rest + sums.iter().sum::<f64>()
}

/// r_0…r_order of a series that is zero outside of its samples.
fn autocorrelation(values: &[f64], order: usize) -> Vec<f64> {
    let length = (values.len() + order + 1).next_power_of_two();
    let mut planner = RealFftPlanner::<f64>::new();
    let (forward, backward) = (planner.plan_fft_forward(length), planner.plan_fft_inverse(length));
    let mut padded = values.to_vec();
    padded.resize(length, 0.0);
    let mut lines = forward.make_output_vec();
    // Lengths come from the plans themselves, so neither transform can refuse.
    if forward.process(&mut padded, &mut lines).is_err() {
        return vec![0.0; order + 1];
    }
    lines.iter_mut().for_each(|line| *line = line.norm_sqr().into());
    let mut correlation = backward.make_output_vec();
    if backward.process(&mut lines, &mut correlation).is_err() {
        return vec![0.0; order + 1];
    }
    correlation.truncate(order + 1);
    correlation
}

/// a_1…a_order of the Yule–Walker equations.
fn levinson(correlation: &[f64]) -> Vec<f64> {
    let mut filter: Vec<f64> = Vec::with_capacity(correlation.len());
    let mut error = correlation[0] * (1.0 + FLOOR);
    for order in 1..correlation.len() {
        let known: f64 = filter.iter().enumerate().map(|(p, a)| a * correlation[order - 1 - p]).sum();
        let reflection = (correlation[order] - known) / error;
        let before = filter.clone();
        for (p, a) in filter.iter_mut().enumerate() {
            *a -= reflection * before[order - 2 - p];
        }
        filter.push(reflection);
        error *= 1.0 - reflection * reflection;
        if error <= 0.0 {
            break;
        }
    }
    filter
}

/// Standard deviation of what is normal among values, by their median size.
fn median_deviation(values: &[f64]) -> f64 {
    let mut sizes: Vec<f64> = values.iter().map(|value| value.abs()).collect();
    if sizes.is_empty() {
        return 0.0;
    }
    let middle = sizes.len() / 2;
    let (_, median, _) = sizes.select_nth_unstable_by(middle, f64::total_cmp);
    *median / 0.674_490
}
