//! One force series against another: the outcome measures of the paper.
//!
//! Next door: windings that touch (`clash`).

use crate::error::{Error, all_finite, at_least_one, check, count};

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
        all_finite("force", force, "N")?;
        all_finite("reference", reference, "N")?;
        Ok(Self::of(force.iter().zip(reference).map(|(f, r)| f - r)))
    }

    /// Of differences already taken.
    fn of(differences: impl ExactSizeIterator<Item = f64> + Clone) -> Self {
        let samples = differences.len() as f64;
        let (mut sum, mut squares) = (0.0, 0.0);
        let (mut maximum, mut minimum) = (f64::NEG_INFINITY, f64::INFINITY);
        for difference in differences.clone() {
            sum += difference;
            squares += difference * difference;
            maximum = maximum.max(difference);
            minimum = minimum.min(difference);
        }
        let mean = sum / samples;
        let scatter: f64 = differences.map(|d| (d - mean) * (d - mean)).sum();
        let variance = scatter / (samples - 1.0).max(1.0);
        Self {
            rmsd: (squares / samples).sqrt(),
            maximum,
            maximum_absolute: maximum.max(-minimum),
            mean,
            standard_error: (variance / samples).sqrt(),
        }
    }

    /// The same as a share of a nominal value, for example F_nom \[N\] (1 = all of it).
    ///
    /// # Errors
    /// [`Error::Value`] for a nominal value that is not above zero.
    pub fn relative_to(&self, nominal: f64) -> Result<Self, Error> {
        let holds = nominal.is_finite() && nominal > 0.0;
        check(holds, "nominal force", nominal, "N", "above zero and finite")?;
        Ok(Self {
            rmsd: self.rmsd / nominal,
            maximum: self.maximum / nominal,
            maximum_absolute: self.maximum_absolute / nominal,
            mean: self.mean / nominal,
            standard_error: self.standard_error / nominal,
        })
    }
}
