//! Where the windings are over time.
//!
//! Next door: how they got there (the parent), whether they touch (`measures`), what they do to a coil (`inductance`).

use pulp::{Simd, WithSimd};

use crate::error::{Error, all_finite};

/// Positions of both ends and of all windings over time \[m\].
#[derive(Debug, Clone, PartialEq)]
pub struct Windings {
    count: usize,
    ends: Vec<[f64; 2]>,
    positions: Vec<f64>,
}

impl Windings {
    /// Positions that come from elsewhere: u1 and u2 of each sample \[m\], shape `samples × 2`, and x_1…x_N of each sample \[m\],
    /// shape `samples × N`, row-major.
    ///
    /// # Errors
    /// [`Error::Count`] where there is no sample, or not the same number of windings in each; [`Error::Value`] for the first position
    /// that is not finite.
    pub fn new(ends: Vec<[f64; 2]>, positions: Vec<f64>) -> Result<Self, Error> {
        let samples = ends.len();
        if samples == 0 || positions.is_empty() || !positions.len().is_multiple_of(samples) {
            let allowed = format!("a whole number of windings for each of {samples} samples");
            return Err(Error::Count { quantity: "positions".into(), found: positions.len(), allowed: allowed.into() });
        }
        all_finite("ends", ends.as_flattened(), "m")?;
        all_finite("positions", &positions, "m")?;
        Ok(Self { count: positions.len() / samples, ends, positions })
    }

    pub(crate) fn zero(count: usize, samples: usize) -> Self {
        Self { count, ends: vec![[0.0; 2]; samples], positions: vec![0.0; samples * count] }
    }

    pub(crate) fn row_mut(&mut self, sample: usize) -> &mut [f64] {
        &mut self.positions[sample * self.count..][..self.count]
    }

    pub(crate) fn set_ends(&mut self, sample: usize, ends: [f64; 2]) {
        self.ends[sample] = ends;
    }

    /// N: windings per sample.
    pub fn count(&self) -> usize {
        self.count
    }

    /// How many samples there are.
    pub fn samples(&self) -> usize {
        self.ends.len()
    }

    /// u1 and u2 of a sample, counted from zero.
    ///
    /// # Panics
    /// Where there is no such sample, as a slice does.
    pub fn ends(&self, sample: usize) -> [f64; 2] {
        self.ends[sample]
    }

    /// x_1…x_N of a sample, counted from zero; shape `N`.
    ///
    /// # Panics
    /// Where there is no such sample, as a slice does.
    pub fn row(&self, sample: usize) -> &[f64] {
        &self.positions[sample * self.count..][..self.count]
    }

    /// x_1…x_N of every sample; shape `samples × N`, row-major.
    pub fn positions(&self) -> &[f64] {
        &self.positions
    }
}

/// Straight line between the ends plus the modal pattern: works for positions and for velocities alike.
pub(super) struct Place<'a> {
    /// Shape `N`.
    pub row: &'a mut [f64],
    /// φ_j(i), one row per mode: shape `count × N`.
    pub shapes: &'a [f64],
    /// Shape `count`.
    pub coordinates: &'a [f64],
    pub ends: [f64; 2],
}

impl WithSimd for Place<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) {
        // Plain loops: the compiler turns them into the vectors that are allowed here.
        let masses = self.row.len();
        let spacing = (self.ends[1] - self.ends[0]) / masses as f64;
        self.row.fill(0.0);
        for (shape, coordinate) in self.shapes.chunks_exact(masses).zip(self.coordinates) {
            for (position, shape) in self.row.iter_mut().zip(shape) {
                *position += shape * coordinate;
            }
        }
        for (index, position) in self.row.iter_mut().enumerate() {
            *position += self.ends[0] + (index as f64 + 0.5) * spacing;
        }
    }
}
