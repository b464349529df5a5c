//! Where the windings are over time.
//!
//! Next door: how they got there (the parent), whether they touch (`measures`), what they do to a coil (`inductance`).

/// Positions of both ends and of all windings over time \[m\].
#[derive(Debug, Clone, PartialEq)]
pub struct Windings {
    count: usize,
    ends: Vec<[f64; 2]>,
    positions: Vec<f64>,
}

impl Windings {
    pub(crate) fn with_capacity(count: usize, samples: usize) -> Self {
        Self {
            count,
            ends: Vec::with_capacity(samples),
            positions: Vec::with_capacity(samples * count),
        }
    }

    pub(crate) fn push(&mut self, ends: [f64; 2], row: &[f64]) {
        self.ends.push(ends);
        self.positions.extend_from_slice(row);
    }

    /// N: windings per sample.
    pub fn count(&self) -> usize {
        self.count
    }

    /// How many samples there are.
    pub fn samples(&self) -> usize {
        self.ends.len()
    }

    /// u1 and u2 of a sample, counted from zero.
    ///
    /// # Panics
    /// Where there is no such sample, as a slice does.
    pub fn ends(&self, sample: usize) -> [f64; 2] {
        self.ends[sample]
    }

    /// x_1…x_N of a sample, counted from zero; shape `N`.
    ///
    /// # Panics
    /// Where there is no such sample, as a slice does.
    pub fn row(&self, sample: usize) -> &[f64] {
        &self.positions[sample * self.count..][..self.count]
    }

    /// x_1…x_N of every sample; shape `samples × N`, row-major.
    pub fn positions(&self) -> &[f64] {
        &self.positions
    }
}
