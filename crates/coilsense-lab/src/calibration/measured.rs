//! Measured pairs of length and inductance, and what is known of where they come from.
//!
//! Next door: who reads them (`lab_data`), what is made of them (`outcome`).

use coilsense::calibrate::CalibrationPoints;

use super::CalibrationError;

/// The pairs of a calibration, in the order of the file.
#[derive(Debug, Clone, PartialEq)]
pub struct Measured {
    /// The file, as people name it.
    pub file: String,
    /// Lengths and inductances in use.
    pub points: CalibrationPoints,
    /// Standard error of each point's inductance \[H\], where it is the mean of several readings; else empty.
    pub standard_errors: Vec<f64>,
    /// Row of the file from which each point was read, counted from 1; for a mean over rows, the first of them.
    pub rows: Vec<usize>,
    /// Length of the coil where the file says zero displacement \[m\]; none where it holds lengths.
    pub zero_length: Option<f64>,
    /// What was left out, cleaned or averaged, a sentence each.
    pub account: Vec<String>,
    /// Whether the file says that it is simulated.
    pub simulated: bool,
}

impl Measured {
    /// Pairs up what a file holds; the science's refusals get the file's name.
    pub(super) fn pairs(
        file: &str,
        lengths: &[f64],
        inductances: &[f64],
    ) -> Result<CalibrationPoints, CalibrationError> {
        CalibrationPoints::new(lengths, inductances).map_err(|error| CalibrationError::of(file, error))
    }

    /// At most so many of the points, spread evenly in the order of their lengths, the shortest and the longest among them.
    pub fn some(&self, most: usize) -> Vec<usize> {
        let lengths = self.points.lengths();
        let count = lengths.len();
        let mut order: Vec<usize> = (0..count).collect();
        if count > most {
            order.sort_by(|&a, &b| lengths[a].total_cmp(&lengths[b]));
            order = (0..most).map(|step| order[step * (count - 1) / (most - 1).max(1)]).collect();
            order.sort_unstable();
        }
        order
    }

    /// What stands on the axis of a figure and in a table: displacements where the file holds them, else lengths \[m\].
    pub fn places(&self) -> Vec<f64> {
        let zero = self.zero_length.unwrap_or(0.0);
        self.points.lengths().iter().map(|length| length - zero).collect()
    }

    /// What [`Self::places`] are: `displacement` or `length`.
    pub fn place_name(&self) -> &'static str {
        if self.zero_length.is_some() { "displacement" } else { "length" }
    }
}
