//! Maxwell's sum over many samples by a polynomial for each number of turns apart: a pair costs a few multiply-adds, no root, no division,
//! no logarithm.
//!
//! Next door: the pair itself (`reduced`, `pairs`), the samples (`turn_block`), the polynomials' construction (`chebyshev`).

use aligned_vec::{AVec, avec};
use pulp::{Simd, WithSimd};

use super::chebyshev::{Interpolation, ellipse};
use super::distances::Distances;
use super::reduced;
use super::turn_block::{Columns, TurnBlock};
use crate::motion::WIDTH;
use crate::simd::dispatch;

/// Highest degree worth having: beyond it a pair by itself is as cheap.
const HIGHEST: usize = 24;
/// What all polynomials together may be off, relative to the part of L that the wires contribute by themselves.
const TRUNCATION: f64 = 2e-16;
/// Where ellipses may end on the left, as shares of the middle distance: the one is taken that gives the lowest degree.
const LEFT: [f64; 5] = [0.5, 0.25, 0.125, 0.0625, 0.03125];
/// Polynomials for distances within a range.
///
/// Turns a apart are a p0 + z apart, |z| ≤ w_a; M there is a polynomial in z of the least degree n with
/// `4 F(h) ρ^(−n)/(ρ − 1)` within bounds, ρ that of the ellipse from the real axis's point h on. F is completely monotone,
/// `∫ J₁(κr)² e^(−κh) dκ`, so that |F| on the ellipse is at most F at its left end: the bound is rigorous.
///
/// Source: `[Trefethen2013]` theorem 8.2.
#[derive(Debug, Clone)]
pub(super) struct LagPolynomials {
    /// What they are good for; none yet where `None`.
    range: Option<Distances>,
    /// p0 \[m\].
    middle: f64,
    /// Σ_a (turns − a) times the polynomial's value at z = 0.
    constant: f64,
    /// Coefficients of z, z² … by lag, and where each lag's begin.
    coefficients: Vec<f64>,
    begins: Vec<usize>,
    interpolations: Vec<Option<Interpolation>>,
    /// Places of a block's turns, shape `turns × WIDTH`.
    places: AVec<f64>,
}

impl LagPolynomials {
    /// None yet.
    pub(super) fn new() -> Self {
        Self {
            range: None,
            middle: 0.0,
            constant: 0.0,
            coefficients: Vec::new(),
            begins: Vec::new(),
            interpolations: Vec::new(),
            places: avec![],
        }
    }

    /// Σ_{i<j} y³ D(c) of each sample as of [`super::pairs::sum`]; `None` where turns meet, change their order, or come so near in one
    /// sample and are so far in another that polynomials are no gain.
    ///
    /// - `radius`: r \[m\]; `floor`: Σ y³ D(c) of the self term alone, what the sum's error is measured by
    pub(super) fn sum(&mut self, block: &TurnBlock, radius: f64, floor: f64) -> Option<Columns> {
        if !block.extent.is_finite {
            return None;
        }
        let range = Distances::of(block);
        if !self.range.is_some_and(|known| known.holds(&range)) {
            let wide = self.range.map(|known| known.union(&range)).filter(|both| both.width() < 2.0 * range.width());
            let wanted = wide.unwrap_or(range).widened();
            self.range = None;
            self.build(block.turns(), wanted, radius, floor).then(|| self.range = Some(wanted))?;
        }
        let mut sums = [self.constant; WIDTH];
        let mut places = std::mem::replace(&mut self.places, avec![]);
        places.resize(block.displacements.len(), 0.0);
        dispatch(Sum { polynomials: self, block, places: &mut places, sums: &mut sums });
        self.places = places;
        Some(sums)
    }

    /// Finds all polynomials; whether there are such.
    fn build(&mut self, turns: usize, range: Distances, radius: f64, floor: f64) -> bool {
        let [nearest, farthest] = range.spacings;
        let middle = 0.5 * (nearest + farthest);
        // The change of the pitch itself counts at every lag, that of the turns' places at most as far as they reach.
        let off = (range.pitches[1] - middle).abs().max((middle - range.pitches[0]).abs());
        let (neighbours, lags) = (0.5 * (farthest - nearest), turns.saturating_sub(1));
        let half = |lag: usize| {
            let apart = lag as f64;
            // Never nothing: the polynomial needs an interval.
            (apart * neighbours).min(range.reach + apart * off).max(1e-9 * apart * middle)
        };
        if nearest <= 0.0 || neighbours >= 0.8 * middle {
            return false;
        }
        (self.middle, self.constant) = (middle, 0.0);
        self.coefficients.clear();
        self.begins.clear();
        let lefts: Vec<f64> =
            (1..=lags).flat_map(|lag| LEFT.map(|share| share * lag as f64 * middle / radius)).collect();
        let largest = values(lefts);
        for (lag, largest) in (1..=lags).zip(largest.chunks_exact(LEFT.len())) {
            let (apart, half) = (lag as f64 * middle, half(lag));
            let allowed = TRUNCATION * floor / (lags * (turns - lag)) as f64;
            let of_left = LEFT
                .iter()
                .zip(largest)
                .map(|(share, largest)| degree(ellipse(apart, half, share * apart), *largest, allowed));
            let Some(degree) = of_left.min().filter(|degree| *degree <= HIGHEST) else { return false };
            self.push(turns - lag, degree, apart / radius, half / radius, radius);
        }
        true
    }

