//! How much faster one clock runs than the other: the lag as a straight line over the record.
//!
//! Next door: a lag that stays (the parent), where it begins (`coarse`), values between samples (`warp`).

use super::coarse::products;
use super::warp::{REACH, Sinc};
use super::{Filtered, PARTS, band};
use crate::error::Error;
use crate::uncertainty::coverage_factor;

/// The fastest drift that is looked for: twice that of a poor crystal.
pub(super) const FASTEST: f64 = 200e-6;
/// What two crystals may differ by, 95 %: a drift that the record does not tell better is not fitted.
pub(super) const CRYSTALS: f64 = 100e-6;
/// Fewest samples of a drift.
const FEWEST: usize = 2048;
/// Blocks of the search.
const BLOCKS: usize = 32;
/// Samples by which the coarse lag may be off.
const SLACK: i64 = 4;
/// Another drift fits as well as the best where its logarithmic likelihood reaches this share.
const AMBIGUOUS: f64 = 0.9;

/// The lag of b behind a at index i: lag + slope (i − centre) \[samples\], each with half of its 95 % interval.
pub(super) struct Line {
    pub lag: f64,
    pub lag_half: f64,
    pub slope: f64,
    pub slope_half: f64,
    /// Where the two are independent.
    pub centre: f64,
}

/// A straight line under way.
#[derive(Clone, Copy)]
struct Guess {
    lag: f64,
    slope: f64,
}

impl Guess {
    fn place(self, index: usize, middle: f64) -> f64 {
        index as f64 + self.lag + self.slope * (index as f64 - middle)
    }
}

/// The lag over the record; none where it does not tell the drift to [`CRYSTALS`].
pub(super) fn line(a: &[f64], b: &[f64]) -> Result<Option<Line>, Error> {
    let (samples, middle) = (a.len(), 0.5 * (a.len() as f64 - 1.0));
    if samples < FEWEST {
        return Ok(None);
    }
    let Some(begin) = search(a, b)? else { return Ok(None) };
    let sinc = Sinc::new();
    let (mut guess, mut cut) = (begin, 0.0);
    let mut found = None;
    // The better the lag is known, the higher the frequencies at which both agree.
    for _ in 0..4 {
        let moved: Vec<f64> = (0..samples).map(|index| sinc.at(b, guess.place(index, middle))).collect();
        let next = band::coherent(a, &moved)?;
        if next <= 1.02 * cut {
            break;
        }
        cut = next;
        let Some(better) = Score::solved(&Filtered::of(a, cut)?, &Filtered::of(b, cut)?, guess, &sinc)? else {
            break;
        };
        let off = (better.0.lag - begin.lag).abs().max((better.0.slope - begin.slope).abs() * middle);
        if off > 0.25 / cut + 2.0 || better.0.slope.abs() > 2.0 * FASTEST {
            break;
        }
        guess = better.0;
        found = Some(better);
    }
    let Some((guess, score)) = found else { return Ok(None) };
    let line = score.line(guess, middle)?;
    Ok((line.slope_half <= CRYSTALS).then_some(line))
}

/// The straight line whose lags make the sum of the blocks' correlations largest; none where two of different slopes fit alike.
fn search(a: &[f64], b: &[f64]) -> Result<Option<Guess>, Error> {
    let (samples, middle) = (a.len(), 0.5 * a.len() as f64);
    let reach = (FASTEST * middle).ceil() as i64;
    let most = 2 * reach + SLACK;
    let length = samples / BLOCKS;
    let at = |index: i64| usize::try_from(index).ok().and_then(|index| b.get(index)).copied().unwrap_or(0.0);
    let mut blocks = Vec::new();
    for block in 0..BLOCKS {
        let from = block * length;
        let around: Vec<f64> = (from as i64 - most..(from + length) as i64 + most).map(at).collect();
        let padded = (2 * length + 2 * most as usize).next_power_of_two();
        let sums = products(&a[from..from + length], &around, padded)?;
        blocks.push((from as f64 + 0.5 * length as f64 - middle, sums));
    }
    let energy = |values: &[f64]| values.iter().map(|value| value * value).sum::<f64>();
    let scale = (energy(a) * energy(b)).sqrt();
    // At the coarse lag both have the sign that they have.
    let sign = a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>().signum();
    if scale == 0.0 {
        return Ok(None);
    }
    let best_at = |slope: f64| {
        let sum = |lag: i64| -> f64 {
            let one = |(centre, sums): &(f64, Vec<f64>)| sums[(lag + (slope * centre).round() as i64 + most) as usize];
            (sign * blocks.iter().map(one).sum::<f64>() / scale).max(0.0)
        };
        let lags = -(reach + SLACK)..=reach + SLACK;
        lags.map(|lag| (lag, sum(lag))).max_by(|one, other| one.1.total_cmp(&other.1)).unwrap_or((0, 0.0))
    };
    let slopes: Vec<f64> = (-2 * reach..=2 * reach).map(|step| 0.5 * step as f64 / middle).collect();
    let all: Vec<(i64, f64)> = slopes.iter().map(|&slope| best_at(slope)).collect();
    let worth = |index: usize| -(1.0 - all[index].1.powi(2)).max(1e-6).ln();
    let best = (0..all.len()).max_by(|&one, &other| worth(one).total_cmp(&worth(other))).unwrap_or(0);
    // Its own lobe ends at the first valley on either side.
    let falls = |from: usize, to: usize| worth(to) <= worth(from);
    let mut ends = (best, best);
    while ends.0 > 0 && falls(ends.0, ends.0 - 1) {
        ends.0 -= 1;
    }
    while ends.1 + 1 < all.len() && falls(ends.1, ends.1 + 1) {
        ends.1 += 1;
    }
    // A ripple near the top is rounding to whole samples, not another fit.
    let rival = |&index: &usize| (index < ends.0 || index > ends.1) && worth(index) > AMBIGUOUS * worth(best);
    let far = (0..all.len()).filter(rival).any(|index| {
        let (low, high) = (index.min(best), index.max(best));
        (low..high).any(|between| worth(between) < 0.5 * worth(best))
    });
    Ok((!far).then_some(Guess { lag: all[best].0 as f64, slope: slopes[best] }))
}

