//! Means with their standard errors, by eq. (15) and by blocks.
//!
//! Next door: what they are means of (`fast`, `slow`).

/// A mean force.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Mean {
    /// \[N\].
    pub mean: f64,
    /// σ/√n over all samples, eq. (15) \[N\].
    pub standard_error: f64,
    /// The same over the means of blocks of whole periods, in which a sine is no scatter and neighbouring samples may depend on each other
    /// \[N\]; none with fewer than ten blocks.
    pub block_error: Option<f64>,
    /// n.
    pub samples: usize,
}

/// Fewer blocks tell too little of their scatter.
const LEAST_BLOCKS: usize = 10;

impl Mean {
    /// Of samples that are independent.
    pub(super) fn of(values: &[f64]) -> Self {
        let (mean, standard_error) = mean_and_error(values);
        Self { mean, standard_error, block_error: None, samples: values.len() }
    }

    /// Of samples at `times` \[s\], in blocks of a length \[s\].
    pub(super) fn in_blocks(times: &[f64], values: &[f64], length: f64) -> Self {
        let begin = times.first().copied().unwrap_or(0.0);
        // A sample that rounding puts a hair before its block still belongs to it.
        let block = |time: f64| ((time - begin) / length + 1e-9).floor() as usize;
        let mut means: Vec<f64> = Vec::new();
        let (mut first, mut lengths) = (0, Vec::new());
        while first < values.len() {
            let own = block(times[first]);
            let count = times[first..].iter().take_while(|&&time| block(time) == own).count();
            means.push(values[first..first + count].iter().sum::<f64>() / count as f64);
            lengths.push(count);
            first += count;
        }
        // A last block that was cut short has a sine's part of a period in it.
        let usual = lengths.first().copied().unwrap_or(0);
        if lengths.last().is_some_and(|last| 10 * last < 9 * usual) {
            means.pop();
        }
        let block_error = (means.len() >= LEAST_BLOCKS).then(|| mean_and_error(&means).1);
        Self { block_error, ..Self::of(values) }
    }

    /// The error to judge by: that of blocks, where there is one.
    pub fn judged_error(&self) -> f64 {
        self.block_error.unwrap_or(self.standard_error)
    }
}

/// Mean and σ/√n, σ over n − 1; zero for a single value.
fn mean_and_error(values: &[f64]) -> (f64, f64) {
    let count = values.len() as f64;
    let mean = values.iter().sum::<f64>() / count;
    let squares: f64 = values.iter().map(|value| (value - mean) * (value - mean)).sum();
    (mean, (squares / (count - 1.0).max(1.0) / count).sqrt())
}
