//! What of a record may ring: end forces less the force of a spring without mass.
//!
//! Next door: the stiffness that it takes (`quasi_static`), how a force is computed (`forces`), the moments at which ringing begins (`hits`).

use std::ops::Range;
use std::sync::Arc;

use super::channel_check::Conditions;
use super::forces::{Ends, Force, Length, SlowForce};
use super::quasi_static::Stiffness;
use super::sampling::Sampling;
use super::taken_out::TakenOut;
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
pub(super) struct Series<'a> {
    pub(super) part: Part,
    /// Less the slow force by length, where that is known.
    force: Force<'a>,
    /// Samples of its running mean.
    window: usize,
    /// What was taken out of it since.
    taken_out: Vec<Arc<TakenOut>>,
    /// Standard deviation of its noise, in N: of white noise as dense as where the channel lets ringing through.
    pub(super) noise: f64,
}

impl Series<'_> {
    /// A stretch less the running mean of all, for finding things \[N\].
    pub(super) fn flat(&self, range: Range<usize>) -> Vec<f64> {
        let mut values = self.force.flat(self.window, range.clone());
        self.take_out(range.start, &mut values);
        values
    }

    /// A stretch of the force \[N\].
    pub(super) fn force(&self, range: Range<usize>) -> Vec<f64> {
        let mut values = self.force.values(range.clone());
        self.take_out(range.start, &mut values);
        values
    }

    fn take_out(&self, start: usize, values: &mut [f64]) {
        self.taken_out.iter().for_each(|taken| taken.subtract(start, values));
    }

    /// The same less what is taken out of it.
    pub(super) fn without(&self, taken: TakenOut) -> Self {
        let mut rest = self.clone();
        rest.taken_out.push(Arc::new(taken));
        rest
    }
}

/// What a record's series are, and what of them is not predicted.
pub(super) struct Rings<'a> {
    pub(super) series: Vec<Series<'a>>,
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
pub(super) fn rings<'a>(
    signals: &'a Signals,
    sampling: &Sampling,
    stiffness: Option<&Stiffness>,
    conditions: &Conditions,
) -> Result<Rings<'a>, Error> {
    let slow = slow_force(signals, sampling, stiffness);
    let end = |channel: Channel| signals.channel(channel).ok();
    let single = |channel: Channel, values: &'a [f64]| (Part::Single(channel), Force { ends: Ends::One(values), slow });
    let parts: Vec<(Part, Force<'a>)> = match (end(Channel::InputForce), end(Channel::OutputForce)) {
        (Some(input), Some(output)) => {
            let half = |sign: f64| Ends::Half { output, input, sign };
            vec![
                (Part::Difference, Force { ends: half(-1.0), slow: None }),
                (Part::Sum, Force { ends: half(1.0), slow }),
            ]
        }
        (Some(one), None) => vec![single(Channel::InputForce, one)],
        (None, Some(one)) => vec![single(Channel::OutputForce, one)],
        (None, None) => match signals.channel(Channel::InductanceForce) {
            Ok(one) => vec![single(Channel::InductanceForce, one)],
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
        // The longest that is held at once.
        let flat = force.flat(window, 0..sampling.samples);
        let noise = quick.add(&flat, block, conditions.rounding) * (quick.step as f64).sqrt();
        slow.add(&flat, block, conditions.rounding);
        series.push(Series { part, force, window, taken_out: Vec::new(), noise });
    }
    Ok(Rings { series, quick, slow })
}

/// k times the smoothed length, where both are known and the smoothing leaves less noise than the force sensors have.
fn slow_force<'a>(signals: &'a Signals, sampling: &Sampling, stiffness: Option<&Stiffness>) -> Option<SlowForce<'a>> {
    let stiffness = stiffness?;
    let length = Length { first: signals.channel(Channel::U1).ok(), second: signals.channel(Channel::U2).ok() };
    let window = ((0.05 * sampling.rate) as usize).clamp(1, sampling.samples / 4);
    let known = length.first.is_some() || length.second.is_some();
    known.then(|| SlowForce { length, window, stiffness: stiffness.value(), zero: stiffness.length_at_zero.value })
}

impl Part {
    /// Whether it tells how both ends pull.
    pub fn of_both_ends(self) -> bool {
        matches!(self, Self::Difference | Self::Sum)
    }
}
