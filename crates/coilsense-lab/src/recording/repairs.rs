//! A repair that touches many rows is to be said twice: that it may be made, and to how many.
//!
//! Next door: what is repaired (`cleaning`), what became of every row (`account`).

use super::account::{Account, Reason};
use super::cleaning::Cleaning;
use super::error::RecordingError;
use crate::message::{Hint, Message};

/// Share of the rows that a repair may touch where nothing is said, and so many rows whatever their share.
const MOST: f64 = 0.01;
const FEW: u64 = 10;

impl Account {
    /// Refuses repairs that touched more of the rows than may be.
    pub(super) fn check_repairs(&self, cleaning: &Cleaning) -> Result<(), RecordingError> {
        let most = cleaning.repair_up_to.unwrap_or(MOST);
        let count = |reasons: &[Reason]| -> u64 {
            reasons.iter().filter_map(|reason| self.left_out.get(reason)).map(|tally| tally.count).sum()
        };
        let incomplete = count(&[Reason::CellCount, Reason::NoNumber, Reason::TooLarge, Reason::MissingValue]);
        let filled = self.filled_values.values().map(|(count, _)| *count).max().unwrap_or(0).max(self.filled_rows);
        // Channels of their own rates are what resampling is for.
        let filled = if cleaning.resample.is_some() { 0 } else { filled };
        let all = [
            (Hint::Flag("drop_incomplete"), "leave out", incomplete, self.read),
            (Hint::Flag("sort"), "move", self.sorted, self.read),
            (Hint::Flag("merge_repeated"), "merge away", count(&[Reason::Merged]), self.read),
            (Hint::Open("fill_gaps"), "make up", filled, self.rows),
        ];
        for (hint, does, touched, of) in all {
            let share = touched as f64 / of.max(1) as f64;
            if touched <= FEW || share <= most {
                continue;
            }
            let text = format!(
                " would {does} {touched} of {of} rows, more than {} %; if that is intended, add ",
                100.0 * most
            );
            let enough = format!("{} %", (100.0 * share).ceil());
            let message = Message::from(hint) + text + Hint::Value("repair_up_to", enough);
            return Err(RecordingError::of_file(&self.file, message));
        }
        Ok(())
    }
}
