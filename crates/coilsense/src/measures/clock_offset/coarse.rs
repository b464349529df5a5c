//! The whole number of samples by which one record lags behind another.
//!
//! Next door: the rest of a sample (the parent).

use super::warp::Sinc;
use super::{FEWEST, straightened, transform};
use crate::error::{Error, check};
use num_complex::Complex64;
use realfft::RealFftPlanner;

/// Sample i of the first record fits sample i + `lag` of the second.
pub(super) struct Coarse {
    pub lag: i64,
    pub correlation: f64,
}

impl Coarse {
    /// The first record's samples that the second has, too.
    pub fn overlap(&self, first: usize, second: usize) -> (usize, usize) {
        let from = (-self.lag).max(0);
        let to = (first as i64).min(second as i64 - self.lag);
        (from as usize, to.max(from) as usize)
    }
}

/// A second offset fits as well as the first where its logarithmic likelihood reaches this share.
const AMBIGUOUS: f64 = 0.9;
/// The least share of a signal's power that counts as unexplained: rounding, and what lies between samples.
const LEFT: f64 = 1e-6;
/// Least correlation of signals that resemble each other, in standard deviations of that of noise.
const LEAST: f64 = 6.0;

/// Drifts that are tried where none does not explain all: at most 12.5 ppm away from one of them, ten minutes slip by a tenth of a period of 27 Hz.
const DRIFTS: i32 = 6;
const STEP: f64 = 25e-6;
/// From this correlation on no drift is tried.
const EXPLAINED: f64 = 0.9;

/// The lag of the largest correlation, in the first record's middle where the second's clock drifts: a fast motion does not resemble
/// itself over a long record then.
pub(super) fn lag(first: &[f64], second: &[f64]) -> Result<Coarse, Error> {
    let still = Fit::of(first, second)?;
    let shortest = first.len().min(second.len()) as f64;
    if still.correlation.abs() > EXPLAINED || shortest * STEP < 0.5 {
        return still.judged();
    }
    let sinc = Sinc::new();
    let drifts = (-DRIFTS..=DRIFTS).filter(|step| *step != 0).map(|step| STEP * f64::from(step));
    let mut best = (still, 0.0);
    for drift in drifts {
        let last = second.len() as f64 - 1.0;
        let places = (0..second.len()).map(|index| (index as f64 * (1.0 + drift)).min(last));
        let stretched: Vec<f64> = places.map(|place| sinc.at(second, place)).collect();
        let fit = Fit::of(first, &stretched)?;
        if fit.worth > best.0.worth {
            best = (fit, drift);
        }
    }
    let found = best.0.judged()?;
    let (from, to) = found.overlap(first.len(), second.len());
    let middle = 0.5 * (from + to) as f64 + found.lag as f64;
    Ok(Coarse { lag: (found.lag as f64 + best.1 * middle).round() as i64, ..found })
}

/// The best lag, and how well others do.
struct Fit {
    lag: i64,
    correlation: f64,
    /// Logarithmic likelihood, −K ln(1 − ρ²).
    worth: f64,
    /// Of the best other lag, as a share.
    rival: f64,
    /// Samples in common.
    shared: usize,
}

