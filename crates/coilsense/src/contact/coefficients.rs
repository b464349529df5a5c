//! Power series of many values over one step, side by side.
//!
//! Next door: a single one (`polynomial`), what finds them (`series`).

use super::polynomial::{ORDER, Polynomial};

/// Coefficients order by order, a row of all values for each: shape `ORDER + 1, width`.
pub(super) struct Coefficients {
    width: usize,
    all: Vec<f64>,
}

impl Coefficients {
    /// All zero.
    pub fn new(width: usize) -> Self {
        Self { width, all: vec![0.0; (ORDER + 1) * width] }
    }

    /// Those of one order.
    pub fn row(&self, order: usize) -> &[f64] {
        &self.all[order * self.width..][..self.width]
    }

    /// The same, to be written.
    pub fn row_mut(&mut self, order: usize) -> &mut [f64] {
        &mut self.all[order * self.width..][..self.width]
    }

    /// Those of one order, and those of the next but one to be written.
    pub fn row_and_next_but_one(&mut self, order: usize) -> (&[f64], &mut [f64]) {
        let (found, next) = self.all.split_at_mut((order + 2) * self.width);
        (&found[order * self.width..][..self.width], &mut next[..self.width])
    }

    fn rows(&self) -> std::slice::ChunksExact<'_, f64> {
        self.all.chunks_exact(self.width)
    }

    /// One of the series.
    pub fn of(&self, index: usize) -> Polynomial {
        let mut series = [0.0; ORDER + 1];
        // By places, for each time that a slice is cut into chunks costs a division.
        for (order, value) in series.iter_mut().enumerate() {
            *value = self.all[order * self.width + index];
        }
        series
    }

    /// By how much the second of two is above the first.
    pub fn difference(&self, first: usize, second: usize) -> Polynomial {
        let mut difference = [0.0; ORDER + 1];
        for (order, value) in difference.iter_mut().enumerate() {
            let row = order * self.width;
            *value = self.all[row + second] - self.all[row + first];
        }
        difference
    }

    /// All values at τ.
    pub fn at(&self, tau: f64, values: &mut [f64]) {
        values.fill(0.0);
        for row in self.rows().rev() {
            for (value, coefficient) in values.iter_mut().zip(row) {
                *value = *value * tau + coefficient;
            }
        }
    }

    /// All rates of a step that lasts `step` at τ.
    pub fn rates_at(&self, tau: f64, step: f64, rates: &mut [f64]) {
        rates.fill(0.0);
        for (order, row) in self.rows().enumerate().skip(1).rev() {
            let per_time = order as f64 / step;
            for (rate, coefficient) in rates.iter_mut().zip(row) {
                *rate = *rate * tau + per_time * coefficient;
            }
        }
    }

    /// All values at τ and their rates by τ.
    pub fn with_rates(&self, tau: f64, values: &mut [f64], rates: &mut [f64]) {
        let begun = self.with_rates_of::<8>(0, tau, values, rates);
        let begun = self.with_rates_of::<4>(begun, tau, values, rates);
        self.with_rates_of::<1>(begun, tau, values, rates);
    }

    /// The same from `first` on, so many side by side as long as there are; the next one then.
    fn with_rates_of<const MANY: usize>(
        &self,
        mut first: usize,
        tau: f64,
        values: &mut [f64],
        rates: &mut [f64],
    ) -> usize {
        let rows = self.rows();
        while let Some((values, rates)) =
            values[first..].first_chunk_mut::<MANY>().zip(rates[first..].first_chunk_mut::<MANY>())
        {
            // Kept here, they need not go through memory from row to row.
            let (mut sums, mut slopes) = ([0.0; MANY], [0.0; MANY]);
            for row in rows.clone().rev() {
                for ((sum, slope), coefficient) in sums.iter_mut().zip(&mut slopes).zip(&row[first..first + MANY]) {
                    *slope = *slope * tau + *sum;
                    *sum = *sum * tau + coefficient;
                }
            }
            (*values, *rates) = (sums, slopes);
            first += MANY;
        }
        first
    }

    /// Adds to `least` all by which the differences of values can fall from order 1 on. `ends`: the two of the first difference; each further one is
    /// of the next two.
    pub fn add_falls(&self, ends: [usize; 2], least: &mut [f64]) {
        let begun = self.add_falls_of::<8>(ends, 0, least);
        let begun = self.add_falls_of::<4>(ends, begun, least);
        self.add_falls_of::<1>(ends, begun, least);
    }

    fn add_falls_of<const MANY: usize>(
        &self,
        [first, second]: [usize; 2],
        mut number: usize,
        least: &mut [f64],
    ) -> usize {
        let rows = self.rows().skip(1);
        while let Some(least) = least[number..].first_chunk_mut::<MANY>() {
            let mut sums = *least;
            for row in rows.clone() {
                let both = row[first + number..][..MANY].iter().zip(&row[second + number..][..MANY]);
                for (sum, (before, after)) in sums.iter_mut().zip(both) {
                    *sum += (after - before).min(0.0);
                }
            }
            *least = sums;
            number += MANY;
        }
        number
    }

    /// The same for differences of any two.
    pub fn add_falls_between(&self, ends: impl Iterator<Item = [usize; 2]> + Clone, least: &mut [f64]) {
        for row in self.rows().skip(1) {
            for (least, [first, second]) in least.iter_mut().zip(ends.clone()) {
                *least += (row[second] - row[first]).min(0.0);
            }
        }
    }
}
