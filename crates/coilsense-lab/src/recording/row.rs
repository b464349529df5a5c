//! A row of SI values on its way through the cleaning.
//!
//! Next door: the stages (`order`, `complete`, `spacing`).

use super::account::Account;
use super::error::RecordingError;

/// A row in SI: its line, time and one value per channel, NaN where one is missing.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Row {
    pub line: u64,
    pub time: f64,
    pub values: Vec<f64>,
}

/// Where a stage sends its rows.
pub(super) type Onward<'a> = dyn FnMut(Row, &mut Account) -> Result<(), RecordingError> + 'a;

/// The value at `time` on the straight line from one point to another.
pub(super) fn between(from: (f64, f64), to: (f64, f64), time: f64) -> f64 {
    let share = (time - from.0) / (to.0 - from.0);
    from.1 + share * (to.1 - from.1)
}
