//! A series read between its samples: straight lines, constant before the first and after the last.
//!
//! Next door: who reads so (`delay`, `sample_hold`); the integral of the same lines (`boxcar`).

/// A walk along a series, forward only.
pub(super) struct Straight<'a> {
    times: &'a [f64],
    values: &'a [f64],
    /// The last sample that is not after the time asked for.
    index: usize,
}

impl<'a> Straight<'a> {
    /// At the start of a series, both of shape `samples`.
    pub(super) fn new(times: &'a [f64], values: &'a [f64]) -> Self {
        Self { times, values, index: 0 }
    }

    /// Value at a time \[s\] that is not before the one asked for last; the samples' own values at the samples. Zero for no samples.
    pub(super) fn at(&mut self, time: f64) -> f64 {
        while self.index + 1 < self.times.len() && self.times[self.index + 1] <= time {
            self.index += 1;
        }
        let here = self.values.get(self.index).copied().unwrap_or(0.0);
        let Some((&next, &after)) = self.values.get(self.index + 1).zip(self.times.get(self.index + 1)) else {
            return here;
        };
        let before = self.times[self.index];
        if time <= before { here } else { here + (next - here) * ((time - before) / (after - before)) }
    }
}
