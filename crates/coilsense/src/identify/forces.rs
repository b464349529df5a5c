//! What rings in a record's forces, computed wherever it is asked for: a record may be long, and each copy of a channel takes its memory again.
//!
//! Next door: which series there are (`ringing`), what is taken out of them (`weak_lines`).

use std::ops::Range;

use super::running_mean::smoothed;

/// Samples that are computed together.
const CHUNK: usize = 1 << 16;

/// A force less the slow one, read from the record's own channels.
#[derive(Debug, Clone, Copy)]
pub(super) struct Force<'a> {
    pub(super) ends: Ends<'a>,
    pub(super) slow: Option<SlowForce<'a>>,
}

/// Which channels a force is made of.
#[derive(Debug, Clone, Copy)]
pub(super) enum Ends<'a> {
    /// The one that was recorded.
    One(&'a [f64]),
    /// ½(F_o + sign F_i).
    Half { output: &'a [f64], input: &'a [f64], sign: f64 },
}

/// k (l − l0), l smoothed by two running means.
#[derive(Debug, Clone, Copy)]
pub(super) struct SlowForce<'a> {
    pub(super) length: Length<'a>,
    pub(super) window: usize,
    /// k \[N/m\] and l0 \[m\].
    pub(super) stiffness: f64,
    pub(super) zero: f64,
}

/// Length over time as far as it was recorded: u2 − u1, u2 or −u1.
#[derive(Debug, Clone, Copy)]
pub(super) struct Length<'a> {
    pub(super) first: Option<&'a [f64]>,
    pub(super) second: Option<&'a [f64]>,
}

impl Length<'_> {
    fn at(&self, index: usize) -> f64 {
        self.second.map_or(0.0, |second| second[index]) - self.first.map_or(0.0, |first| first[index])
    }
}

impl Force<'_> {
    /// How many samples.
    pub(super) fn samples(&self) -> usize {
        match self.ends {
            Ends::One(values) | Ends::Half { output: values, .. } => values.len(),
        }
    }

    /// Its values at `range` \[N\].
    pub(super) fn values(&self, range: Range<usize>) -> Vec<f64> {
        let mut values: Vec<f64> = match self.ends {
            Ends::One(values) => values[range.clone()].to_vec(),
            Ends::Half { output, input, sign } => {
                let pairs = output[range.clone()].iter().zip(&input[range.clone()]);
                pairs.map(|(output, input)| 0.5 * (output + sign * input)).collect()
            }
        };
        if let Some(SlowForce { length, window, stiffness, zero }) = self.slow {
            let slow = smoothed(|index| length.at(index), self.samples(), window, range);
            values.iter_mut().zip(slow).for_each(|(value, length)| *value -= stiffness * (length - zero));
        }
        values
    }

    /// Its values at `range` less their running mean over `window` samples, taken twice \[N\].
    pub(super) fn flat(&self, window: usize, range: Range<usize>) -> Vec<f64> {
        let (samples, reach) = (self.samples(), 2 * (window / 2));
        let chunk = CHUNK.max(4 * reach);
        let mut flat = Vec::with_capacity(range.len());
        for start in range.clone().step_by(chunk) {
            let part = start..(start + chunk).min(range.end);
            let about = part.start.saturating_sub(reach)..(part.end + reach).min(samples);
            let force = self.values(about.clone());
            let mean = smoothed(|index| force[index - about.start], samples, window, part.clone());
            flat.extend(part.zip(mean).map(|(index, mean)| force[index - about.start] - mean));
        }
        flat
    }
}
