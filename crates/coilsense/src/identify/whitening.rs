//! What of a series its own past does not predict: linear prediction.
//!
//! Ringing goes on as it did, so it is predicted; a hit is not. Next door: hits are looked for in what is left (`hits`).

use num_complex::Complex;
use realfft::RealFftPlanner;

use super::median::median;

/// How many past samples predict the next.
pub(super) const ORDER: usize = 64;
/// Samples that are transformed together.
const BLOCK: usize = 16_384;
/// White noise put under the series, relative to its power, so that a pure sine has a solution.
const FLOOR: f64 = 1e-10;

/// What prediction leaves of ringing at most, as a share of the largest force that rings nearby: a filter of finite length does not know
/// all modes, and running means carry a share of a hit to before it. Where a sensor's noise is less, this is what hits have to exceed.
const LEFT: f64 = 0.02;
/// Errors from which their usual size is learnt, at most.
const LEARNT: usize = 1_000_000;

/// What of the means of every `step` samples the past ones do not predict, in all series of a record.
#[derive(Debug, Clone)]
pub(super) struct Surprise {
    /// Samples of a series per sample that is predicted.
    pub(super) step: usize,
    /// Σ over the series of the errors' squares, each over its noise or over what prediction leaves of ringing, whichever is more; the first few
    /// zero; shape `samples / step`.
    pub(super) squares: Vec<f64>,
}

impl Surprise {
    /// Of no series yet.
    pub(super) fn none(samples: usize, step: usize) -> Self {
        Self { step, squares: vec![0.0; samples.div_ceil(step)] }
    }

    /// Adds a series; its noise as dense as that of the means \[the series' unit\].
    ///
    /// e_n = x_n − Σ_p a_p x_(n−p), a from the Yule–Walker equations of the whole record; `block`: samples nearby; `rounding`: standard
    /// deviation of what the last digit adds to a sample, below which errors say nothing.
    ///
    /// Source:   Levinson's recursion, `[Oppenheim2010]` section 11.3.
    /// Valid:    a record whose ringing is steady but for hits.
    /// Accuracy: what matters is the ratio to the noise, not its last digits.
    pub(super) fn add(&mut self, series: &[f64], block: usize, rounding: f64) -> f64 {
        let step = self.step;
        let block = (block / step).max(1);
        if step <= 1 {
            return self.add_at_pace(series, block, rounding);
        }
        // Means keep pulses that run to and fro from being missed between samples.
        let means: Vec<f64> = series.chunks(step).map(|part| part.iter().sum::<f64>() / part.len() as f64).collect();
        // Rounding errors of a quiet signal stay alike over many samples, those of a busy one are independent: between 1 and 1/√step of one.
        self.add_at_pace(&means, block, rounding / (step as f64).powf(0.25))
    }

    fn add_at_pace(&mut self, values: &[f64], block: usize, rounding: f64) -> f64 {
        let order = ORDER.min(values.len() / 4);
        let correlation = autocorrelation(values, order);
        if correlation[0] <= 0.0 {
            return 0.0;
        }
        // Turned round, so that it runs the same way as the samples do.
        let mut filter = levinson(&correlation);
        filter.resize(order, 0.0);
        filter.reverse();
        let error = |index: usize| values[index] - dot(&values[index - order..index], &filter);
        let least = 1e-6 * correlation[0].sqrt() / (values.len() as f64).sqrt();
        let stride = (values.len() / LEARNT).max(1);
        let noise = median_deviation((order..values.len()).step_by(stride).map(error)).max(least).max(rounding);
        let peaks: Vec<f64> =
            values.chunks(block).map(|part| part.iter().fold(0.0, |most: f64, x| most.max(x.abs()))).collect();
        for (own, squares) in self.squares.chunks_mut(block).enumerate() {
            let near = &peaks[own.saturating_sub(1)..(own + 2).min(peaks.len())];
            let scale = noise.max(LEFT * near.iter().fold(0.0, |most: f64, peak| most.max(*peak)));
            for (index, square) in (own * block..).zip(squares).skip(order.saturating_sub(own * block)) {
                *square += (error(index) / scale).powi(2);
            }
        }
        noise
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
fn median_deviation(values: impl Iterator<Item = f64>) -> f64 {
    let mut sizes: Vec<f64> = values.map(f64::abs).collect();
    median(&mut sizes) / 0.674_490
}
