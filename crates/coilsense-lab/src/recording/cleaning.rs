//! What the user lets us clean.
//!
//! Next door: how it is done (`order`, `complete`, `spacing`).

/// What may be cleaned. By default nothing: then what is wrong is an error that names the repair.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Cleaning {
    /// Leave out rows that lack a value, or cannot be read.
    pub drop_incomplete: bool,
    /// Put rows into the order of their times.
    pub sort: bool,
    /// Take the mean of rows that have the same time.
    pub merge_repeated: bool,
    /// Fill gaps and missing values up to this length \[s\] along straight lines.
    pub fill_gaps: Option<f64>,
    /// Bring all channels to this constant rate \[Hz\] along straight lines.
    pub resample: Option<f64>,
    /// Count on where midnight passes or a counter rolls over.
    pub unwrap: bool,
    /// Share of the rows that a repair may touch; without it one in a hundred.
    pub repair_up_to: Option<f64>,
    /// Leave out what is before this time \[s\].
    pub from: Option<f64>,
    /// Leave out what is after this time \[s\].
    pub to: Option<f64>,
}

impl Cleaning {
    /// Whether a missing value may be filled along a straight line of this length \[s\].
    pub(super) fn bridges(&self, length: f64) -> bool {
        self.fill_gaps.map_or(self.resample.is_some(), |longest| length <= longest * (1.0 + 1e-9))
    }
}
