//! When a record was sampled: its rate and length, and whether they are fit for a spectrum.
//!
//! Next door: what was recorded (`ringing`).

use crate::error::{Error, check, entry, number_of};
use crate::signals::Signals;

/// Least samples of a record that anything can be said about.
const LEAST_SAMPLES: usize = 64;

/// A uniform clock.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sampling {
    /// f_s \[Hz\].
    pub rate: f64,
    /// How many samples.
    pub samples: usize,
    /// Time of the first sample \[s\].
    pub start: f64,
}

impl Sampling {
    /// The clock of a record: its mean interval, where every stamp lies within half an interval of its place (stamps are often rounded).
    pub(super) fn of(signals: &Signals) -> Result<Self, Error> {
        let times = signals.time();
        if times.len() < LEAST_SAMPLES {
            return Err(number_of("samples of the record", times.len(), format!("at least {LEAST_SAMPLES}")));
        }
        let last = times.len() - 1;
        let interval = (times[last] - times[0]) / last as f64;
        let off = |index: usize| (times[index] - times[0] - index as f64 * interval).abs() > 0.5 * interval;
        if let Some(index) = (0..times.len()).find(|&index| off(index)) {
            let place = times[0] + index as f64 * interval;
            let allowed = format!("uniform, {place} s here: a spectrum needs even steps");
            check(false, entry("time", index), times[index], "s", allowed)?;
        }
        Ok(Self { rate: 1.0 / interval, samples: times.len(), start: times[0] })
    }

    /// That of every `step`th sample.
    pub(super) fn every(&self, step: usize) -> Self {
        Self { rate: self.rate / step as f64, samples: self.samples.div_ceil(step), start: self.start }
    }

    /// How long the record lasts \[s\].
    pub fn duration(&self) -> f64 {
        self.samples as f64 / self.rate
    }

    /// Time of a sample \[s\].
    pub(super) fn time(&self, sample: usize) -> f64 {
        self.start + sample as f64 / self.rate
    }
}
