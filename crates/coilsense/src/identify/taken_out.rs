//! Lines that are taken out of a series wherever it is read, so that no copy of it is kept.
//!
//! Next door: which ones (`weak_lines`), the series (`ringing`).

use std::sync::Arc;

use nalgebra::{DMatrix, DVector};

/// Decaying lines after hits, as they are taken out of a series.
#[derive(Debug)]
pub(super) struct TakenOut {
    /// e^(λn) of each line as cosine and sine; shape `samples after a hit` of `2 lines`.
    shapes: Arc<DMatrix<f64>>,
    /// First sample, how many, and each shape's amplitude \[N\]; first to last.
    stretches: Vec<(usize, usize, DVector<f64>)>,
}

impl TakenOut {
    /// Nothing yet, of lines of these shapes.
    pub(super) fn of(shapes: &Arc<DMatrix<f64>>) -> Self {
        Self { shapes: shapes.clone(), stretches: Vec::new() }
    }

    /// And what rings in `length` samples from `start` on.
    pub(super) fn after_hit(&mut self, start: usize, length: usize, amplitudes: DVector<f64>) {
        self.stretches.push((start, length, amplitudes));
    }

    /// Takes them out of values that begin with sample `first`.
    pub(super) fn subtract(&self, first: usize, values: &mut [f64]) {
        let end = first + values.len();
        for (start, length, amplitudes) in &self.stretches {
            let (from, to) = (first.max(*start), end.min(start + length));
            if from < to {
                let rings = self.shapes.rows(from - start, to - from) * amplitudes;
                values[from - first..to - first]
                    .iter_mut()
                    .zip(rings.iter())
                    .for_each(|(value, rings)| *value -= rings);
            }
        }
    }
}
