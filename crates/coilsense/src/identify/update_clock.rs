//! When a held channel has new values: a device slower than the log repeats its last one.
//!
//! Next door: what else a channel can show (`channel_check`).

/// Fewest changes that tell a clock.
const LEAST: usize = 32;
/// Least samples per new value of a channel that is held.
const HELD: f64 = 1.1;
/// Least new values: fewer make no record.
const LEAST_TICKS: f64 = 128.0;
/// How far changes may lie off the clock \[samples\], and which share of them must not.
const OFF: f64 = 0.75;
const SHARE: f64 = 0.98;
/// Which share of the changes, at least, must be larger than one step of the last digit: a quiet signal's changes are all one step.
const LARGER: f64 = 0.2;

/// Tick k is at sample `phase` + `ratio` · k.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct UpdateClock {
    /// Samples of the log per new value, 1 or more, not always a whole number.
    pub(super) ratio: f64,
    /// Sample of a tick, before it is rounded up.
    phase: f64,
}

impl UpdateClock {
    /// The clock of the samples at which a channel changes; none where it is not held.
    ///
    /// Changes of a held channel lie at ⌈φ + r k⌉; not every tick has one, where the last digit is coarse. A quantised signal that is
    /// quiet repeats values too, but at no clock's moments.
    pub(super) fn of(values: &[f64], last_digit: Option<f64>) -> Option<Self> {
        let changed = |index: &usize| values[*index] != values[index - 1];
        let count = (1..values.len()).filter(changed).count();
        if count < LEAST || count as f64 * HELD > values.len() as f64 {
            return None;
        }
        let changes: Vec<usize> = (1..values.len()).filter(changed).collect();
        let digit = last_digit.unwrap_or(0.0);
        let large = |index: &&usize| (values[**index] - values[*index - 1]).abs() > 1.5 * digit;
        if (changes.iter().filter(large).count() as f64) < LARGER * count as f64 {
            return None;
        }
        let clock = Self::fitted(&changes, Self::rough(&changes))?;
        let fits = clock.ratio >= HELD && values.len() as f64 >= LEAST_TICKS * clock.ratio;
        fits.then_some(clock)
    }

    /// The mean of the shortest gaps, which are one tick long.
    fn rough(changes: &[usize]) -> f64 {
        let mut gaps: Vec<usize> = changes.windows(2).map(|pair| pair[1] - pair[0]).collect();
        let place = gaps.len() / 50;
        let (_, least, _) = gaps.select_nth_unstable(place);
        let least = *least;
        let single = || gaps.iter().filter(|gap| **gap == least || **gap == least + 1);
        single().sum::<usize>() as f64 / single().count().max(1) as f64
    }

    /// A straight line through the changes over their ticks, counted by following the clock; none where they lie off it.
    fn fitted(changes: &[usize], rough: f64) -> Option<Self> {
        let mut ratio = rough;
        let mut phase = changes[0] as f64;
        let mut share = 0.0;
        for _ in 0..3 {
            let (mut tick, mut last) = (0.0, changes[0] as f64);
            let mut ticks = Vec::with_capacity(changes.len());
            for &change in changes {
                tick += ((change as f64 - last) / ratio).round();
                last = change as f64;
                ticks.push(tick);
            }
            let count = changes.len() as f64;
            let mean = ticks.iter().sum::<f64>() / count;
            let middle = changes.iter().map(|change| *change as f64).sum::<f64>() / count;
            let (mut product, mut square) = (0.0, 0.0);
            for (tick, change) in ticks.iter().zip(changes) {
                product += (tick - mean) * (*change as f64 - middle);
                square += (tick - mean).powi(2);
            }
            if square <= 0.0 {
                return None;
            }
            ratio = product / square;
            phase = middle - ratio * mean;
            let near = |(tick, change): &(&f64, &usize)| (**change as f64 - phase - ratio * **tick).abs() < OFF;
            share = ticks.iter().zip(changes).filter(near).count() as f64 / count;
        }
        // Rounded up, changes lie half a sample late on average, but for whole ratios.
        let whole = (ratio - ratio.round()).abs() * (changes.len() as f64) < 1.0;
        let phase = if whole { phase.round() } else { phase - 0.5 };
        (share >= SHARE).then_some(Self { ratio, phase })
    }

    /// A sample within each tick of a record, about the middle of where its value stands.
    pub(super) fn samples(self, samples: usize) -> impl Iterator<Item = usize> {
        let start = self.phase + 0.5 * (self.ratio - 1.0);
        let first = (-start / self.ratio).ceil() as i64;
        (first..)
            .map(move |tick| ((start + self.ratio * tick as f64) - 1e-6).ceil().max(0.0) as usize)
            .take_while(move |at| *at < samples)
    }
}
