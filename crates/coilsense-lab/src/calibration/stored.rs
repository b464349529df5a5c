//! A calibration put into a file's table, over the lengths of its points.
//!
//! Next door: the file (`crate::stored`), the calibration (`outcome`).

use super::median::median;
use super::{CalibrationError, Outcome, answer};
use crate::stored::{Row, StoredCalibration};

/// Rows of the table: between them a cubic through four is less than 10 nm off over the 60 mm of S_T (a test in Python).
const ROWS: usize = 49;
/// How far beyond the points it reads, as a share of their range: so far that noise at an end is still read.
const MARGIN: f64 = 0.02;
/// Five runs of one spring, mounted anew, lay 10 nH of 3.4 µH about their mean.
const REMOUNTING: f64 = 0.0025;

impl StoredCalibration {
    /// The table of a calibration that was made.
    ///
    /// # Errors
    /// [`CalibrationError`] where L does not fall with length from row to row, or a length is not read back.
    pub fn of(outcome: &Outcome) -> Result<Self, CalibrationError> {
        let (measured, taken) = (&outcome.measured, &outcome.taken);
        let margin = MARGIN * measured.points.range();
        let reaches = |length: f64, otherwise: f64| match taken.inductance(length).is_finite() && length > 0.0 {
            true => length,
            false => otherwise,
        };
        let [least, most] = measured.points.ends();
        let (shortest, longest) = (reaches(least - margin, least), reaches(most + margin, most));
        // Of a curve that does not tell its own, what it was found off by where points are left.
        let seen = taken.has_others().then_some(taken.rms_share * measured.points.range());
        let row = |index: usize| {
            let length = shortest + (longest - shortest) * index as f64 / (ROWS - 1) as f64;
            let inductance = taken.inductance(length);
            let length_u = taken.length_u(inductance).or(seen);
            Row { inductance, length, length_u }
        };
        let told = answer(outcome);
        let stored = Self {
            name: measured.file.clone(),
            relation: outcome.plan.relation.name().to_owned(),
            about: told.first().cloned().unwrap_or_default(),
            // Zeroed since at a point that was told.
            remounting: if outcome.plan.re_zero.is_some() { 0.0 } else { REMOUNTING },
            shift: 0.0,
            resistance: median(measured.resistances.iter().copied()),
            force: outcome.plan.force,
            rows: (0..ROWS).map(row).collect(),
        };
        Ok(stored.checked()?)
    }
}
