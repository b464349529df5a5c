//! The last stage: steps of time are measured, gaps filled, and channels brought to a constant rate.
//!
//! Next door: times that rise (`order`), missing values (`complete`).

use std::path::PathBuf;

use super::account::Account;
use super::cleaning::Cleaning;
use super::error::RecordingError;
use super::row::{Onward, Row, between};
use super::telling::{hertz, seconds};
use crate::message::{Hint, Message};

/// Measures steps of time; fills gaps and resamples where it may.
pub(super) struct Spacing {
    file: PathBuf,
    cleaning: Cleaning,
    /// The first rows, of which the usual step is the median.
    head: Vec<Row>,
    interval: Option<f64>,
    last: Option<Row>,
    /// Number of the next sample at the constant rate.
    sample: Option<f64>,
}

/// So many rows tell the usual step of time.
pub(super) const HEAD: usize = 1025;
/// A step of more than so many usual ones is a gap.
pub(super) const GAP: f64 = 1.5;
/// Most rows that resampling makes in one gap without being told of its length.
const MOST_UNTOLD: f64 = 1e6;
/// Most rows that come out of one log.
const MOST_ROWS: f64 = 1e9;
/// A time this close to a sample, in samples, is that sample.
const CLOSE: f64 = 1e-6;

impl Spacing {
    pub fn new(file: PathBuf, cleaning: Cleaning) -> Self {
        Self { file, cleaning, head: Vec::new(), interval: None, last: None, sample: None }
    }

    pub fn push(&mut self, row: Row, account: &mut Account, onward: &mut Onward<'_>) -> Result<(), RecordingError> {
        if self.interval.is_some() {
            return self.step(row, account, onward);
        }
        self.head.push(row);
        if self.head.len() == HEAD { self.settle(account, onward) } else { Ok(()) }
    }

    /// Lets the last rows go.
    pub fn finish(&mut self, account: &mut Account, onward: &mut Onward<'_>) -> Result<(), RecordingError> {
        self.settle(account, onward)?;
        let Some(last) = self.last.take() else { return Ok(()) };
        match (self.cleaning.resample, self.sample) {
            (Some(rate), Some(sample)) if sample <= last.time * rate + CLOSE => {
                emit(Row { time: sample / rate, ..last }, account, onward)
            }
            _ => Ok(()),
        }
    }

    /// Finds the usual step, and lets the first rows go.
    fn settle(&mut self, account: &mut Account, onward: &mut Onward<'_>) -> Result<(), RecordingError> {
        let head = std::mem::take(&mut self.head);
        if self.interval.is_none() {
            let mut steps: Vec<f64> = head.windows(2).map(|pair| pair[1].time - pair[0].time).collect();
            steps.sort_by(f64::total_cmp);
            let interval = steps.get(steps.len().saturating_sub(1) / 2).copied();
            self.interval = Some(interval.unwrap_or(f64::INFINITY));
            account.interval = interval;
            if let (Some(rate), Some(own)) = (self.cleaning.resample, interval.map(f64::recip)) {
                account.resampled = Some(rate);
                if rate < 0.99 * own {
                    account.notes.push(format!(
                        "resampling to {} is below its {} a second: nothing filters what is above {}, which is now folded below it",
                        hertz(rate),
                        hertz(own),
                        hertz(rate / 2.0)
                    ));
                }
            }
        }
        head.into_iter().try_for_each(|row| self.step(row, account, onward))
    }

