//! Sobol's sequence, scrambled, at any row.
//!
//! Next door: the direction numbers (crate `sobol`, which itself only walks from point to point), other samplings (`sampling`).

use sobol::params::JoeKuoD6;

use super::permutation::mixed;

/// Most variables: as many as the direction numbers at hand.
pub(super) const MOST_VARIABLES: usize = 100;
/// Most rows: the bits of a point.
pub(super) const MOST_ROWS: u64 = 1 << 32;

/// Bits of a point; those below are drawn.
const BITS: usize = 32;

/// Sobol's sequence under Owen's nested uniform scrambling, by hash.
///
/// Source:   `[Joe2008]` direction numbers; scrambling as `[Burley2020]`: Laine's and Karras's permutation of the reversed bits.
/// Valid:    up to 100 variables and 2³² rows; 2^n rows are the most even.
#[derive(Debug, Clone)]
pub(super) struct Sobol {
    /// 32 numbers for each variable.
    directions: Vec<Vec<u32>>,
    seeds: Vec<u64>,
}

impl Sobol {
    pub fn new(dimensions: usize, seed: u64) -> Self {
        let directions = sobol::Sobol::<u32>::init_direction_vals(dimensions, BITS, &JoeKuoD6::minimal());
        let seeds = (0..dimensions as u64).map(|dimension| mixed(mixed(seed) ^ mixed(dimension))).collect();
        Self { directions, seeds }
    }

    /// Shares from 0 to 1 of a row, one for each variable.
    pub fn row(&self, row: u64) -> Vec<f64> {
        self.directions.iter().zip(&self.seeds).map(|(directions, seed)| share(directions, row as u32, *seed)).collect()
    }
}

fn share(directions: &[u32], row: u32, seed: u64) -> f64 {
    let plain =
        directions.iter().enumerate().filter(|(bit, _)| row >> bit & 1 == 1).fold(0, |sum, (_, next)| sum ^ next);
    let high = scrambled(plain, seed as u32);
    // Owen's scrambling goes on below the last bit, where every row has a path of its own.
    let low = mixed(seed ^ u64::from(row)) >> 43;
    (f64::from(high) + low as f64 / f64::from(1 << 21)) / 2f64.powi(BITS as i32)
}

/// Each bit is turned or not, by a hash of the bits above it.
fn scrambled(point: u32, seed: u32) -> u32 {
    let mut x = point.reverse_bits().wrapping_add(seed);
    for factor in [0x6c50_b47c, 0xb82f_1e52, 0xc7af_e638, 0x8d22_f6e6u32] {
        x ^= x.wrapping_mul(factor);
    }
    x.reverse_bits()
}

#[cfg(test)]
mod tests {
    use super::Sobol;

    /// What makes a (0, m, 2)-net in base 2: every elementary box of area 2^−m holds one of 2^m points. Sobol's first two variables are one,
    /// and scrambling keeps it.
    #[test]
    fn the_first_two_variables_fill_every_elementary_box_once() {
        let sobol = Sobol::new(2, 11);
        let points: Vec<Vec<f64>> = (0..256).map(|row| sobol.row(row)).collect();
        for bits in 0..=8 {
            let (columns, rows) = (1usize << bits, 256usize >> bits);
            let mut boxes = vec![0; 256];
            for point in &points {
                boxes[(point[0] * columns as f64) as usize * rows + (point[1] * rows as f64) as usize] += 1;
            }
            assert_eq!(boxes, vec![1; 256], "{columns} × {rows}");
        }
    }

    #[test]
    fn each_of_a_hundred_variables_is_stratified() {
        let sobol = Sobol::new(super::MOST_VARIABLES, 2);
        for dimension in 0..super::MOST_VARIABLES {
            let mut parts: Vec<usize> = (0..64).map(|row| (sobol.row(row)[dimension] * 64.0) as usize).collect();
            parts.sort_unstable();
            assert_eq!(parts, (0..64).collect::<Vec<_>>());
        }
    }
}