    /// Appends the polynomial of one lag, about `apart` radii within `half` radii, which stands for so many pairs.
    fn push(&mut self, pairs: usize, degree: usize, apart: f64, half: f64, radius: f64) {
        if self.interpolations.len() <= degree {
            self.interpolations.resize(degree + 1, None);
        }
        let interpolation = self.interpolations[degree].get_or_insert_with(|| Interpolation::new(degree + 1));
        let mut at = values(interpolation.nodes().iter().map(|z| apart + half * z).chain([apart]).collect());
        // Less the middle's: the rounding of a difference is smaller.
        let middle = at.pop().unwrap_or_default();
        at.iter_mut().for_each(|value| *value -= middle);
        let mut powers = vec![0.0; degree + 1];
        interpolation.coefficients(&at, &mut powers);
        self.constant += pairs as f64 * (middle + powers[0]);
        self.begins.push(self.coefficients.len());
        let (mut scale, per_metre) = (1.0, 1.0 / (half * radius));
        for power in &powers[1..] {
            scale *= per_metre;
            self.coefficients.push(power * scale);
        }
    }

    /// Coefficients of z, z² … of a lag counted from zero.
    #[inline(always)]
    fn of_lag(&self, lag: usize) -> &[f64] {
        let end = self.begins.get(lag + 1).copied().unwrap_or(self.coefficients.len());
        &self.coefficients[self.begins[lag]..end]
    }
}

/// The least degree with which an error is allowed, from 1 on.
fn degree(rho: f64, largest: f64, allowed: f64) -> usize {
    if rho <= 1.0 {
        return usize::MAX;
    }
    let orders = (4.0 * largest / ((rho - 1.0) * allowed)).ln() / rho.ln();
    // Not a number, or too many, is too many.
    if orders < HIGHEST as f64 { (orders.ceil() as usize).max(1) } else { usize::MAX }
}

/// y³ D(c) at distances of so many radii.
fn values(mut ratios: Vec<f64>) -> Vec<f64> {
    dispatch(Reduce(&mut ratios));
    ratios
}

/// One call of [`values`].
struct Reduce<'a>(&'a mut [f64]);

impl WithSimd for Reduce<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) {
        for ratio in self.0.iter_mut() {
            *ratio = if S::IS_SCALAR { reduced::mutual::<false>(*ratio) } else { reduced::mutual::<true>(*ratio) };
        }
    }
}

/// Adds the polynomials of all pairs to `sums`.
struct Sum<'a> {
    polynomials: &'a LagPolynomials,
    block: &'a TurnBlock,
    places: &'a mut AVec<f64>,
    sums: &'a mut Columns,
}

impl WithSimd for Sum<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        // What each pair waits for must be worked on together; more does not fit into the registers.
        if S::F64_LANES == 8 { self.evaluate::<S, 8>(simd) } else { self.evaluate::<S, 4>(simd) }
    }
}

impl Sum<'_> {
    #[inline(always)]
    fn evaluate<S: Simd, const VECTORS: usize>(self, simd: S) {
        let turns = self.block.turns();
        // Places but for a uniform pitch of p0, of which the polynomials know.
        let rows = self.places.chunks_exact_mut(WIDTH).zip(self.block.displacements.chunks_exact(WIDTH));
        for (turn, (place, displacement)) in rows.enumerate() {
            for column in 0..WIDTH {
                place[column] =
                    displacement[column] + turn as f64 * (self.block.pitches[column] - self.polynomials.middle);
            }
        }
        let (places, _) = S::as_simd_f64s(self.places);
        let (sums, _) = S::as_mut_simd_f64s(self.sums);
        let width = WIDTH / S::F64_LANES;
        for (chunk, sums) in sums.chunks_exact_mut(VECTORS).enumerate() {
            let mut totals = [simd.splat_f64s(0.0); VECTORS];
            for lag in 1..turns {
                let (last, rest) = match self.polynomials.of_lag(lag - 1).split_last() {
                    Some((last, rest)) => (simd.splat_f64s(*last), rest),
                    None => continue,
                };
                for turn in 0..turns - lag {
                    let near = &places[turn * width + chunk * VECTORS..][..VECTORS];
                    let far = &places[(turn + lag) * width + chunk * VECTORS..][..VECTORS];
                    let mut change = [simd.splat_f64s(0.0); VECTORS];
                    for vector in 0..VECTORS {
                        change[vector] = simd.sub_f64s(far[vector], near[vector]);
                    }
                    let mut value = [last; VECTORS];
                    for coefficient in rest.iter().rev() {
                        let coefficient = simd.splat_f64s(*coefficient);
                        for vector in 0..VECTORS {
                            value[vector] = simd.mul_add_e_f64s(value[vector], change[vector], coefficient);
                        }
                    }
                    for vector in 0..VECTORS {
                        totals[vector] = simd.mul_add_e_f64s(value[vector], change[vector], totals[vector]);
                    }
                }
            }
            for (sum, total) in sums.iter_mut().zip(totals) {
                *sum = simd.add_f64s(*sum, total);
            }
        }
    }
}
