//! L of a series of samples: by the exact sum, or within a tolerance to second order where that is good enough.
//!
//! Next door: how blocks of samples are evaluated (`evaluation`), the second-order form and its bound (`second_order`), the exact sum (`maxwell`).

use super::evaluation::Evaluation;
use super::maxwell::MaxwellSum;
use super::second_order::BoundedInductance;
use super::turn_block::TurnBlock;
use crate::error::{Error, check};
use crate::motion::{Motion, WIDTH, Windings};

/// A series of inductances within a tolerance, see [`MaxwellSum::series_within`].
#[derive(Debug, Clone, PartialEq)]
pub struct BoundedSeries {
    /// L of every sample, with its own bound; shape `samples`.
    pub samples: Vec<BoundedInductance>,
    /// How many samples took the second-order form.
    pub second_order: usize,
    /// How many took the exact sum.
    pub exact: usize,
}

impl MaxwellSum {
    /// L \[H\] of every sample of a motion, shape `samples`; infinite where two turns coincide.
    ///
    /// Many samples share, for each number of turns apart, one polynomial over the distances that occur.
    ///
    /// Source:   as [`MaxwellSum`]; polynomials through Chebyshev's points, off by at most 2e-16 of L (`[Trefethen2013]` theorem 8.2).
    /// Valid:    as [`MaxwellSum`]; where neighbours' distances differ by a factor of some nine and more, turn by turn.
    /// Accuracy: 5e-15 relative, against 40 digits and against [`Self::at_positions`] (tests).
    pub fn series(&self, windings: &Windings) -> Vec<f64> {
        let mut series = Vec::with_capacity(windings.samples());
        let mut evaluation = Evaluation::new(self);
        self.for_each_block(windings, |block, alone| {
            series.extend_from_slice(&evaluation.exact(block, alone)[..block.samples]);
        });
        series
    }

    /// As [`Self::series`], by [`super::SecondOrder`] about each sample's own length where its bound is within `tolerance` of L, and by the
    /// exact sum elsewhere.
    ///
    /// - `tolerance`: relative to L \[1\], zero or above; below 1e-14, the allowance for rounding, every sample is exact
    ///
    /// # Errors
    /// [`Error::Value`] for a tolerance that is not finite or below zero.
    ///
    /// ```
    /// # let spring = coilsense::paper::s_t();
    /// use coilsense::inductance::{MaxwellSum, SelfDistance};
    /// let motion = coilsense::Motion::new(&spring, &coilsense::Excitation::impact(0.23, 0.25)?)?;
    /// let windings = motion.windings(&[0.0, 0.5, 1.0])?;
    /// let series = MaxwellSum::new(&spring, SelfDistance::AsPrinted).series_within(&windings, 1e-5)?;
    /// assert_eq!((series.second_order, series.exact), (3, 0));
    /// # Ok::<(), coilsense::Error>(())
    /// ```
    pub fn series_within(&self, windings: &Windings, tolerance: f64) -> Result<BoundedSeries, Error> {
        let allowed = tolerance.is_finite() && tolerance >= 0.0;
        check(allowed, "tolerance", tolerance, "", "finite and not below zero")?;
        let mut evaluation = Evaluation::new(self);
        let mut samples = Vec::with_capacity(windings.samples());
        self.for_each_block(windings, |block, alone| {
            evaluation.within(block, tolerance, alone, |_, value| samples.push(value));
        });
        let [second_order, exact] = evaluation.counts;
        Ok(BoundedSeries { samples, second_order, exact })
    }

    /// L of a motion at each time within a tolerance: as [`Self::series_within`] of [`Motion::windings`], without finding all positions first.
    ///
    /// - `times`: t \[s\], shape `samples`, in any order, none below zero; equidistant ones in order are fastest
    /// - `tolerance`: as in [`Self::series_within`]; zero takes the exact sum everywhere
    ///
    /// Source:   as [`Self::series_within`].
    /// Valid:    as [`Motion`] and [`MaxwellSum`].
    /// Accuracy: its bounds, beyond the motion's own (1e-12 of the windings' displacements).
    ///
    /// # Errors
    /// As [`Self::series_within`] and [`Motion::windings`]; [`Error::Value`] for a motion whose masses are not alike.
    ///
    /// ```
    /// # let spring = coilsense::paper::s_t();
    /// use coilsense::inductance::{MaxwellSum, SelfDistance};
    /// let motion = coilsense::Motion::new(&spring, &coilsense::Excitation::impact(0.23, 0.25)?)?;
    /// let series = MaxwellSum::new(&spring, SelfDistance::AsPrinted).along(&motion, &[0.0, 0.5, 1.0], 1e-5)?;
    /// assert_eq!((series.second_order, series.exact), (3, 0));
    /// # Ok::<(), coilsense::Error>(())
    /// ```
    pub fn along(&self, motion: &Motion, times: &[f64], tolerance: f64) -> Result<BoundedSeries, Error> {
        let allowed = tolerance.is_finite() && tolerance >= 0.0;
        check(allowed, "tolerance", tolerance, "", "finite and not below zero")?;
        let modes = motion.modes();
        let allowed = "modes of a chain of equal masses, whose windings are evenly wound";
        check(modes.is_even(), "modes", modes.count() as f64, "", allowed)?;
        let lengths = motion.lengths(times)?;
        let carry = self.carry(modes.masses());
        let carriers: Vec<_> = (0..self.places().len()).map(|turn| carry.of_turn(turn)).collect();
        let (mut evaluation, mut block) = (Evaluation::new(self), TurnBlock::new(carriers.len()));
        let mut samples = vec![BoundedInductance { inductance: 0.0, bound: 0.0 }; times.len()];
        let mut turns = Vec::with_capacity(carriers.len());
        motion.for_each_turns(times, self.places(), &carriers, |ids, displacements| {
            block.set(displacements, ids.iter().map(|&sample| lengths[sample] / self.windings()));
            let alone = |block: &TurnBlock, column: usize| {
                let length = block.pitches[column] * self.windings();
                let rows = block.displacements.chunks_exact(WIDTH).zip(self.places());
                turns.clear();
                turns.extend(rows.map(|(row, place)| place * length + row[column]));
                self.of_turns(&turns)
            };
            evaluation.within(&block, tolerance, alone, |column, value| samples[ids[column]] = value);
        })?;
        let [second_order, exact] = evaluation.counts;
        Ok(BoundedSeries { samples, second_order, exact })
    }

    /// Calls `visit` with all samples in blocks, and with what finds L of one of a block's samples turn by turn.
    pub(super) fn for_each_block(
        &self,
        windings: &Windings,
        mut visit: impl FnMut(&TurnBlock, &mut dyn FnMut(&TurnBlock, usize) -> f64),
    ) {
        let carry = self.carry(windings.count());
        let mut block = TurnBlock::new(self.places().len());
        let mut turns = Vec::with_capacity(self.places().len());
        for begin in (0..windings.samples()).step_by(WIDTH) {
            let samples = begin..windings.samples().min(begin + WIDTH);
            block.load(windings, samples, &carry, self.places(), self.windings(), &mut turns);
            visit(&block, &mut |_, column| {
                let sample = begin + column;
                self.of_turns(carry.turns(windings.ends(sample), windings.row(sample), &mut turns))
            });
        }
    }
}
