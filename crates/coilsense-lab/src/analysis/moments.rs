//! What is kept of an error over time.
//!
//! Next door: who finds it (`trial_run`), how it changes from spring to spring (`response`).

/// Mean and spread of an error over time.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(super) struct Moments {
    /// Mean \[N\].
    pub mean: f64,
    /// Variance about it \[N²\].
    pub variance: f64,
}

impl Moments {
    pub fn of(errors: &[f64]) -> Self {
        let count = errors.len().max(1) as f64;
        let mean = errors.iter().sum::<f64>() / count;
        Self { mean, variance: errors.iter().map(|error| (error - mean).powi(2)).sum::<f64>() / count }
    }

    /// Mean square \[N²\].
    pub fn square(&self) -> f64 {
        self.variance + self.mean * self.mean
    }
}
