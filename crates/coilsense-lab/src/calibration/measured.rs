//! Measured pairs of length and inductance, and what is known of where they come from.
//!
//! Next door: who reads them (`lab_data`), what is made of them (`outcome`).

use coilsense::calibrate::CalibrationPoints;

use super::CalibrationError;
use super::median::median;

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
/// Most rows that are told one by one.
const NAMED: usize = 5;

/// A point whose R is low, and the share by which it is.
type Low = (usize, f64);

impl Measured {
    /// Points at the short end whose R says that turns touch, with the share by which it is below that of most, and others whose R is as low.
    ///
    /// A drift of R along the run is none: R has to jump by as much to the next longer point.
    fn low(&self) -> [Vec<Low>; 2] {
        let Some(usual) = median(self.resistances.iter().copied()) else { return [Vec::new(), Vec::new()] };
        let share = |index: usize| 1.0 - self.resistances[index] / usual;
        let lengths = self.points.lengths();
        let mut order: Vec<usize> = (0..self.resistances.len()).collect();
        order.sort_by(|&a, &b| lengths[a].total_cmp(&lengths[b]));
        let clear = order.iter().position(|&index| share(index) <= SHORTED).unwrap_or(0);
        let jumps = clear > 0 && self.resistances[order[clear - 1]] < (1.0 - SHORTED) * self.resistances[order[clear]];
        let touching = if jumps { clear } else { 0 };
        let told = |indices: &[usize]| indices.iter().map(|&index| (index, share(index))).collect::<Vec<Low>>();
        let (short, rest) = order.split_at(touching);
        [told(short), told(rest).into_iter().filter(|(_, share)| *share > SHORTED).collect()]
    }

    /// Rows of some points: the first few by their numbers.
    fn named(&self, points: &[Low]) -> String {
        let mut rows: Vec<usize> = points.iter().map(|(index, _)| self.rows[*index]).collect();
        rows.sort_unstable();
        let first: Vec<String> = rows.iter().take(NAMED).map(usize::to_string).collect();
        match (rows.len(), rows.len().saturating_sub(NAMED)) {
            (1, _) => format!("Row {}", first[0]),
            (_, 0) => format!("Rows {}", first.join(", ")),
            (_, more) => format!("Rows {} and {more} more", first.join(", ")),
        }
    }

    /// The same without points whose resistance says that turns touch, which is told.
    ///
    /// # Errors
    /// [`CalibrationError`] where fewer than two are left.
    pub(super) fn without_touching(self) -> Result<Self, CalibrationError> {
        let [touching, low] = self.low();
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
        let most = |points: &[Low]| 100.0 * points.iter().map(|(_, share)| *share).fold(0.0, f64::max);
        if !low.is_empty() {
            account.push(format!(
                "{}: R is up to {:.2} % below the others'; a clip may have moved there, or the wire cooled. Kept.",
                self.named(&low),
                most(&low)
            ));
        }
        if touching.is_empty() {
            return Ok(Self { account, ..self });
        }
        let (verb, its) = if touching.len() == 1 { ("is", "its R is") } else { ("are", "their R is up to") };
        account.push(format!(
            "{} {verb} left out: {its} {:.2} % below the others', so turns touch and short there.",
            self.named(&touching),
            most(&touching)
        ));
        let mut is_kept = vec![true; self.rows.len()];
        touching.iter().for_each(|(index, _)| is_kept[*index] = false);
        let kept: Vec<usize> = (0..self.rows.len()).filter(|&index| is_kept[index]).collect();
        let of = |values: &[f64]| kept.iter().filter_map(|&index| values.get(index).copied()).collect::<Vec<f64>>();
        let points = self.pick(&kept)?;
        let unused = touching.iter().map(|&(index, _)| Unused {
            row: self.rows[index],
            length: self.points.lengths()[index],
            resistance: self.resistances.get(index).copied(),
        });
        let unused = self.unused.iter().copied().chain(unused).collect();
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
