//! Which part of an error counts: all of it, or what a low-pass at the wanted bandwidth leaves.
//!
//! Next door: whose errors (`verdict`), the low-pass itself (`coilsense::sensors`).

use std::ops::Range;

use coilsense::Error;
use coilsense::sensors::{MAX_ORDER, Readout, ReadoutParameters};

/// Filters have forgotten all but 6e-6 of what was before so many of their times: an error may be a thousandth of what is filtered.
const FORGOTTEN: f64 = 12.0;

/// `errors` \[N\] of a whole run at `times` \[s\] (both of shape `samples`) as they count in the `judged` samples: shape `judged`.
///
/// e − mean through a Butterworth low-pass of order 8 at the bandwidth \[Hz\], at rest before t = 0, and the mean of the judged samples
///
/// A spectrum of the judged samples would not do: its taper forgets a shock at the beginning, its lines are wider than the band where
/// the window is short, and a mean over a broken number of periods of a strong line is no slow error.
///
/// Source:   definition of the goal; `[Butterworth1930]`.
/// Valid:    any window, also one shorter than a period of the bandwidth: then it is the mean of the window that counts.
/// Accuracy: a line 1.35 times the bandwidth counts with 9 %, 2.7 times with 0.04 % of itself; at the bandwidth with 71 %.
///
/// # Errors
/// Those of [`Readout::ideal_series`].
pub(super) fn within(
    errors: &[f64],
    times: &[f64],
    judged: &Range<usize>,
    bandwidth: Option<f64>,
) -> Result<Vec<f64>, Error> {
    let Some(bandwidth) = bandwidth else { return Ok(errors[judged.clone()].to_vec()) };
    let mean = errors[judged.clone()].iter().sum::<f64>() / judged.len() as f64;
    let low_pass = filter(bandwidth)?;
    // A sample more, ahead of the run, where the filter rests at the mean.
    let step = if times.len() > 1 { times[1] - times[0] } else { 1.0 };
    let with_rest: Vec<f64> = [times[0] - step].into_iter().chain(times.iter().copied()).collect();
    let about_mean: Vec<f64> = [0.0].into_iter().chain(errors.iter().map(|error| error - mean)).collect();
    let slow = low_pass.ideal_series(&with_rest, &about_mean)?;
    Ok(slow[judged.start + 1..=judged.end].iter().map(|error| mean + error).collect())
}

/// The low-pass that makes a goal with a bandwidth \[Hz\] true: a Butterworth of order 8.
///
/// # Errors
/// [`Error::Value`] for a bandwidth that is not above zero.
pub(super) fn filter(bandwidth: f64) -> Result<Readout, Error> {
    Readout::new(ReadoutParameters { bandwidth: Some(bandwidth), order: MAX_ORDER, ..Default::default() })
}

/// How much later a slow force comes behind that filter \[s\]; none where no bandwidth is wanted.
pub(super) fn lag(bandwidth: Option<f64>) -> f64 {
    bandwidth.and_then(|bandwidth| filter(bandwidth).ok()).map_or(0.0, |filter| filter.lag(0.0))
}

/// How long it remembers \[s\].
pub(super) fn memory(bandwidth: f64) -> f64 {
    low_pass(MAX_ORDER, bandwidth)
}

/// How long a Butterworth low-pass remembers \[s\]: its slowest pole decays with ω_c sin(π/2n).
pub(super) fn low_pass(order: usize, bandwidth: f64) -> f64 {
    let slowest = std::f64::consts::TAU * bandwidth * (0.5 * std::f64::consts::PI / order.max(1) as f64).sin();
    FORGOTTEN / slowest
}

/// The samples inside of a window \[s\], both ends included.
pub(super) fn judged(times: &[f64], (from, to): (f64, f64)) -> Range<usize> {
    // A bound that rounds just past a sample still means that sample.
    let slack = if times.len() > 1 { 1e-6 * (times[1] - times[0]) } else { 0.0 };
    let start = times.partition_point(|&time| time < from - slack);
    let end = times.partition_point(|&time| time <= to + slack);
    start.min(times.len().saturating_sub(1))..end.max(start + 1).min(times.len())
}
