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
    /// Resistance of each point \[Ω\], where the file has it; else empty.
    pub resistances: Vec<f64>,
    /// Rows that were read and are not in use.
    pub unused: Vec<Unused>,
    /// Row of the file from which each point was read, counted from 1; for a mean over rows, the first of them.
    pub rows: Vec<usize>,
    /// Length of the coil where the file says zero displacement \[m\]; none where it holds lengths.
    pub zero_length: Option<f64>,
    /// What was left out, cleaned or averaged, a sentence each.
    pub account: Vec<String>,
    /// Whether the file says that it is simulated.
    pub simulated: bool,
}

/// A row that is not in use.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Unused {
    /// Of the file, counted from 1.
    pub row: usize,
    /// l \[m\].
    pub length: f64,
    /// R \[Ω\], where the file has it.
    pub resistance: Option<f64>,
}

/// By how much R must fall below that of most rows for turns to be called shorted: twenty times what ten readings of the measured runs scatter by.
const SHORTED: f64 = 2e-3;

impl Measured {
    /// How far a resistance is below that of most points, where that is more than what scatters.
    pub fn shorted(&self, resistance: f64) -> Option<f64> {
        // The median, which a few rows do not move.
        let mut sorted = self.resistances.clone();
        sorted.sort_by(f64::total_cmp);
        let usual = 0.5 * (sorted.get(sorted.len() / 2)? + sorted.get((sorted.len() - 1) / 2)?);
        let share = 1.0 - resistance / usual;
        (share > SHORTED).then_some(share)
    }

    /// Points whose R says that turns touch, with the share by which it is low.
    pub fn touching(&self) -> Vec<(usize, f64)> {
        let low = self.resistances.iter().enumerate();
        low.filter_map(|(index, &resistance)| Some((index, self.shorted(resistance)?))).collect()
    }

    /// The same without points whose resistance says that turns touch, which is told.
    ///
    /// # Errors
    /// [`CalibrationError`] where fewer than two are left.
    pub(super) fn without_touching(self) -> Result<Self, CalibrationError> {
        let touching = self.touching();
        let mut account = self.account.clone();
        for unused in &self.unused {
            // Against its neighbour, as R drifts along a run by what temperature and strain do to it.
            let distance = |index: &usize| (self.points.lengths()[*index] - unused.length).abs();
            let near = (0..self.resistances.len()).min_by(|a, b| distance(a).total_cmp(&distance(b)));
            let Some((resistance, near)) = unused.resistance.zip(near) else { continue };
            let share = 1.0 - resistance / self.resistances[near];
            if share > SHORTED {
                let (row, percent, beside) = (unused.row, 100.0 * share, self.rows[near]);
                account.push(format!(
                    "Row {row}, which is left out, has its R {percent:.3} % below that of row {beside}: turns touch and short."
                ));
            }
        }
        if touching.is_empty() {
            return Ok(Self { account, ..self });
        }
        let is_kept = |index: usize| touching.iter().all(|(touches, _)| *touches != index);
        let kept: Vec<usize> = (0..self.rows.len()).filter(|&index| is_kept(index)).collect();
        let of = |values: &[f64]| kept.iter().filter_map(|&index| values.get(index).copied()).collect::<Vec<f64>>();
        let points = self.pick(&kept)?;
        let mut unused = self.unused.clone();
        for (index, share) in touching {
            let (row, percent) = (self.rows[index], 100.0 * share);
            account.push(format!(
                "Row {row} is left out: its R is {percent:.2} % below the others', so turns touch and short, or a clip moved."
            ));
            unused.push(Unused {
                row,
                length: self.points.lengths()[index],
                resistance: self.resistances.get(index).copied(),
            });
        }
        Ok(Self {
            standard_errors: of(&self.standard_errors),
            resistances: of(&self.resistances),
            rows: kept.iter().map(|&index| self.rows[index]).collect(),
            points,
            unused,
            account,
            ..self
        })
    }

    /// The points at some of their indices.
    ///
    /// # Errors
    /// As [`CalibrationPoints::new`], with the file.
    pub fn pick(&self, indices: &[usize]) -> Result<CalibrationPoints, CalibrationError> {
        let of = |values: &[f64]| indices.iter().map(|&index| values[index]).collect::<Vec<f64>>();
        Self::pairs(&self.file, &of(self.points.lengths()), &of(self.points.inductances()))
    }

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
