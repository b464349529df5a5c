//! Where the modes put places along the coil, many samples at once: one small matrix product for a block, half of one where every shape is
//! its own mirror image.
//!
//! Next door: the modal coordinates (`modal_block`), the matrix product (`panel`), positions in order (`windings`).

use aligned_vec::{AVec, avec};
use pulp::{Simd, WithSimd};

use super::modal_block::ModalBlock;
use super::modal_rows::{WIDTH, row_of};
use super::panel::{Panel, ROWS};
use crate::simd::dispatch;

/// What a unit of each mode displaces each place by, and the displacements of a block.
pub(super) struct Placing {
    places: usize,
    /// Rows of modes 1, 3, 5 … and of modes 2, 4, 6 …, all of both in one table where places are no mirror images.
    shapes: Vec<Shapes>,
    sums: AVec<f64>,
    /// Shape `places × WIDTH`.
    displacements: AVec<f64>,
}

/// Shapes of some of the modes.
struct Shapes {
    /// Which rows of the coordinates.
    modes: std::ops::Range<usize>,
    /// Places, or half of them, rounded up to what the matrix product takes.
    rows: usize,
    /// Shape `modes × rows`.
    table: AVec<f64>,
}

impl Placing {
    /// - `places`: how many; `modes`: how many; `shape`: what a unit of a mode displaces a place by, both counted from zero
    /// - `mirrored`: whether `shape(mode, places − 1 − place)` is `shape(mode, place)` for modes 0, 2, 4 … and its negative for the others
    pub(super) fn new(places: usize, modes: usize, mirrored: bool, shape: impl Fn(usize, usize) -> f64) -> Self {
        let even = modes.div_ceil(2);
        let tabulate = |rows: std::ops::Range<usize>, places: usize| {
            let height = places.next_multiple_of(ROWS);
            let mut table = avec![0.0; rows.len() * height];
            for mode in 0..modes {
                let row = row_of(mode, modes);
                if rows.contains(&row) {
                    let values = table[(row - rows.start) * height..].iter_mut().take(places);
                    values.enumerate().for_each(|(place, value)| *value = shape(mode, place));
                }
            }
            Shapes { modes: rows, rows: height, table }
        };
        let shapes = if mirrored {
            let half = places.div_ceil(2);
            vec![tabulate(0..even, half), tabulate(even..modes, half)]
        } else {
            vec![tabulate(0..modes, places)]
        };
        let height = shapes[0].rows;
        Self {
            places,
            sums: avec![0.0; shapes.len() * height * WIDTH],
            shapes,
            displacements: avec![0.0; places * WIDTH],
        }
    }

    /// Displacements of a block's samples, shape `places × WIDTH`; what is behind the last sample means nothing.
    pub(super) fn displace(&mut self, block: &ModalBlock<'_>) -> &[f64] {
        let height = self.shapes[0].rows * WIDTH;
        for (shapes, sums) in self.shapes.iter().zip(self.sums.chunks_exact_mut(height)) {
            let right = &block.coordinates[shapes.modes.start * WIDTH..shapes.modes.end * WIDTH];
            for (first, sums) in sums.chunks_exact_mut(ROWS * WIDTH).enumerate() {
                let (rows, left) = (shapes.rows, &shapes.table);
                dispatch(Panel { rows, first_row: first * ROWS, columns: WIDTH, left, right, sums });
            }
        }
        if self.shapes.len() == 2 {
            dispatch(Mirror { sums: &self.sums, places: self.places, displacements: &mut self.displacements });
            return &self.displacements;
        }
        &self.sums[..self.places * WIDTH]
    }
}

/// Puts what both halves share and what they do against each other in its places.
struct Mirror<'a> {
    /// Even ones, then odd ones.
    sums: &'a [f64],
    places: usize,
    displacements: &'a mut [f64],
}

impl WithSimd for Mirror<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) {
        // Plain loops: the compiler turns them into the vectors that are allowed here.
        let (even, odd) = self.sums.split_at(self.sums.len() / 2);
        for place in 0..self.places {
            let mirror = self.places - 1 - place;
            let sign = if place <= mirror { 1.0 } else { -1.0 };
            let from = place.min(mirror) * WIDTH;
            let halves = even[from..from + WIDTH].iter().zip(&odd[from..from + WIDTH]);
            for (displacement, (even, odd)) in self.displacements[place * WIDTH..][..WIDTH].iter_mut().zip(halves) {
                *displacement = even + sign * odd;
            }
        }
    }
}
