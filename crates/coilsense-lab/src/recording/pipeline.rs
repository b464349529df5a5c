//! From a source's rows to SI rows on one rising clock.
//!
//! Next door: the stages (`order`, `complete`, `spacing`), where rows come from (`source`), where they go (`mod`).

use coilsense::Channel;

use super::account::{Account, Reason};
use super::cleaning::Cleaning;
use super::complete::Complete;
use super::error::{RecordingError, leave_out};
use super::mapping::Mapping;
use super::order::Order;
use super::quantity::Quantity;
use super::row::{Onward, Row};
use super::selection::{Selection, Slot};
use super::source::{Next, Source};
use super::spacing::Spacing;
use crate::message::{Hint, Message};

/// A source whose rows are read as SI values of the columns that are taken.
pub(super) struct Rows<'a> {
    source: &'a mut dyn Source,
    selection: Selection,
    mapping: &'a Mapping,
    cleaning: &'a Cleaning,
    cells: Vec<f64>,
    /// What became of the rows.
    pub account: Account,
}

/// Hears how much of how much is done; says whether to go on.
pub type Watch<'a> = dyn Fn(u64, u64) -> bool + 'a;

/// It hears so every so many rows.
const WATCHED: u64 = 4096;

/// A row's line, its time where there is a column of it, and one value per channel.
pub(super) struct Reading {
    pub line: u64,
    /// Its number, from 0, among all rows that are not skipped.
    pub index: u64,
    pub time: Option<f64>,
    pub values: Vec<f64>,
}

impl<'a> Rows<'a> {
    pub fn of(
        source: &'a mut dyn Source,
        mapping: &'a Mapping,
        cleaning: &'a Cleaning,
    ) -> Result<Self, RecordingError> {
        let mut selection = Selection::of(source.file(), source.titles(), mapping)?;
        if mapping.format.sample_rate.is_some() && selection.has_time() {
            selection.slots.remove(0);
        }
        let account = Account {
            file: source.file().to_owned(),
            description: source.description(),
            taken: selection.taken(source.titles()),
            not_taken: not_taken(source, &selection),
            notes: super::simulated(source.remarks())
                .map(|remark| format!("its header says: {remark}"))
                .into_iter()
                .collect(),
            ..Account::default()
        };
        Ok(Self { source, selection, mapping, cleaning, cells: Vec::new(), account })
    }

    /// The channels that are taken, in order.
    pub fn channels(&self) -> Vec<Channel> {
        let channel = |slot: &Slot| match slot.quantity {
            Quantity::Channel(channel) => Some(channel),
            Quantity::Time => None,
        };
        self.selection.slots.iter().filter_map(channel).collect()
    }

    /// The next row that can be read; what cannot is left out where that is allowed.
    pub fn next(&mut self) -> Result<Option<Reading>, RecordingError> {
        loop {
            let next = self.source.next(&self.selection.wanted, &mut self.cells)?;
            let (Next::Row(line) | Next::Broken { line, .. }) = next else { return Ok(None) };
            self.account.read += 1;
            if self.account.read <= self.mapping.format.skip {
                self.account.leave_out(Reason::Skipped, line);
                continue;
            }
            let read = match next {
                Next::Broken { reason, message, .. } => Err((reason, message)),
                _ => self.reading(line),
            };
            match read {
                Ok(reading) => return Ok(Some(reading)),
                Err((reason, _)) if self.cleaning.drop_incomplete => self.account.leave_out(reason, line),
                Err((_, message)) => {
                    let message = Message::from(message) + "; " + leave_out();
                    return Err(RecordingError::of_line(self.source.file(), line, message));
                }
            }
        }
    }

    fn reading(&self, line: u64) -> Result<Reading, (Reason, String)> {
        let index = self.account.read - 1 - self.mapping.format.skip;
        let mut reading = Reading { line, index, time: None, values: Vec::with_capacity(self.selection.slots.len()) };
        for slot in &self.selection.slots {
            let value = slot.value(&self.cells);
            let (name, largest) = (slot.quantity.name(), slot.quantity.largest());
            if value.abs() > largest {
                let unit = slot.quantity.dimension().si_unit();
                let message = format!("{name} = {value:e} {unit}: must be from {:e} to {largest:e} {unit}", -largest);
                return Err((Reason::TooLarge, message));
            }
            match slot.quantity {
                Quantity::Time if value.is_nan() => return Err((Reason::MissingValue, "time has no value".to_owned())),
                Quantity::Time => reading.time = Some(value),
                Quantity::Channel(_) => reading.values.push(value),
            }
        }
        Ok(reading)
    }

    /// Runs every row through the cleaning; `onward` gets complete rows on a rising clock. `watch` hears now and then how much of how much is
    /// done, and says whether to go on.
    pub fn clean(mut self, watch: &Watch<'_>, onward: &mut Onward<'_>) -> Result<Account, RecordingError> {
        let file = self.source.file().to_owned();
        let rate = self.mapping.format.sample_rate;
        if !self.selection.has_time() && rate.is_none() {
            let message = Message::from("no column is known as the time; say which it is, as in ")
                + Hint::Column("time", "#1 [s]".to_owned())
                + ", or how often it was sampled by "
                + Hint::Open("sample_rate");
            return Err(RecordingError::of_file(&file, message));
        }
        let names = self.channels().iter().map(|channel| channel.name()).collect();
        let mut order = Order::new(file.clone(), *self.cleaning);
        let mut complete = Complete::new(file.clone(), *self.cleaning, names);
        let mut spacing = Spacing::new(file.clone(), *self.cleaning);
        while let Some(reading) = self.next()? {
            let [done, of] = self.source.progress();
            if self.account.read.is_multiple_of(WATCHED) && !watch(done, of) {
                return Err(RecordingError::of_file(&file, "the import was interrupted"));
            }
            let time = reading.time.or(rate.map(|rate| reading.index as f64 / rate)).unwrap_or(0.0);
            let row = Row { line: reading.line, time, values: reading.values };
            order.push(row, &mut self.account, &mut |row, account| {
                complete.push(row, account, &mut |row, account| spacing.push(row, account, onward))
            })?;
        }
        let mut account = self.account;
        order.finish(&mut account, &mut |row, account| {
            complete.push(row, account, &mut |row, account| spacing.push(row, account, onward))
        })?;
        complete.finish(&mut account, &mut |row, account| spacing.push(row, account, onward))?;
        spacing.finish(&mut account, onward)?;
        if account.rows == 0 {
            return Err(RecordingError::of_file(&file, nothing_left(&account)));
        }
        Ok(account)
    }
}

/// Why no row is left.
pub(super) fn nothing_left(account: &Account) -> String {
    let reasons: Vec<String> =
        account.left_out.iter().map(|(reason, tally)| format!("{} {}", tally.count, reason.words())).collect();
    match reasons.is_empty() {
        true => "has no rows".to_owned(),
        false => format!("none of its {} rows is left: {}", account.read, reasons.join(", ")),
    }
}

fn not_taken(source: &dyn Source, selection: &Selection) -> Vec<String> {
    let used: Vec<usize> = selection
        .slots
        .iter()
        .flat_map(|slot| &slot.places)
        .filter_map(|place| selection.wanted.get(*place).copied())
        .collect();
    let titles = source.titles().iter().enumerate();
    titles.filter(|(index, _)| !used.contains(index)).map(|(index, title)| title.place(index)).collect()
}
