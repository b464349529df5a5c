//! From a source's rows to SI rows on one rising clock.
//!
//! Next door: the stages (`order`, `complete`, `spacing`), where rows come from (`source`), where they go (`mod`).

use coilsense::Channel;

use super::account::{Account, Reason};
use super::cleaning::Cleaning;
use super::clock::{Behind, Clock};
use super::complete::Complete;
use super::error::{RecordingError, leave_out};
use super::layout::FileClock;
use super::mapping::Mapping;
use super::order::Order;
use super::quantity::Quantity;
use super::row::{Onward, Row};
use super::selection::{Clocked, Selection, Slot};
use super::source::{Next, Source};
use super::spacing::Spacing;
use super::telling::{hertz, seconds};
use crate::message::Message;

/// A source whose rows are read as SI values of the columns that are taken.
pub(super) struct Rows<'a> {
    source: &'a mut dyn Source,
    selection: Selection,
    mapping: &'a Mapping,
    cleaning: &'a Cleaning,
    clock: Option<FileClock>,
    cells: Vec<f64>,
    /// What became of the rows.
    pub account: Account,
}

/// Hears how much of how much is done; says whether to go on.
pub type Watch<'a> = dyn Fn(u64, u64) -> bool + 'a;

/// So many rows behind a fault are looked at.
const LOOKED_AT: usize = 100_000;
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
    /// Chooses the columns; `timed` says whether rows need a clock.
    pub fn of(
        source: &'a mut dyn Source,
        mapping: &'a Mapping,
        cleaning: &'a Cleaning,
        timed: bool,
    ) -> Result<Self, RecordingError> {
        let told = mapping.format.sample_rate.map(|rate| FileClock { start: 0.0, interval: 1.0 / rate });
        let clock = told.or(source.clock().filter(|_| !mapping.tells(Quantity::Time)));
        let clocked = match (timed, clock) {
            (false, _) => Clocked::No,
            (true, Some(_)) => Clocked::ByRate,
            (true, None) => Clocked::ByColumn,
        };
        let selection = Selection::of(source.file(), source.titles(), mapping, clocked)?;
        let account = Account {
            file: source.file().to_owned(),
            description: source.description(),
            taken: selection.taken(source.titles()),
            not_taken: not_taken(source, &selection),
            notes: super::simulated(source.remarks())
                .map(|remark| format!("its header says: {remark}"))
                .into_iter()
                .chain(clock.filter(|_| timed && told.is_none()).map(|clock| {
                    let (rate, start) = (hertz(1.0 / clock.interval), seconds(clock.start));
                    format!("clock from its header: {rate}, from {start} on")
                }))
                .collect(),
            ..Account::default()
        };
        Ok(Self { source, selection, mapping, cleaning, clock, cells: Vec::new(), account })
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
        let clock = self.clock;
        let rate = self.mapping.format.sample_rate;
        let names = self.channels().iter().map(|channel| channel.name()).collect();
        let (mut follower, mut first) = (self.follower(), None);
        let mut order = Order::new(file.clone(), *self.cleaning);
        let mut complete = Complete::new(file.clone(), *self.cleaning, names);
        let mut spacing = Spacing::new(file.clone(), *self.cleaning);
        while let Some(reading) = self.next()? {
            let [done, of] = self.source.progress();
            if self.account.read.is_multiple_of(WATCHED) && !watch(done, of) {
                return Err(RecordingError::of_file(&file, "the import was interrupted"));
            }
            let by_rate = rate.map(|rate| reading.index as f64 / rate);
            let by_head = || clock.map(|clock| clock.start + reading.index as f64 * clock.interval);
            let time = reading.time.or(by_rate).or_else(by_head).unwrap_or(0.0);
            let time = match follower.follow(time, reading.line, &mut self.account) {
                Ok(Some(time)) => time,
                Ok(None) => continue,
                Err(fault) => {
                    let message = fault.message(&self.behind(first, time));
                    return Err(RecordingError::of_line(&file, reading.line, message));
                }
            };
            first.get_or_insert(time);
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
        account.check_repairs(self.cleaning)?;
        Ok(account)
    }

    /// What follows the times of the rows.
    fn follower(&self) -> Clock {
        let column = self.selection.time_column();
        let stamps = column.and_then(|column| self.source.titles().get(column)).is_some_and(|title| title.stamps);
        let tick = self.selection.time_scale().map_or(1.0, |scale| scale.apply(1.0).abs());
        Clock::new(*self.cleaning, stamps, tick)
    }

    /// The times of rows behind a fault, from that one on, as far as they tell what it is.
    fn behind(&mut self, first: Option<f64>, time: f64) -> Behind {
        let rows = self.account.read;
        let mut times = vec![time];
        while let (true, Ok(Some(reading))) = (times.len() < LOOKED_AT, self.next()) {
            times.extend(reading.time);
        }
        Behind { times, rows, first: first.unwrap_or(time) }
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
