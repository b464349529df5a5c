//! What the oscillation of a sensor is over the springs that tolerances allow.
//!
//! Next door: the springs (`specimen`), the error on each (`response`), the budget that it goes into (`budget`).

use super::response::{Moments, Responses};
use super::specimen::Specimens;

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
}

impl Spread {
    /// Of the nominal spring alone.
    pub fn nominal(nominal: Moments) -> Self {
        Self { nominal, mean: nominal.mean, deviation: nominal.variance.sqrt(), chain: 0.0, each: vec![nominal] }
    }

    /// Over `specimens`; `as_chains` are the same springs as if each were the chain that the model is, for who wants to know what that is worth.
    pub fn over(
        responses: &Responses,
        sensor: usize,
        nominal: Moments,
        specimens: &Specimens,
        as_chains: Option<&Specimens>,
    ) -> Self {
        let on = |specimens: &Specimens| -> Vec<Moments> {
            specimens.each.iter().map(|specimen| responses.on(sensor, specimen, nominal)).collect()
        };
        let each = on(specimens);
        let mean = mean_of(&each, |moments| moments.mean);
        let all = (mean_of(&each, Moments::square) - mean * mean).max(0.0);
        let without = as_chains.map_or(all, |springs| {
            let chains = on(springs);
            mean_of(&chains, Moments::square) - mean_of(&chains, |moments| moments.mean).powi(2)
        });
        // Where the nominal spring is at a peak the coil's own frequency takes from it: that is no line of its own.
        let chain = (all - without.max(0.0)).max(0.0);
        Self { nominal, mean, deviation: (all - chain).sqrt(), chain: chain.sqrt(), each }
    }

    /// Root of the mean square over specimens and time \[N\].
    pub fn rms(&self) -> f64 {
        self.mean.hypot(self.deviation).hypot(self.chain)
    }

    /// Rms over time of the specimen on which it is largest \[N\].
    pub fn loudest(&self) -> f64 {
        self.each.iter().map(Moments::square).fold(0.0, f64::max).sqrt()
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

fn mean_of(each: &[Moments], value: impl Fn(&Moments) -> f64) -> f64 {
    each.iter().map(value).sum::<f64>() / each.len().max(1) as f64
}
