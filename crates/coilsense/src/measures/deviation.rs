//! One force series against another: the outcome measures of the paper.
//!
//! Next door: windings that touch (`clash`).

use crate::error::{Error, all_finite, at_least_one, called, check, count};
use crate::simd;

/// Sums that do not wait for each other: two of the widest vectors, on every path, so that the order of a sum is one.
const LANES: usize = 16;

/// How a series deviates from its reference; every field has the unit of the series.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Deviation {
    /// √(mean of squares): the RMSD.
    pub rmsd: f64,
    /// max(F − F_ref), with its sign.
    pub maximum: f64,
    /// max |F − F_ref|.
    pub maximum_absolute: f64,
    /// Mean of F − F_ref.
    pub mean: f64,
    /// σ/√n of F − F_ref, with σ over n − 1; zero for one sample.
    pub standard_error: f64,
}

impl Deviation {
    /// Of `force` from `reference`, both of shape `samples` and one unit.
    ///
    /// RMSD = √(Σ d²/n), d = F − F_ref; standard error = σ/√n, σ² = Σ (d − mean)²/(n − 1)
    ///
    /// Source:   `[Weijde2017]` section III-D and eq. 15.
    /// Valid:    at least one sample; the standard error assumes independent samples.
    /// Accuracy: 1e-13 of the largest deviation (plain sums).
    /// Differs:  the paper's Table III prints the signed maximum, though the text says maximum deviation; both are here.
    ///
    /// # Errors
    /// [`Error::Count`] for no samples or series of different lengths; [`Error::Value`] for the first value that is not finite.
    ///
    /// ```
    /// let deviation = coilsense::measures::Deviation::between(&[1.0, 2.0, 0.0], &[1.0, 1.0, 1.0])?;
    /// assert_eq!((deviation.maximum, deviation.maximum_absolute, deviation.mean), (1.0, 1.0, 0.0));
    /// assert!((deviation.rmsd - (2.0_f64 / 3.0).sqrt()).abs() < 1e-15);
    /// # Ok::<(), coilsense::Error>(())
    /// ```
    pub fn between(force: &[f64], reference: &[f64]) -> Result<Self, Error> {
        at_least_one("force", force.len())?;
        count("reference", reference.len(), force.len())?;
        let moments = simd::dispatch(Differences { force, reference });
        if !moments.squares.is_finite() {
            // Something is not finite, or too large to square.
            all_finite("force", force, "N")?;
            all_finite("reference", reference, "N")?;
        }
        Ok(moments.deviation(force.len() as f64))
    }

    /// The same as a share of a nominal value, for example F_nom \[N\] (1 = all of it).
    ///
    /// # Errors
    /// [`Error::Value`] for a nominal value that is not above zero.
    pub fn relative_to(&self, nominal: f64) -> Result<Self, Error> {
        let holds = nominal.is_finite() && nominal > 0.0;
        check(holds, called("nominal", "nominal force"), nominal, "N", "above zero and finite")?;
        Ok(Self {
            rmsd: self.rmsd / nominal,
            maximum: self.maximum / nominal,
            maximum_absolute: self.maximum_absolute / nominal,
            mean: self.mean / nominal,
            standard_error: self.standard_error / nominal,
        })
    }
}

/// One call of [`Deviation::between`].
struct Differences<'a> {
    force: &'a [f64],
    reference: &'a [f64],
}

/// What becomes of it.
struct Moments {
    sum: f64,
    squares: f64,
    minimum: f64,
    maximum: f64,
    /// Σ (d − mean)².
    scatter: f64,
}

impl Moments {
    fn deviation(&self, samples: f64) -> Deviation {
        let variance = self.scatter / (samples - 1.0).max(1.0);
        Deviation {
            rmsd: (self.squares / samples).sqrt(),
            maximum: self.maximum,
            maximum_absolute: self.maximum.max(-self.minimum),
            mean: self.sum / samples,
            standard_error: (variance / samples).sqrt(),
        }
    }
}

impl Differences<'_> {
    /// Calls `visit` with each difference and its lane.
    #[inline(always)]
    fn for_each(&self, mut visit: impl FnMut(usize, f64)) {
        let chunks = self.force.chunks_exact(LANES).zip(self.reference.chunks_exact(LANES));
        for (force, reference) in chunks {
            for lane in 0..LANES {
                visit(lane, force[lane] - reference[lane]);
            }
        }
        let rest = self.force.len() - self.force.len() % LANES;
        for (lane, (force, reference)) in self.force[rest..].iter().zip(&self.reference[rest..]).enumerate() {
            visit(lane, force - reference);
        }
    }
}

impl pulp::WithSimd for Differences<'_> {
    type Output = Moments;

    #[inline(always)]
    fn with_simd<S: pulp::Simd>(self, _: S) -> Moments {
        // Plain loops: the compiler turns them into the vectors that are allowed here.
        let (mut sums, mut squares, mut scatters) = ([0.0; LANES], [0.0; LANES], [0.0; LANES]);
        let (mut minima, mut maxima) = ([f64::INFINITY; LANES], [f64::NEG_INFINITY; LANES]);
        self.for_each(|lane, difference| {
            sums[lane] += difference;
            squares[lane] += difference * difference;
            minima[lane] = if difference < minima[lane] { difference } else { minima[lane] };
            maxima[lane] = if difference > maxima[lane] { difference } else { maxima[lane] };
        });
        let sum: f64 = sums.iter().sum();
        let mean = sum / self.force.len() as f64;
        self.for_each(|lane, difference| scatters[lane] += (difference - mean) * (difference - mean));
        Moments {
            sum,
            squares: squares.iter().sum(),
            minimum: minima.into_iter().fold(f64::INFINITY, f64::min),
            maximum: maxima.into_iter().fold(f64::NEG_INFINITY, f64::max),
            scatter: scatters.iter().sum(),
        }
    }
}
