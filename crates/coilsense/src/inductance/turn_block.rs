//! The turns of up to 64 samples, sample by sample in the lanes of vectors: how far each turn is from where uniform ones would be.
//!
//! Next door: where they come from (`carry`, `motion`), what is made of them (`lag_polynomials`, `near_uniform`).

use aligned_vec::{AVec, avec};
use pulp::{Simd, WithSimd};

use super::carry::Carry;
use crate::motion::{WIDTH, Windings};
use crate::simd::dispatch;

/// A number of each sample.
pub(super) type Columns = [f64; WIDTH];

/// Some samples. Columns behind the last hold the last once more.
#[derive(Debug, Clone)]
pub(super) struct TurnBlock {
    pub(super) samples: usize,
    /// p = l/N_L \[m\] of each sample.
    pub(super) pitches: Columns,
    /// δ \[m\], shape `turns × WIDTH`.
    pub(super) displacements: AVec<f64>,
    /// What [`Measure`] found.
    pub(super) extent: Extent,
}

/// How far the turns of each sample are from uniform.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Extent {
    /// Smallest and largest change of neighbours' distance \[m\].
    pub(super) neighbours: [Columns; 2],
    /// Smallest and largest displacement \[m\].
    pub(super) displacements: [Columns; 2],
    /// Whether every displacement is a number.
    pub(super) is_finite: bool,
}

impl TurnBlock {
    pub(super) fn new(turns: usize) -> Self {
        let extent = Extent { neighbours: [[0.0; WIDTH]; 2], displacements: [[0.0; WIDTH]; 2], is_finite: true };
        Self { samples: 0, pitches: [0.0; WIDTH], displacements: avec![0.0; turns * WIDTH], extent }
    }

    pub(super) fn turns(&self) -> usize {
        self.displacements.len() / WIDTH
    }

    /// Takes over samples of winding positions. `places`: of each turn along the coil; `windings`: N_L.
    pub(super) fn load(
        &mut self,
        windings: &Windings,
        samples: std::ops::Range<usize>,
        carry: &Carry,
        places: &[f64],
        count: f64,
        buffer: &mut Vec<f64>,
    ) {
        self.samples = samples.len();
        for (column, sample) in samples.enumerate() {
            let ends = windings.ends(sample);
            let length = ends[1] - ends[0];
            self.pitches[column] = length / count;
            let turns = carry.turns(ends, windings.row(sample), buffer);
            for ((row, turn), place) in self.displacements.chunks_exact_mut(WIDTH).zip(turns).zip(places) {
                row[column] = turn - (ends[0] + place * length);
            }
        }
        self.fill_up();
    }

    /// Takes over displacements that are at hand, shape `turns × WIDTH`, and the pitches of as many samples as they are good for.
    pub(super) fn set(&mut self, displacements: &[f64], pitches: impl Iterator<Item = f64>) {
        self.displacements.copy_from_slice(displacements);
        self.samples = 0;
        for pitch in pitches.take(WIDTH) {
            self.pitches[self.samples] = pitch;
            self.samples += 1;
        }
        self.fill_up();
    }

    /// Repeats the last sample in what is left of the columns.
    fn fill_up(&mut self) {
        let Some(last) = self.samples.checked_sub(1) else { return };
        if self.samples < WIDTH {
            for row in self.displacements.chunks_exact_mut(WIDTH) {
                let value = row[last];
                row[self.samples..].fill(value);
            }
            let pitch = self.pitches[last];
            self.pitches[self.samples..].fill(pitch);
        }
        dispatch(Measure(self));
    }

    /// Least and largest pitch.
    pub(super) fn pitch_range(&self) -> [f64; 2] {
        range(self.pitches.iter().copied())
    }

    /// Least and largest distance of neighbours.
    pub(super) fn spacing_range(&self) -> [f64; 2] {
        let [least, largest] = &self.extent.neighbours;
        let [least, _] = range(self.pitches.iter().zip(least).map(|(pitch, change)| pitch + change));
        let [_, largest] = range(self.pitches.iter().zip(largest).map(|(pitch, change)| pitch + change));
        [least, largest]
    }

    /// The largest change of the distance of any two turns.
    pub(super) fn reach(&self) -> f64 {
        let [least, largest] = &self.extent.displacements;
        range(least.iter().zip(largest).map(|(least, largest)| largest - least))[1]
    }
}

/// Least and largest of some numbers.
fn range(values: impl Iterator<Item = f64>) -> [f64; 2] {
    let begin = [f64::INFINITY, f64::NEG_INFINITY];
    values.fold(begin, |[least, largest], value| [least.min(value), largest.max(value)])
}

/// Finds a block's extent.
struct Measure<'a>(&'a mut TurnBlock);

impl WithSimd for Measure<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        let block = self.0;
        let width = WIDTH / S::F64_LANES;
        let (rows, _) = S::as_simd_f64s(&block.displacements);
        let least_of = |a, b| simd.select_f64s(simd.less_than_f64s(a, b), a, b);
        let largest_of = |a, b| simd.select_f64s(simd.less_than_f64s(a, b), b, a);
        let mut sums = [0.0; WIDTH];
        let [low, high] = &mut block.extent.neighbours;
        let [least, largest] = &mut block.extent.displacements;
        let results = [low, high, least, largest, &mut sums].map(|columns| S::as_mut_simd_f64s(columns).0);
        for column in 0..width {
            let (upper, lower) = (simd.splat_f64s(f64::NEG_INFINITY), simd.splat_f64s(f64::INFINITY));
            let (mut low, mut high, mut least, mut largest) = (lower, upper, lower, upper);
            let mut sum = simd.splat_f64s(0.0);
            let mut before = None;
            for row in rows.chunks_exact(width) {
                let value = row[column];
                sum = simd.add_f64s(sum, value);
                (least, largest) = (least_of(value, least), largest_of(largest, value));
                if let Some(before) = before {
                    let change = simd.sub_f64s(value, before);
                    (low, high) = (least_of(change, low), largest_of(high, change));
                }
                before = Some(value);
            }
            results[0][column] = low;
            results[1][column] = high;
            results[2][column] = least;
            results[3][column] = largest;
            results[4][column] = sum;
        }
        block.extent.is_finite = sums.iter().zip(&block.pitches).all(|(sum, pitch)| (sum + pitch).is_finite());
    }
}
