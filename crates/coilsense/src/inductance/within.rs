//! L of a series within a tolerance: to second order where that is good enough, by the exact sum elsewhere.
//!
//! Next door: the second-order form and its bound (`second_order`), the exact sum (`maxwell`).

use std::ops::Range;

use super::carry::Carry;
use super::expansion::{Expansion, LANES, Lanes};
use super::maxwell::MaxwellSum;
use super::second_order::{BoundedInductance, ROUNDING, bounded};
use crate::error::{Error, check};
use crate::motion::Windings;

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
    /// As [`Self::series`], by [`super::SecondOrder`] about each sample's own length where its bound is within `tolerance` of L, and by the
    /// exact sum elsewhere.
    ///
    /// - `tolerance`: relative to L \[1\], zero or above; below 1e-14, the allowance for rounding, every sample is exact
    ///
    /// # Errors
    /// [`Error::Value`] for a tolerance that is not finite or below zero.
    ///
    /// ```
    /// # let spring = coilsense::Spring::new(coilsense::SpringParameters { rest_length: 0.104, windings: 52.0,
    /// #     coil_radius: 0.008, wire_radius: 0.001, mass: 0.065, stiffness: 760.0, min_length: 0.196,
    /// #     max_length: 0.264, nominal_force: None, inductance_windings: None })?;
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
        let mut series = Series::new(self, windings);
        for start in (0..windings.samples()).step_by(LANES) {
            series.evaluate(start..windings.samples().min(start + LANES), tolerance);
        }
        Ok(series.result)
    }
}

/// A series in the making.
struct Series<'a> {
    coil: &'a MaxwellSum,
    windings: &'a Windings,
    carry: Carry,
    turns: Vec<f64>,
    expansion: Expansion,
    displacements: Vec<Lanes>,
    result: BoundedSeries,
}

impl<'a> Series<'a> {
    fn new(coil: &'a MaxwellSum, windings: &'a Windings) -> Self {
        let turns = coil.places().len();
        let samples = Vec::with_capacity(windings.samples());
        Self {
            coil,
            windings,
            carry: coil.carry(windings.count()),
            turns: Vec::with_capacity(turns),
            expansion: Expansion::new(turns),
            displacements: vec![[0.0; LANES]; turns],
            result: BoundedSeries { samples, second_order: 0, exact: 0 },
        }
    }

    /// At most [`LANES`] samples.
    fn evaluate(&mut self, samples: Range<usize>, tolerance: f64) {
        // Lanes without a sample keep what they hold.
        let mut pitches = self.expansion.pitches;
        for (lane, sample) in samples.clone().enumerate() {
            pitches[lane] = self.load(lane, sample) / self.coil.windings();
        }
        self.expansion.expand(self.coil, pitches);
        let near = bounded(&self.expansion, &self.displacements);
        for (mut value, sample) in near.into_iter().zip(samples) {
            if value.bound <= tolerance * value.inductance {
                self.result.second_order += 1;
            } else {
                value = self.exact(sample);
                self.result.exact += 1;
            }
            self.result.samples.push(value);
        }
    }

    /// Puts a sample's displacements from uniform into a lane; gives its length \[m\].
    fn load(&mut self, lane: usize, sample: usize) -> f64 {
        let ends = self.windings.ends(sample);
        let length = ends[1] - ends[0];
        let turns = self.carry.turns(ends, self.windings.row(sample), &mut self.turns);
        for ((lanes, turn), place) in self.displacements.iter_mut().zip(turns).zip(self.coil.places()) {
            lanes[lane] = turn - (ends[0] + place * length);
        }
        length
    }

    fn exact(&mut self, sample: usize) -> BoundedInductance {
        let (ends, row) = (self.windings.ends(sample), self.windings.row(sample));
        let inductance = self.coil.of_turns(self.carry.turns(ends, row, &mut self.turns));
        BoundedInductance { inductance, bound: ROUNDING * inductance }
    }
}