/// ψ and a'b' over the inner record.
struct Score {
    /// Index less the middle.
    places: Vec<f64>,
    scores: Vec<f64>,
    weights: Vec<f64>,
}

impl Score {
    /// Σ ψ = 0 and Σ ψ x = 0 by Newton's steps; none where they do not come to rest.
    fn solved(a: &Filtered, b: &Filtered, begin: Guess, sinc: &Sinc) -> Result<Option<(Guess, Self)>, Error> {
        let middle = 0.5 * (a.samples as f64 - 1.0);
        let edge = (a.samples / 20).max(2 * REACH);
        let ((value_a, slope_a), (value_b, slope_b)) = (a.shifted(0.0)?, b.shifted(0.0)?);
        let mut guess = begin;
        let mut alike = 0.0_f64;
        for step in 0..20 {
            let mut both = (0.0, 0.0, 0.0);
            let mut score = Self { places: Vec::new(), scores: Vec::new(), weights: Vec::new() };
            for index in edge..a.samples - edge {
                let place = guess.place(index, middle);
                let (value, slope) = (sinc.at(&value_b, place), sinc.at(&slope_b, place));
                both = (both.0 + value_a[index] * value, both.1 + value_a[index].powi(2), both.2 + value * value);
                score.places.push(index as f64 - middle);
                score.scores.push(0.5 * (value * slope_a[index] - value_a[index] * slope));
                score.weights.push(slope_a[index] * slope);
            }
            let now = both.0 / (both.1 * both.2).sqrt();
            // A root half a period away fits worse than where it was begun, or with the other sign.
            if step == 0 {
                alike = now;
            } else if now * alike.signum() < 0.98 * alike.abs() {
                return Ok(None);
            }
            let (sums, centre) = (score.moments(), score.centre());
            let rise = score.sum(|place, score, _| (place - centre) * score) / sums.1;
            let (level, turn) = (score.sum(|_, score, _| score) / sums.0, rise);
            if !(level.is_finite() && turn.is_finite()) {
                return Ok(None);
            }
            guess.slope -= turn;
            guess.lag -= level - turn * centre;
            if level.abs() < 1e-9 && turn.abs() * middle < 1e-9 {
                return Ok(Some((guess, score)));
            }
        }
        Ok(None)
    }

    fn sum(&self, of: impl Fn(f64, f64, f64) -> f64) -> f64 {
        let each = self.places.iter().zip(&self.scores).zip(&self.weights);
        each.map(|((place, score), weight)| of(*place, *score, *weight)).sum()
    }

    /// Where the information's middle is.
    fn centre(&self) -> f64 {
        self.sum(|place, _, weight| place * weight) / self.sum(|_, _, weight| weight)
    }

    /// Σ w and Σ w (x − x̄)².
    fn moments(&self) -> (f64, f64) {
        let centre = self.centre();
        (self.sum(|_, _, weight| weight), self.sum(|place, _, weight| weight * (place - centre).powi(2)))
    }

    /// With intervals from the scatter of the parts.
    fn line(&self, guess: Guess, middle: f64) -> Result<Line, Error> {
        let (centre, (level, turn)) = (self.centre(), self.moments());
        let part = self.places.len() / PARTS;
        let half = |of: &dyn Fn(usize) -> (f64, f64), total: f64| -> Result<f64, Error> {
            let sums = (0..PARTS).map(|n| {
                let (score, weight) =
                    (n * part..(n + 1) * part).map(of).fold((0.0, 0.0), |sum, one| (sum.0 + one.0, sum.1 + one.1));
                (score * score, weight, weight * weight)
            });
            let (scatter, weight, square) =
                sums.fold((0.0, 0.0, 0.0), |sum, one| (sum.0 + one.0, sum.1 + one.1, sum.2 + one.2));
            // Two unknowns are taken from the parts that carry the motion.
            let freedom = (weight * weight / square - 2.0).clamp(1.0, PARTS as f64 - 2.0);
            let parts = PARTS as f64;
            Ok(coverage_factor(0.95, freedom)? * (scatter * parts / (parts - 2.0)).sqrt() / total.abs())
        };
        let away = |index: usize| self.places[index] - centre;
        Ok(Line {
            lag: guess.lag + guess.slope * centre,
            lag_half: half(&|index| (self.scores[index], self.weights[index]), level)?,
            slope: guess.slope,
            slope_half: half(
                &|index| (away(index) * self.scores[index], away(index).powi(2) * self.weights[index]),
                turn,
            )?,
            centre: centre + middle,
        })
    }
}