impl Fit {
    fn of(first: &[f64], second: &[f64]) -> Result<Self, Error> {
        let (a, b) = (straightened(first), straightened(second));
        let padded = (a.len() + b.len()).next_power_of_two();
        let products = products(&a, &b, padded)?;
        let (energy_a, energy_b) = (energies(&a), energies(&b));
        let fewest = FEWEST.max(a.len().min(b.len()) / 5);
        let common = |lag: i64| {
            let (from, to) = Coarse { lag, correlation: 0.0 }.overlap(a.len(), b.len());
            (from, to, (from as i64 + lag) as usize)
        };
        let own = |lag: i64| {
            let (from, to, shifted) = common(lag);
            let energy = (energy_a[to] - energy_a[from]) * (energy_b[shifted + to - from] - energy_b[shifted]);
            let product = products[lag.rem_euclid(padded as i64) as usize];
            (to - from >= fewest && energy > 0.0).then(|| product / energy.sqrt())
        };
        let lags = -(a.len() as i64 - 1)..b.len() as i64;
        let all: Vec<(i64, f64)> = lags.filter_map(|lag| Some((lag, own(lag)?))).collect();
        // Between samples a peak is higher than at the next one: without that, a ring of few samples a period slips by one.
        let height = |index: usize| match (
            index.checked_sub(1).and_then(|before| all.get(before)),
            all[index],
            all.get(index + 1),
        ) {
            (Some(&(_, before)), (_, here), Some(&(_, after))) => summit(before, here, after),
            (_, (_, here), _) => here,
        };
        // Where few samples overlap, one hit fits any other: what a fit is worth grows with what it explains, in likelihood.
        let shared = |index: usize| {
            let (from, to, _) = common(all[index].0);
            to - from
        };
        let worth = |index: usize| -(shared(index) as f64) * (1.0 - height(index).powi(2)).max(LEFT).ln();
        let worths: Vec<f64> = (0..all.len()).map(worth).collect();
        let Some(best) = (0..all.len()).max_by(|&i, &j| worths[i].total_cmp(&worths[j])) else {
            return Ok(Self { lag: 0, correlation: 0.0, worth: 0.0, rival: 0.0, shared: 0 });
        };
        let peak = height(best);
        // Its own lobe ends where the correlation has fallen to half.
        let above = |&(_, correlation): &(i64, f64)| correlation / peak > 0.5;
        let left = all[..best].iter().rev().take_while(|entry| above(entry)).count();
        let right = all[best..].iter().take_while(|entry| above(entry)).count();
        let others = (0..best - left).chain(best + right..all.len());
        let rival = others.map(|index| worths[index]).fold(0.0, f64::max) / worths[best];
        Ok(Self { lag: all[best].0, correlation: all[best].1, worth: worths[best], rival, shared: shared(best) })
    }

    /// Refused where the records do not resemble each other, or do so at several lags.
    fn judged(self) -> Result<Coarse, Error> {
        let (found, shared) = (self.correlation, self.shared as f64);
        let allowed =
            "larger for signals that resemble each other; name two channels of the same motion, or the offset";
        let alike = found.abs() > LEAST / shared.sqrt() || found.abs() > 0.9;
        check(alike, "correlation", found, "", allowed)?;
        let allowed = format!("below {AMBIGUOUS} of the best fit's: the motion repeats itself, so give the offset");
        check(self.rival < AMBIGUOUS, "likelihood of another offset", self.rival, "", allowed)?;
        Ok(Coarse { lag: self.lag, correlation: found })
    }
}

/// Height of the parabola through three equidistant values, where the middle one is the farthest from zero; else that value.
fn summit(before: f64, here: f64, after: f64) -> f64 {
    let bend = before - 2.0 * here + after;
    let is_peak = here.abs() >= before.abs() && here.abs() >= after.abs() && bend != 0.0;
    if is_peak { here - (after - before).powi(2) / (8.0 * bend) } else { here }
}

/// Σ a_i b_{i+ℓ} at place ℓ modulo `padded`.
pub(super) fn products(a: &[f64], b: &[f64], padded: usize) -> Result<Vec<f64>, Error> {
    let lines = |values: &[f64]| {
        let mut values = values.to_vec();
        values.resize(padded, 0.0);
        transform(&mut values)
    };
    let mut crossed: Vec<Complex64> =
        lines(a)?.iter().zip(lines(b)?).map(|(a, b)| a.conj() * b / padded as f64).collect();
    for end in [0, crossed.len() - 1] {
        crossed[end].im = 0.0;
    }
    let mut products = vec![0.0; padded];
    let done = RealFftPlanner::new().plan_fft_inverse(padded).process(&mut crossed, &mut products);
    check(done.is_ok(), "samples", padded as f64, "", "a length that can be transformed")?;
    Ok(products)
}

/// Sums of squares up to each sample, one more than samples.
fn energies(values: &[f64]) -> Vec<f64> {
    let mut sum = 0.0;
    let squares = values.iter().map(|value| {
        sum += value * value;
        sum
    });
    std::iter::once(0.0).chain(squares).collect()
}
