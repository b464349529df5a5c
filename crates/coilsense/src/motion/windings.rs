//! Where the windings are over time.
//!
//! Next door: how they got there (the parent), whether they touch (`measures`), what they do to a coil (`inductance`).

use super::modal_rows::WIDTH;
use crate::error::{Error, all_finite, called, check, number_of};

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
            return Err(number_of("positions", positions.len(), allowed));
        }
        all_finite("ends", ends.as_flattened(), "m")?;
        all_finite("positions", &positions, "m")?;
        Ok(Self { count: positions.len() / samples, ends, positions })
    }

    /// Between these ends, u1 and u2, without any positions yet.
    pub(super) fn zero([first, second]: [Vec<f64>; 2], count: usize) -> Self {
        let ends: Vec<[f64; 2]> = first.into_iter().zip(second).map(<[f64; 2]>::from).collect();
        Self { count, positions: vec![0.0; ends.len() * count], ends }
    }

    /// Sets the positions of some samples: `places` on the straight lines between `lines`, plus displacements, shape `N × WIDTH`.
    pub(super) fn place(&mut self, samples: &[usize], displacements: &[f64], places: &[f64], lines: &[Vec<f64>; 2]) {
        let count = self.count;
        for (column, &sample) in samples.iter().enumerate() {
            let (first, last) = (lines[0][sample], lines[1][sample]);
            let length = last - first;
            let row = self.positions[sample * count..][..count].iter_mut().zip(places);
            for ((position, place), displaced) in row.zip(displacements.chunks_exact(WIDTH)) {
                *position = displaced[column] + (first + place * length);
            }
        }
    }

    /// Moves each mass by what belongs to it \[m\], shape `N`; none where there is nothing.
    pub(super) fn shift(&mut self, offsets: &[f64]) {
        if offsets.is_empty() {
            return;
        }
        for row in self.positions.chunks_exact_mut(self.count) {
            row.iter_mut().zip(offsets).for_each(|(position, offset)| *position += offset);
        }
    }

    /// The centres of whole windings of `masses` masses each: that of the middle mass, or half way between the two in the middle.
    ///
    /// # Errors
    /// [`Error::Value`] where the masses of a sample are no whole number of such windings.
    pub fn turns(&self, masses: usize) -> Result<Self, Error> {
        let allowed = format!("at least 1, and a divisor of the {} masses", self.count);
        check(
            masses > 0 && self.count.is_multiple_of(masses),
            called("masses", "masses per winding"),
            masses as f64,
            "",
            allowed,
        )?;
        let centre = |winding: &[f64]| 0.5 * (winding[(masses - 1) / 2] + winding[masses / 2]);
        let positions = self.positions.chunks_exact(masses).map(centre).collect();
        Ok(Self { count: self.count / masses, ends: self.ends.clone(), positions })
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

    /// Ends and positions as [`Self::new`] takes them, moved out.
    pub fn into_parts(self) -> (Vec<[f64; 2]>, Vec<f64>) {
        (self.ends, self.positions)
    }
}