    fn step(&mut self, row: Row, account: &mut Account, onward: &mut Onward<'_>) -> Result<(), RecordingError> {
        // Values are kept only where something is to be put between two rows.
        let between = self.cleaning.resample.is_some() || self.cleaning.fill_gaps.is_some();
        let values = if between { row.values.clone() } else { Vec::new() };
        let Some(last) = self.last.replace(Row { line: row.line, time: row.time, values }) else {
            if let Some(rate) = self.cleaning.resample {
                // Zero is added so that -0 becomes 0.
                self.sample = Some((row.time * rate - CLOSE).ceil() + 0.0);
                return Ok(());
            }
            return emit(row, account, onward);
        };
        let length = row.time - last.time;
        let usual = self.interval.unwrap_or(length);
        let [least, largest] = account.steps.unwrap_or([length; 2]);
        account.steps = Some([least.min(length), largest.max(length)]);
        let is_gap = length > GAP * usual;
        if is_gap {
            if account.gaps.count == 0 {
                account.gaps.line = row.line;
            }
            account.gaps.count += 1;
            account.gaps.longest = account.gaps.longest.max(length);
        }
        match self.cleaning.resample {
            Some(rate) => self.resample(rate, &last, &row, is_gap, account, onward),
            None => {
                if is_gap && self.cleaning.bridges(length) {
                    self.fill(&last, &row, usual, account, onward)?;
                }
                emit(row, account, onward)
            }
        }
    }

    /// Rows in the gap from `last` to `next`, on straight lines.
    fn fill(
        &self,
        last: &Row,
        next: &Row,
        usual: f64,
        account: &mut Account,
        onward: &mut Onward<'_>,
    ) -> Result<(), RecordingError> {
        let steps = ((next.time - last.time) / usual).round();
        self.check_rows(account.rows as f64 + steps)?;
        for step in 1..steps as u64 {
            let time = last.time + (next.time - last.time) * (step as f64 / steps);
            emit(interpolated(last, next, time), account, onward)?;
            account.filled_rows += 1;
        }
        Ok(())
    }

    fn resample(
        &mut self,
        rate: f64,
        last: &Row,
        next: &Row,
        is_gap: bool,
        account: &mut Account,
        onward: &mut Onward<'_>,
    ) -> Result<(), RecordingError> {
        let length = next.time - last.time;
        if is_gap && !self.cleaning.bridges(length) {
            let most = seconds(self.cleaning.fill_gaps.unwrap_or(0.0));
            let message = Message::from(format!("a gap of {} is before it, longer than ", seconds(length)))
                + Hint::Value("fill_gaps", most)
                + "; take the part before or after by "
                + Hint::Open("to")
                + " or "
                + Hint::Open("from");
            return Err(RecordingError::of_line(&self.file, next.line, message));
        }
        if is_gap && self.cleaning.fill_gaps.is_none() && length * rate > MOST_UNTOLD {
            let message = Message::from(format!(
                "a gap of {} is before it, over which {:.0} rows would be made up; if that is intended, add ",
                seconds(length),
                length * rate
            )) + Hint::Value("fill_gaps", format!("{} s", length.ceil()));
            return Err(RecordingError::of_line(&self.file, next.line, message));
        }
        let mut sample = self.sample.unwrap_or(0.0);
        self.check_rows(account.rows as f64 + length * rate)?;
        while sample < next.time * rate - CLOSE {
            emit(interpolated(last, next, sample / rate), account, onward)?;
            sample += 1.0;
        }
        self.sample = Some(sample);
        Ok(())
    }

    fn check_rows(&self, rows: f64) -> Result<(), RecordingError> {
        if rows <= MOST_ROWS {
            return Ok(());
        }
        Err(RecordingError::of_file(
            &self.file,
            format!("would become {rows:.1e} rows; at most {MOST_ROWS:e} are made"),
        ))
    }
}

fn interpolated(last: &Row, next: &Row, time: f64) -> Row {
    let value = |(from, to): (&f64, &f64)| between((last.time, *from), (next.time, *to), time);
    Row { line: next.line, time, values: last.values.iter().zip(&next.values).map(value).collect() }
}

fn emit(row: Row, account: &mut Account, onward: &mut Onward<'_>) -> Result<(), RecordingError> {
    account.rows += 1;
    account.span = Some([account.span.map_or(row.time, |[from, _]| from), row.time]);
    onward(row, account)
}
