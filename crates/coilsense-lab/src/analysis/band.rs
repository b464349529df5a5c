//! Which part of an error counts: all of it, or what a low-pass at the wanted bandwidth leaves.
//!
//! Next door: whose errors (`verdict`), the low-pass itself (`coilsense::sensors`).

use std::ops::Range;

use coilsense::Error;
use coilsense::sensors::{MAX_ORDER, Readout, ReadoutParameters};

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
    super::trial_run::low_pass(MAX_ORDER, bandwidth)
}
