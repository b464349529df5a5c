//! Indices as ratios of means over base rows, so that drawing rows anew is drawing sums anew.
//!
//! Next door: what the sums mean, and where it comes from (`super::indices`).

use rand::RngExt;
use rand_pcg::Pcg64;
use rayon::prelude::*;

use super::{Estimate, Index, Resampling};

/// What each base row adds to the sums: f(A) + f(B), their squares, and for each variable f(B)(f(A_B) − f(A)) and (f(A) − f(A_B))².
pub(super) struct Parts {
    rows: usize,
    width: usize,
    parts: Vec<f64>,
}

impl Parts {
    /// Of base rows, from which `mean` is taken off.
    pub fn of(rows: &[&[f64]], mean: f64) -> Self {
        let variables = rows.first().map_or(0, |row| row.len() - 2);
        let width = 2 + 2 * variables;
        let mut parts = Vec::with_capacity(rows.len() * width);
        for row in rows {
            let (a, b) = (row[0] - mean, row[variables + 1] - mean);
            parts.extend([a + b, a * a + b * b]);
            for value in &row[1..=variables] {
                let mixed = value - mean;
                parts.extend([b * (mixed - a), (a - mixed) * (a - mixed)]);
            }
        }
        Self { rows: rows.len(), width, parts }
    }

    /// Mean and variance of f(A) and f(B) together.
    pub fn moments(&self) -> [f64; 2] {
        moments(&self.sums(0..self.rows), self.rows)
    }

    /// Each variable's indices with their intervals.
    pub fn estimates(&self, resampling: &Resampling) -> Vec<Index> {
        let found = ratios(&self.sums(0..self.rows), self.rows);
        // A stream of draws for each resample: what a thread finds does not depend on how many there are.
        let resampled: Vec<Vec<f64>> = (0..resampling.resamples)
            .into_par_iter()
            .map(|resample| {
                let mut draws = Pcg64::new(u128::from(resampling.seed), resample as u128);
                ratios(&self.sums((0..self.rows).map(|_| draws.random_range(0..self.rows))), self.rows)
            })
            .collect();
        let estimate = |index: usize| {
            let mut spread: Vec<f64> =
                resampled.iter().map(|ratios| ratios[index]).filter(|ratio| ratio.is_finite()).collect();
            spread.sort_unstable_by(f64::total_cmp);
            let tail = 0.5 * (1.0 - resampling.level);
            Estimate { value: found[index], lower: quantile(&spread, tail), upper: quantile(&spread, 1.0 - tail) }
        };
        (0..found.len()).step_by(2).map(|index| Index { first: estimate(index), total: estimate(index + 1) }).collect()
    }

    fn sums(&self, rows: impl Iterator<Item = usize>) -> Vec<f64> {
        let mut sums = vec![0.0; self.width];
        for row in rows {
            for (sum, part) in sums.iter_mut().zip(&self.parts[row * self.width..][..self.width]) {
                *sum += part;
            }
        }
        sums
    }
}

fn moments(sums: &[f64], rows: usize) -> [f64; 2] {
    let both = 2.0 * rows as f64;
    let mean = sums[0] / both;
    [mean, sums[1] / both - mean * mean]
}

/// First-order and total index of each variable in turn.
fn ratios(sums: &[f64], rows: usize) -> Vec<f64> {
    let variance = moments(sums, rows)[1];
    let ratio = |(place, sum): (usize, &f64)| {
        let mean = sum / rows as f64;
        if place % 2 == 0 { mean / variance } else { 0.5 * mean / variance }
    };
    sums[2..].iter().enumerate().map(ratio).collect()
}

/// The value below which a share of sorted values lies, linear between them.
fn quantile(sorted: &[f64], share: f64) -> f64 {
    let Some(last) = sorted.len().checked_sub(1) else { return f64::NAN };
    let place = share * last as f64;
    let below = (place.floor() as usize).min(last);
    sorted[below] + (place - below as f64) * (sorted[(below + 1).min(last)] - sorted[below])
}
