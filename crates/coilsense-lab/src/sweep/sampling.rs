//! Which values a row has: a function of the seed and the row's number alone, never of the chunk that it is computed in.
//!
//! Next door: the permutation of a Latin hypercube (`permutation`), the Sobol sequence (`sobol`), what shares of a variable mean (`variable`).

use rand::RngExt;
use rand_pcg::Pcg64;
use serde::{Deserialize, Serialize};

use super::permutation::{Permutation, mixed};
use super::sobol::Sobol;

/// How rows are laid over the variables.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Sampling {
    /// Every combination of the variables' points, the last variable fastest.
    Grid,
    /// Latin hypercube: each variable's range falls into as many parts of equal probability as there are rows, each part met once.
    Lhs,
    /// Independent draws.
    MonteCarlo,
    /// Sobol's sequence, Owen-scrambled: first numbers of 2^n rows fill the ranges most evenly.
    Sobol,
    /// Saltelli's design for sensitivity indices: for each base row two independent rows of Sobol's sequence in one, and between them the
    /// first with one variable after the other from the second (`[Saltelli2010]`, section 3); see [`crate::sensitivity`].
    Saltelli,
}

impl Sampling {
    /// All of them, by their words.
    pub const ALL: [(&'static str, Self); 5] = [
        ("grid", Self::Grid),
        ("lhs", Self::Lhs),
        ("monte-carlo", Self::MonteCarlo),
        ("sobol", Self::Sobol),
        ("saltelli", Self::Saltelli),
    ];

    /// The sampling of a word.
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|(word, _)| *word == name).map(|(_, sampling)| sampling)
    }

    /// Its word.
    pub fn name(self) -> &'static str {
        Self::ALL.iter().find(|(_, sampling)| *sampling == self).map_or("", |(word, _)| word)
    }
}

/// A variable's place in a row: a number of a point, or a share of all values that lie below.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Coordinate {
    Point(u64),
    Share(f64),
}

/// The generator's own stream, as its author has it.
const STREAM: u128 = 0x0a02_bdbf_7bb3_c0a7_ac28_fa16_a64a_bf96;

/// A sampling made ready.
#[derive(Debug, Clone)]
pub(super) enum Sampler {
    Grid { points: Vec<u64> },
    Lhs { permutations: Vec<Permutation>, rows: u64, seed: u64 },
    MonteCarlo { dimensions: usize, seed: u64 },
    Sobol(Sobol),
    Saltelli { dimensions: usize, sobol: Sobol },
}

/// Apart from one another: draws of Monte Carlo, jitter of a hypercube's parts, the orders of its parts.
const JITTER: u64 = 0x9e37_79b9_7f4a_7c15;

impl Sampler {
    /// - `points`: of each variable, where it has some; a grid needs them of all
    pub fn new(sampling: Sampling, points: &[Option<u64>], rows: u64, seed: u64) -> Self {
        let dimensions = points.len();
        match sampling {
            Sampling::Grid => Self::Grid { points: points.iter().map(|points| points.unwrap_or(1)).collect() },
            Sampling::Lhs => {
                let permutations = (0..dimensions).map(|dimension| Permutation::new(rows, seed, dimension as u64));
                Self::Lhs { permutations: permutations.collect(), rows, seed }
            }
            Sampling::MonteCarlo => Self::MonteCarlo { dimensions, seed },
            Sampling::Sobol => Self::Sobol(Sobol::new(dimensions, seed)),
            Sampling::Saltelli => Self::Saltelli { dimensions, sobol: Sobol::new(2 * dimensions, seed) },
        }
    }

    /// The coordinates of a row, one per variable.
    pub fn row(&self, row: u64) -> Vec<Coordinate> {
        match self {
            Self::Grid { points } => {
                let mut rest = row;
                let mut row: Vec<Coordinate> = points.iter().rev().map(|points| digit(&mut rest, *points)).collect();
                row.reverse();
                row
            }
            Self::Lhs { permutations, rows, seed } => {
                let jitter = draws(seed ^ JITTER, row, permutations.len());
                let place = |(order, jitter): (&Permutation, f64)| (order.at(row) as f64 + jitter) / *rows as f64;
                permutations.iter().zip(jitter).map(place).map(Coordinate::Share).collect()
            }
            Self::MonteCarlo { dimensions, seed } => {
                draws(*seed, row, *dimensions).into_iter().map(Coordinate::Share).collect()
            }
            Self::Sobol(sobol) => sobol.row(row).into_iter().map(Coordinate::Share).collect(),
            Self::Saltelli { dimensions, sobol } => {
                let of_base = *dimensions as u64 + 2;
                let (first, second) = (sobol.row(row / of_base), (row % of_base) as usize);
                let of = |variable: usize| {
                    let from_second = second == variable + 1 || second == dimensions + 1;
                    Coordinate::Share(first[variable + if from_second { *dimensions } else { 0 }])
                };
                (0..*dimensions).map(of).collect()
            }
        }
    }
}

