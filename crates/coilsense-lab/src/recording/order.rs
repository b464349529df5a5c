//! The second stage: rows in the order of their times, and one of each time.
//!
//! Next door: times and the window (`clock`), missing values (`complete`), gaps and rates (`spacing`).

use std::path::PathBuf;

use super::account::{Account, Reason};
use super::cleaning::Cleaning;
use super::error::{RecordingError, window};
use super::row::{Onward, Row};
use crate::message::{Hint, Message};

/// Sorts rows and merges those of one time where it may.
pub(super) struct Order {
    file: PathBuf,
    cleaning: Cleaning,
    /// Rows of the same time, as sums; how many values each sum has.
    open: Option<(Row, Vec<u32>)>,
    /// Time of the row before; while rows are collected to be sorted, the last of all.
    last: f64,
    /// All rows, where they are to be sorted.
    all: Vec<Row>,
}

/// Most numbers that are held in memory: 1.6 GB.
pub(super) const MOST_NUMBERS: usize = 200_000_000;

impl Order {
    pub fn new(file: PathBuf, cleaning: Cleaning) -> Self {
        Self { file, cleaning, open: None, last: f64::NEG_INFINITY, all: Vec::new() }
    }

    pub fn push(&mut self, row: Row, account: &mut Account, onward: &mut Onward<'_>) -> Result<(), RecordingError> {
        if !self.cleaning.sort {
            return self.in_order(row, account, onward);
        }
        if (self.all.len() + 1) * (row.values.len() + 4) > MOST_NUMBERS {
            let message = Message::from("has too many rows to be sorted in memory; take a part of it by ") + window();
            return Err(RecordingError::of_file(&self.file, message));
        }
        if row.time < self.last {
            account.sorted += 1;
        }
        self.last = self.last.max(row.time);
        self.all.push(row);
        Ok(())
    }

    /// Lets the last rows go.
    pub fn finish(&mut self, account: &mut Account, onward: &mut Onward<'_>) -> Result<(), RecordingError> {
        let mut all = std::mem::take(&mut self.all);
        self.last = f64::NEG_INFINITY;
        all.sort_by(|a, b| a.time.total_cmp(&b.time));
        for row in all {
            self.in_order(row, account, onward)?;
        }
        self.close(account, onward)
    }

    fn in_order(&mut self, row: Row, account: &mut Account, onward: &mut Onward<'_>) -> Result<(), RecordingError> {
        let before = std::mem::replace(&mut self.last, row.time);
        if !self.cleaning.merge_repeated {
            if row.time > before {
                return onward(row, account);
            }
            // Rows of one time were not neighbours before they were sorted.
            let message = Message::from(format!("time {before} s is there again; "))
                + Hint::Flag("merge_repeated")
                + " takes the mean of such rows";
            return Err(RecordingError::of_line(&self.file, row.line, message));
        }
        match &mut self.open {
            Some((open, counts)) if row.time == before => {
                for ((sum, count), value) in open.values.iter_mut().zip(counts.iter_mut()).zip(row.values) {
                    if !value.is_nan() {
                        *sum = if *count == 0 { value } else { *sum + value };
                        *count += 1;
                    }
                }
                account.leave_out(Reason::Merged, row.line);
            }
            _ => {
                self.close(account, onward)?;
                let counts = row.values.iter().map(|value| u32::from(!value.is_nan())).collect();
                self.open = Some((row, counts));
            }
        }
        Ok(())
    }

    fn close(&mut self, account: &mut Account, onward: &mut Onward<'_>) -> Result<(), RecordingError> {
        let Some((mut row, counts)) = self.open.take() else { return Ok(()) };
        for (sum, count) in row.values.iter_mut().zip(counts) {
            if count > 1 {
                *sum /= f64::from(count);
            }
        }
        onward(row, account)
    }
}
