//! A recorded series as an input: straight from sample to sample, constant before the first and after the last.
//!
//! Next door: the other inputs (`input`).

use super::event::Kick;
use crate::error::{Error, all_bounded, at_least_one, called, check, count, entry};

/// A recorded series, checked. Steps may be uneven.
#[derive(Debug, Clone, PartialEq)]
pub struct Sampled {
    times: Vec<f64>,
    values: Vec<f64>,
}

/// Samples nearer than this \[s\] are no motion but a jump.
const CLOSEST: f64 = 1e-12;

impl Sampled {
    /// A series of `values` (\[m\], or \[N\] at an end under force) at `times` \[s\], each of shape `samples`.
    ///
    /// # Errors
    /// [`Error::Count`] for no samples or series of different lengths; [`Error::Value`] for the first value that is not finite or
    /// time that is not after its predecessor.
    ///
    /// ```
    /// use coilsense::excitation::Sampled;
    /// let error = Sampled::new(vec![0.0, 0.1, 0.1], vec![0.0; 3]).unwrap_err();
    /// assert_eq!(error.to_string(), "sample time[2] must be above its predecessor of 0.1 s, got 0.1 s");
    /// ```
    pub fn new(times: Vec<f64>, values: Vec<f64>) -> Result<Self, Error> {
        at_least_one(called("times", "sample times"), times.len())?;
        count(called("values", "sample values"), values.len(), times.len())?;
        all_bounded(called("times", "sample time"), &times, "s")?;
        all_bounded(called("values", "sample value"), &values, "")?;
        if let Some(index) = (1..times.len()).find(|&index| times[index] <= times[index - 1]) {
            let allowed = format!("above its predecessor of {} s", times[index - 1]);
            check(false, entry(called("times", "sample time"), index), times[index], "s", allowed)?;
        }
        if let Some(index) = (1..times.len()).find(|&index| times[index] - times[index - 1] < CLOSEST) {
            let allowed = format!("at least {CLOSEST:e} s after its predecessor of {} s", times[index - 1]);
            check(false, entry(called("times", "sample time"), index), times[index], "s", allowed)?;
        }
        Ok(Self { times, values })
    }

    /// The times \[s\], shape `samples`.
    pub fn times(&self) -> &[f64] {
        &self.times
    }

    /// The values, shape `samples`.
    pub fn values(&self) -> &[f64] {
        &self.values
    }

    /// The same values in less time: played `speed` times as fast \[1\], from the same t = 0.
    ///
    /// # Errors
    ///
    /// [`Error::Value`] for a speed that is not above zero and finite, or so high that samples fall together.
    ///
    /// ```
    /// use coilsense::excitation::Sampled;
    /// let cam = Sampled::new(vec![0.0, 0.1, 0.2], vec![0.0, 0.01, 0.0])?;
    /// assert_eq!(cam.played(2.0)?.times(), [0.0, 0.05, 0.1]);
    /// # Ok::<(), coilsense::Error>(())
    /// ```
    pub fn played(&self, speed: f64) -> Result<Self, Error> {
        check(speed > 0.0 && speed.is_finite(), "speed", speed, "", "above zero and finite")?;
        Self::new(self.times.iter().map(|time| time / speed).collect(), self.values.clone())
    }

    /// The same with every value multiplied by a finite factor.
    pub(crate) fn scaled(&self, factor: f64) -> Self {
        Self { times: self.times.clone(), values: self.values.iter().map(|value| factor * value).collect() }
    }

    /// How many samples there are.
    pub(super) fn count(&self) -> usize {
        self.times.len()
    }

    /// The value at a time.
    pub(super) fn value(&self, time: f64) -> f64 {
        let next = self.times.partition_point(|&t| t <= time);
        match next {
            0 => self.values[0],
            next if next == self.times.len() => self.values[next - 1],
            next => self.values[next - 1] + self.slope_before(next) * (time - self.times[next - 1]),
        }
    }

    /// The values at times in order, in one walk.
    pub(super) fn values_at(&self, times: &[f64]) -> Vec<f64> {
        let mut next = 0;
        let each = times.iter().map(|&time| {
            while next < self.times.len() && self.times[next] <= time {
                next += 1;
            }
            match next {
                0 => self.values[0],
                next => self.values[next - 1] + self.slope_before(next) * (time - self.times[next - 1]),
            }
        });
        each.collect()
    }

    /// The rate at a time, from the right.
    pub(super) fn slope(&self, time: f64) -> f64 {
        self.slope_before(self.times.partition_point(|&t| t <= time))
    }

    /// The rate between sample `next − 1` and sample `next`; zero outside of the record.
    fn slope_before(&self, next: usize) -> f64 {
        if next == 0 || next == self.times.len() {
            return 0.0;
        }
        (self.values[next] - self.values[next - 1]) / (self.times[next] - self.times[next - 1])
    }

    /// The jumps of the rate at each sample.
    pub(super) fn kicks(&self) -> Vec<Kick> {
        let mut before = 0.0;
        let each = self.times.iter().enumerate();
        each.map(|(index, &time)| {
            let after = self.slope_before(index + 1);
            let velocity = after - before;
            before = after;
            Kick { time, displacement: 0.0, velocity }
        })
        .collect()
    }

    /// The largest value either way.
    pub(super) fn reach(&self) -> f64 {
        self.values.iter().fold(0.0, |reach, value| value.abs().max(reach))
    }

    /// Its least and its largest value.
    pub(super) fn bounds(&self) -> (f64, f64) {
        let wider = |(least, most): (f64, f64), value: &f64| (value.min(least), value.max(most));
        self.values.iter().fold((f64::INFINITY, f64::NEG_INFINITY), wider)
    }
}
