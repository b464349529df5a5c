//! What the oscillation of a sensor is over the springs that tolerances allow.
//!
//! Next door: the springs (`specimen`), the error on each (`response`), the budget that it goes into (`budget`).

use super::moments::Moments;
use super::response::Responses;
use super::specimen::{Specimen, Specimens};

/// The error over time of a sensor in a case, over all specimens.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Spread {
    /// On the nominal spring.
    pub nominal: Moments,
    /// Mean over specimens and time \[N\].
    pub mean: f64,
    /// Standard deviation about it \[N\], but for what the next one adds.
    pub deviation: f64,
    /// What it adds that the first frequency of the coil is not that of the chain \[N\].
    pub chain: f64,
    /// On each specimen.
    pub each: Vec<Moments>,
    /// Rms over time of the specimen on which it is largest \[N\].
    pub loudest: f64,
}

/// A single spring must not decide more than this share of a mean square.
const OF_ONE: f64 = 0.02;
/// Most springs that are drawn for it.
const MOST: f64 = 65_536.0;

/// Sums over springs.
#[derive(Debug, Clone, Copy, Default)]
struct Sums {
    count: f64,
    means: f64,
    squares: f64,
    /// Largest mean square.
    loudest: f64,
}

impl Sums {
    fn of(each: impl Iterator<Item = Moments>) -> Self {
        each.fold(Self::default(), |sums, moments| Self {
            count: sums.count + 1.0,
            means: sums.means + moments.mean,
            squares: sums.squares + moments.square(),
            loudest: sums.loudest.max(moments.square()),
        })
    }

    fn and(self, other: Self) -> Self {
        Self {
            count: self.count + other.count,
            means: self.means + other.means,
            squares: self.squares + other.squares,
            loudest: self.loudest.max(other.loudest),
        }
    }

    fn mean(&self) -> f64 {
        self.means / self.count.max(1.0)
    }

    fn mean_square(&self) -> f64 {
        self.squares / self.count.max(1.0)
    }

    fn variance(&self) -> f64 {
        (self.mean_square() - self.mean() * self.mean()).max(0.0)
    }
}

/// How far two sums over the same springs are apart by their order of adding alone, over what is summed \[1\].
const ROUND_OFF: f64 = 1e-12;

/// A difference of two means of squares, where it is more than their last digits: else a sensor that the coil's frequency does not move would
/// have a line of its budget about it on one machine, and none on another.
fn beyond_round_off(difference: f64, mean_square: f64) -> f64 {
    // Where nothing moves at all, no product of two tells.
    if difference > (ROUND_OFF * mean_square).max(f64::MIN_POSITIVE) { difference } else { 0.0 }
}

impl Spread {
    /// Of the nominal spring alone.
    pub fn nominal(nominal: Moments) -> Self {
        Self {
            nominal,
            mean: nominal.mean,
            deviation: nominal.variance.sqrt(),
            chain: 0.0,
            each: vec![nominal],
            loudest: nominal.square().sqrt(),
        }
    }

    /// Over `specimens`, with as many more as it takes; `as_chains` are the same springs as if each were the chain that the model is, for
    /// who wants to know what that is worth.
    pub fn over(
        responses: &Responses,
        sensor: usize,
        nominal: Moments,
        specimens: &Specimens,
        as_chains: Option<&Specimens>,
    ) -> Self {
        let on = |specimen: &Specimen| responses.on(sensor, specimen, nominal);
        let each: Vec<Moments> = specimens.each.iter().map(on).collect();
        let few = Sums::of(each.iter().copied());
        // Where a few springs at a resonance decide, there must be enough of them.
        let wanted = responses.peak(sensor, nominal) / (OF_ONE * (few.mean_square() + responses.beside(sensor)));
        let count = (wanted.min(MOST) as usize).max(each.len());
        let sums = few.and(Sums::of(specimens.more(count).map(|specimen| on(&specimen))));
        let (mean, all) = (sums.mean(), sums.variance());
        let without = as_chains.map_or(all, |springs| {
            Sums::of(springs.each.iter().copied().chain(springs.more(count)).map(|specimen| on(&specimen))).variance()
        });
        // Where the nominal spring is at a peak the coil's own frequency takes from it: that is no line of its own.
        let chain = beyond_round_off(all - without, sums.mean_square());
        let loudest = sums.loudest.sqrt();
        Self { nominal, mean, deviation: (all - chain).sqrt(), chain: chain.sqrt(), each, loudest }
    }

    /// Root of the mean square over specimens and time \[N\].
    pub fn rms(&self) -> f64 {
        self.mean.hypot(self.deviation).hypot(self.chain)
    }

    /// Errors as likely as they are over specimens and time, `count` of them, from those of the nominal spring over time \[N\].
    pub fn values(&self, errors: &[f64], count: usize) -> Vec<f64> {
        let spread = self.nominal.variance.sqrt();
        let total = self.deviation.hypot(self.chain);
        if errors.is_empty() || spread == 0.0 {
            return vec![self.mean - total, self.mean + total];
        }
        // Strides without a common pattern: specimens and moments meet evenly.
        let golden = 0.618_033_988_749_894_9;
        let value = |index: usize| {
            let moment = ((index as f64 * golden).fract() * errors.len() as f64) as usize;
            let moments = &self.each[index % self.each.len()];
            moments.mean + moments.variance.sqrt() * (errors[moment] - self.nominal.mean) / spread
        };
        let values: Vec<f64> = (0..count).map(value).collect();
        // What the choice of moments leaves of mean and spread is taken off.
        let drawn = Moments::of(&values);
        let factor = if drawn.variance > 0.0 { total / drawn.variance.sqrt() } else { 0.0 };
        values.iter().map(|value| self.mean + factor * (value - drawn.mean)).collect()
    }
}
