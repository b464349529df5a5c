//! Measured pairs of length and inductance.
//!
//! Next door: what is fitted to them (`inverse_length`, `inductance`), how they are read from a file (`coilsense-lab`).

use crate::error::{Error, all_finite, check, count, entry, number_of};

/// Pairs of length and inductance that a fit can be made to, checked.
///
/// One pair per reading, or one per position with the mean of its readings: all pairs weigh the same.
#[derive(Debug, Clone, PartialEq)]
pub struct CalibrationPoints {
    lengths: Vec<f64>,
    inductances: Vec<f64>,
}

impl CalibrationPoints {
    /// - `lengths`: l of the coil \[m\], shape `points`, above zero; `inductances`: L \[H\], shape `points`; in any order
    ///
    /// # Errors
    /// [`Error::Count`] where the series differ in length or hold fewer than two pairs; [`Error::Value`] for a length that is not above
    /// zero and finite, an inductance that is not finite, or where all lengths or all inductances are the same.
    ///
    /// ```
    /// use coilsense::calibrate::CalibrationPoints;
    /// let error = CalibrationPoints::new(&[0.1, -0.2], &[4e-6, 3e-6]).unwrap_err();
    /// assert_eq!(error.to_string(), "lengths[1] must be above zero and finite, got -0.2 m");
    /// ```
    pub fn new(lengths: &[f64], inductances: &[f64]) -> Result<Self, Error> {
        count("inductances", inductances.len(), lengths.len())?;
        if lengths.len() < 2 {
            return Err(number_of("calibration points", lengths.len(), "at least 2"));
        }
        for (index, &length) in lengths.iter().enumerate() {
            let holds = length.is_finite() && length > 0.0;
            check(holds, entry("lengths", index), length, "m", "above zero and finite")?;
        }
        all_finite("inductances", inductances, "H")?;
        let points = Self { lengths: lengths.to_vec(), inductances: inductances.to_vec() };
        check(points.range() > 0.0, "range of the lengths", points.range(), "m", "above zero")?;
        let spread = spread(inductances);
        check(spread > 0.0, "range of the inductances", spread, "H", "above zero")?;
        Ok(points)
    }

    /// l \[m\].
    pub fn lengths(&self) -> &[f64] {
        &self.lengths
    }

    /// L \[H\].
    pub fn inductances(&self) -> &[f64] {
        &self.inductances
    }

    /// Shortest and longest length \[m\].
    pub fn ends(&self) -> [f64; 2] {
        self.lengths.iter().fold([f64::INFINITY, 0.0], |[least, most], length| [least.min(*length), most.max(*length)])
    }

    /// Longest less shortest length \[m\].
    pub fn range(&self) -> f64 {
        spread(&self.lengths)
    }

    /// 1/l \[1/m\].
    pub(super) fn inverse_lengths(&self) -> Vec<f64> {
        self.lengths.iter().map(|length| 1.0 / length).collect()
    }
}

/// Largest less smallest.
fn spread(values: &[f64]) -> f64 {
    let largest = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    largest - values.iter().copied().fold(f64::INFINITY, f64::min)
}