/// The lowest digit in a base, taken off.
fn digit(rest: &mut u64, base: u64) -> Coordinate {
    let digit = *rest % base;
    *rest /= base;
    Coordinate::Point(digit)
}

/// Draws from 0 to 1 of a row: one long stream of a generator, of which each row has its own part.
fn draws(seed: u64, row: u64, count: usize) -> Vec<f64> {
    let mut generator = Pcg64::new(u128::from(mixed(seed)) << 64 | u128::from(mixed(!seed)), STREAM);
    generator.advance(u128::from(row) * count as u128);
    (0..count).map(|_| generator.random::<f64>()).collect()
}

#[cfg(test)]
mod tests {
    use super::{Coordinate, Sampler, Sampling};

    fn shares(sampling: Sampling, dimensions: usize, rows: u64, seed: u64) -> Vec<Vec<f64>> {
        let sampler = Sampler::new(sampling, &vec![None; dimensions], rows, seed);
        let share = |coordinate| match coordinate {
            Coordinate::Share(share) => share,
            Coordinate::Point(_) => f64::NAN,
        };
        (0..rows).map(|row| sampler.row(row).into_iter().map(share).collect()).collect()
    }

    #[test]
    fn a_grid_meets_every_combination_once_the_last_variable_fastest() {
        let sampler = Sampler::new(Sampling::Grid, &[Some(2), Some(3)], 6, 0);
        let rows: Vec<Vec<Coordinate>> = (0..6).map(|row| sampler.row(row)).collect();
        let expected: Vec<Vec<Coordinate>> =
            (0..2).flat_map(|a| (0..3).map(move |b| vec![Coordinate::Point(a), Coordinate::Point(b)])).collect();
        assert_eq!(rows, expected);
    }

    #[test]
    fn a_latin_hypercube_meets_each_part_of_each_variable_once() {
        for rows in [1, 2, 7, 1000] {
            let points = shares(Sampling::Lhs, 3, rows, 5);
            for dimension in 0..3 {
                let mut parts: Vec<u64> = points.iter().map(|row| (row[dimension] * rows as f64) as u64).collect();
                parts.sort_unstable();
                assert_eq!(parts, (0..rows).collect::<Vec<_>>());
            }
        }
    }

    #[test]
    fn draws_are_uniform_and_uncorrelated_between_variables_and_rows() {
        for sampling in [Sampling::MonteCarlo, Sampling::Lhs, Sampling::Sobol] {
            let points = shares(sampling, 2, 4096, 1);
            let mean = |f: &dyn Fn(&[f64], &[f64]) -> f64| {
                points.windows(2).map(|pair| f(&pair[0], &pair[1])).sum::<f64>() / 4095.0
            };
            // A mean of 4096 uniform draws scatters by 0.0045, a product of centred ones by 0.0013: bounds at five of them. Rows that follow one another in a Sobol sequence avoid each other by design.
            assert!((mean(&|row, _| row[0]) - 0.5).abs() < 0.023, "{sampling:?}");
            assert!(mean(&|row, _| (row[0] - 0.5) * (row[1] - 0.5)).abs() < 0.0065, "{sampling:?}");
            if sampling != Sampling::Sobol {
                assert!(mean(&|row, next| (row[0] - 0.5) * (next[0] - 0.5)).abs() < 0.0065, "{sampling:?}");
            }
        }
    }

    #[test]
    fn a_base_row_goes_from_one_row_of_sobol_to_another_one_variable_at_a_time() {
        let (design, plain) = (shares(Sampling::Saltelli, 3, 5 * 64, 4), shares(Sampling::Sobol, 6, 64, 4));
        for (base, sobol) in design.chunks(5).zip(plain) {
            let (a, b) = sobol.split_at(3);
            assert_eq!((base[0].as_slice(), base[4].as_slice()), (a, b));
            for variable in 0..3 {
                let mixed: Vec<f64> = (0..3).map(|other| if other == variable { b[other] } else { a[other] }).collect();
                assert_eq!(base[variable + 1], mixed);
            }
        }
    }

    #[test]
    fn another_seed_gives_other_rows_and_the_same_seed_the_same() {
        for sampling in [Sampling::MonteCarlo, Sampling::Lhs, Sampling::Sobol] {
            assert_eq!(shares(sampling, 2, 16, 1), shares(sampling, 2, 16, 1));
            assert_ne!(shares(sampling, 2, 16, 1), shares(sampling, 2, 16, 2));
        }
    }
}
