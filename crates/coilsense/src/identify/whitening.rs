//! What of a series its own past does not predict: linear prediction.
//!
//! Ringing goes on as it did, so it is predicted; a hit is not. Next door: hits are looked for in what is left (`hits`).

use num_complex::Complex;
use realfft::RealFftPlanner;

/// How many past samples predict the next.
pub(super) const ORDER: usize = 64;
/// Samples that are transformed together.
const BLOCK: usize = 16_384;
/// White noise put under the series, relative to its power, so that a pure sine has a solution.
const FLOOR: f64 = 1e-10;

/// What of the means of every `step` samples the past ones do not predict.
#[derive(Debug, Clone)]
pub(super) struct Surprise {
    /// Samples of the series per sample that is predicted.
    pub(super) step: usize,
    /// Errors of prediction over their noise, the first few zero; shape `samples / step`.
    pub(super) values: Vec<f64>,
    /// Standard deviation of the errors, in the series' unit.
    pub(super) noise: f64,
    /// Largest size of what is predicted in each block, in the series' unit.
    pub(super) peaks: Vec<f64>,
    /// Length of a block \[values\].
    pub(super) block: usize,
}

impl Surprise {
    /// e_n = x_n − Σ_p a_p x_(n−p), a from the Yule–Walker equations of the whole record; `rounding`: standard deviation of what the last digit
    /// adds to a sample, below which errors say nothing.
    ///
    /// Source:   Levinson's recursion, `[Oppenheim2010]` section 11.3.
    /// Valid:    a record whose ringing is steady but for hits.
    /// Accuracy: what matters is the ratio to the noise, not its last digits.
    pub(super) fn of(series: &[f64], step: usize, block: usize, rounding: f64) -> Self {
        let block = (block / step).max(1);
        if step <= 1 {
            return Self::at_pace(series, 1, block, rounding);
        }
        // Means keep pulses that run to and fro from being missed between samples.
        let means: Vec<f64> = series.chunks(step).map(|part| part.iter().sum::<f64>() / part.len() as f64).collect();
        // Rounding errors of a quiet signal stay alike over many samples, those of a busy one are independent: between 1 and 1/√step of one.
        Self::at_pace(&means, step, block, rounding / (step as f64).powf(0.25))
    }

    fn at_pace(values: &[f64], step: usize, block: usize, rounding: f64) -> Self {
        let peaks = values.chunks(block).map(|part| part.iter().fold(0.0, |most: f64, x| most.max(x.abs()))).collect();
        let order = ORDER.min(values.len() / 4);
        let correlation = autocorrelation(values, order);
        if correlation[0] <= 0.0 {
            return Self { step, values: vec![0.0; values.len()], noise: 0.0, peaks, block };
        }
        // Turned round, so that it runs the same way as the samples do.
        let mut filter = levinson(&correlation);
        filter.resize(order, 0.0);
        filter.reverse();
        let mut errors = vec![0.0; values.len()];
        for index in order..values.len() {
            errors[index] = values[index] - dot(&values[index - order..index], &filter);
        }
        let least = 1e-6 * correlation[0].sqrt() / (values.len() as f64).sqrt();
        let noise = median_deviation(&errors[order..]).max(least).max(rounding);
        errors.iter_mut().for_each(|error| *error /= noise);
        Self { step, values: errors, noise, peaks, block }
    }
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

/// r_0…r_order of a series that is zero outside of its samples, added up over blocks.
fn autocorrelation(values: &[f64], order: usize) -> Vec<f64> {
    let length = (values.len() + order + 1).next_power_of_two().min(BLOCK);
    let mut planner = RealFftPlanner::<f64>::new();
    let (forward, backward) = (planner.plan_fft_forward(length), planner.plan_fft_inverse(length));
    let mut input = forward.make_input_vec();
    let (mut own, mut ahead) = (forward.make_output_vec(), forward.make_output_vec());
    let mut sum = forward.make_output_vec();
    let mut transform = |part: &[f64], lines: &mut [Complex<f64>]| {
        input.fill(0.0);
        input[..part.len()].copy_from_slice(part);
        // Lengths come from the plans themselves, so neither transform can refuse.
        forward.process(&mut input, lines).is_ok()
    };
    let block = length - order - 1;
    for start in (0..values.len()).step_by(block) {
        let end = (start + block).min(values.len());
        let further = (end + order).min(values.len());
        if !(transform(&values[start..end], &mut own) && transform(&values[start..further], &mut ahead)) {
            return vec![0.0; order + 1];
        }
        sum.iter_mut().zip(own.iter().zip(&ahead)).for_each(|(sum, (own, ahead))| *sum += own.conj() * ahead);
    }
    // Of a real series both are real; what rounding leaves of the rest would be refused.
    sum[0].im = 0.0;
    sum[length / 2].im = 0.0;
    let mut correlation = backward.make_output_vec();
    if backward.process(&mut sum, &mut correlation).is_err() {
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
