//! What of a record may ring: end forces less the force of a spring without mass.
//!
//! Next door: the stiffness that it takes (`quasi_static`), the moments at which ringing begins (`hits`).

use super::channel_check::Conditions;
use super::quasi_static::{Stiffness, length};
use super::sampling::Sampling;
use super::whitening::{ORDER, Surprise};
use crate::error::Error;
use crate::signals::{Channel, Signals};

/// Length of the running means that take slow motion out \[s\].
const SLOW: f64 = 0.4;
/// How far back the slow prediction reaches \[s\], and the fewest samples it is made of.
const REACH: f64 = 0.15;
const LEAST_SAMPLES: usize = 8 * ORDER;
/// Samples per period of the frequency at which a low-pass begins.
const PER_CORNER: f64 = 3.0;

/// How near that is, at least \[s\]: as far as the running means reach.
pub(super) const NEARBY: f64 = 0.4;

/// What a series is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Part {
    /// ½(F_o − F_i): the modes in which the ends pull in turn, odd ones of a spring between held ends.
    Difference,
    /// ½(F_o + F_i): the modes in which they pull together, even ones of a spring between held ends.
    Sum,
    /// The one force that was recorded.
    Single(Channel),
}

/// One series that may ring.
#[derive(Debug, Clone)]
pub(super) struct Series {
    pub(super) part: Part,
    /// Less the slow force by length, where that is known; shape `samples`.
    pub(super) force: Vec<f64>,
    /// The same less its own running mean, for finding things; shape `samples`.
    pub(super) flat: Vec<f64>,
    /// Standard deviation of its noise, in N: of white noise as dense as where the channel lets ringing through.
    pub(super) noise: f64,
}

/// What a record's series are, and what of them is not predicted.
pub(super) struct Rings {
    pub(super) series: Vec<Series>,
    /// Of samples as near as the channel has news in them.
    pub(super) quick: Surprise,
    /// The same of samples so far apart that a prediction reaches back over several periods of the lowest modes.
    pub(super) slow: Surprise,
}

/// The series of a record: difference and sum of both ends' forces, or the single force.
///
/// Held ends make a mode pull at both ends alike but for its sign, so that difference and sum each hold every other mode.
///
/// # Errors
/// [`Error::MissingSignal`] where no force was recorded.
pub(super) fn rings(
    signals: &Signals,
    sampling: &Sampling,
    stiffness: Option<&Stiffness>,
    conditions: &Conditions,
) -> Result<Rings, Error> {
    let slow = slow_force(signals, sampling, stiffness);
    let ends = [Channel::InputForce, Channel::OutputForce].map(|channel| signals.channel(channel).ok());
    let less_slow = |values: Vec<f64>| match &slow {
        Some(slow) => values.iter().zip(slow).map(|(f, s)| f - s).collect(),
        None => values,
    };
    let parts: Vec<(Part, Vec<f64>)> = match ends {
        [Some(input), Some(output)] => {
            let half = |sign: f64| output.iter().zip(input).map(|(o, i)| 0.5 * (o + sign * i)).collect::<Vec<f64>>();
            vec![(Part::Difference, half(-1.0)), (Part::Sum, less_slow(half(1.0)))]
        }
        [Some(one), None] => vec![(Part::Single(Channel::InputForce), less_slow(one.to_vec()))],
        [None, Some(one)] => vec![(Part::Single(Channel::OutputForce), less_slow(one.to_vec()))],
        [None, None] => match signals.channel(Channel::InductanceForce) {
            Ok(one) => vec![(Part::Single(Channel::InductanceForce), less_slow(one.to_vec()))],
            Err(_) => return Err(Error::MissingSignal("F_i, F_o or F_L")),
        },
    };
    let window = ((SLOW * sampling.rate) as usize).clamp(3, sampling.samples / 4);
    let most = (sampling.samples / LEAST_SAMPLES).max(1);
    let quick = conditions.low_pass.map_or(1, |corner| (sampling.rate / (PER_CORNER * corner)) as usize).clamp(1, most);
    let steps = [quick, ((REACH * sampling.rate / ORDER as f64) as usize).clamp(quick, most)];
    let block = (NEARBY * sampling.rate) as usize;
    let [mut quick, mut slow] = steps.map(|step| Surprise::none(sampling.samples, step));
    let mut series = Vec::with_capacity(parts.len());
    for (part, force) in parts {
        let mut flat = force.clone();
        running_mean(&mut flat, window);
        running_mean(&mut flat, window);
        flat.iter_mut().zip(&force).for_each(|(flat, force)| *flat = force - *flat);
        let noise = quick.add(&flat, block, conditions.rounding) * (quick.step as f64).sqrt();
        slow.add(&flat, block, conditions.rounding);
        series.push(Series { part, force, flat, noise });
    }
    Ok(Rings { series, quick, slow })
}

/// k times the smoothed length, where both are known and the smoothing leaves less noise than the force sensors have.
fn slow_force(signals: &Signals, sampling: &Sampling, stiffness: Option<&Stiffness>) -> Option<Vec<f64>> {
    let stiffness = stiffness?;
    let (length, _) = length(signals)?;
    let window = ((0.05 * sampling.rate) as usize).clamp(1, sampling.samples / 4);
    let mut smooth = length;
    running_mean(&mut smooth, window);
    running_mean(&mut smooth, window);
    Some(smooth.iter().map(|l| stiffness.value() * (l - stiffness.length_at_zero.value)).collect())
}

/// Puts means over `window` samples about each sample in its place, fewer at the ends.
fn running_mean(values: &mut [f64], window: usize) {
    let half = window / 2;
    let count = values.len();
    // Sums count from the first value, so that a large offset does not eat their digits; those of the samples that were replaced are kept.
    let first = values.first().copied().unwrap_or(0.0);
    let mut sums = vec![0.0; 2 * half + 2];
    let (turn, mut ahead, mut sum) = (sums.len(), 0, 0.0);
    for index in 0..count {
        // As many on either side: a slope then leaves no trace.
        let reach = half.min(index).min(count - 1 - index);
        while ahead <= index + reach {
            sum += values[ahead] - first;
            ahead += 1;
            sums[ahead % turn] = sum;
        }
        let mean = (sums[(index + reach + 1) % turn] - sums[(index - reach) % turn]) / (2 * reach + 1) as f64;
        values[index] = first + mean;
    }
}

impl Part {
    /// Whether it tells how both ends pull.
    pub fn of_both_ends(self) -> bool {
        matches!(self, Self::Difference | Self::Sum)
    }
}
