//! What is in a log before anything is taken from it: columns, ranges, rates, the clock, and what is still to be told.
//!
//! Next door: the same in words (`crate::report`), one column row by row (`summary`).

use std::path::{Path, PathBuf};

use super::account::Account;
use super::cleaning::Cleaning;
use super::clock::Clock;
use super::error::RecordingError;
use super::formats;
use super::mapping::Mapping;
use super::nominal::nominal;
use super::pipeline::Watch;
use super::selection::{Clocked, Selection};
use super::source::{Next, Source};
use super::spacing::{GAP, HEAD};
use super::summary::Summary;
use super::telling::what_turns;
use super::unit;
use crate::message::Message;
use crate::quantity::{Dimension, Scale};

/// What is in a log.
#[derive(Debug, Clone, PartialEq)]
pub struct Overview {
    /// The file.
    pub file: PathBuf,
    /// How it is written.
    pub description: String,
    /// What stands above the rows.
    pub remarks: Vec<String>,
    /// How many rows there are.
    pub rows: u64,
    /// Rows that have too many or too few cells.
    pub broken: u64,
    /// Each column that holds numbers or times.
    pub columns: Vec<ColumnOverview>,
    /// What tells its rows' times; `None` where nothing does.
    pub clock: Option<ClockOverview>,
    /// What is to be told before it can be imported; `None` where all is told.
    pub lacks: Option<Message>,
}

/// A column.
#[derive(Debug, Clone, PartialEq)]
pub struct ColumnOverview {
    /// Its number, from 1.
    pub number: usize,
    /// Its title without the unit; empty where there is none.
    pub name: String,
    /// Its unit.
    pub unit: Option<String>,
    /// The channel it is taken for.
    pub channel: Option<&'static str>,
    /// Its values, in its own unit.
    pub summary: Summary,
}

/// The clock of a log.
#[derive(Debug, Clone, PartialEq)]
pub struct ClockOverview {
    /// First and last time \[s\], counted on where it begins anew.
    pub span: [f64; 2],
    /// The usual step \[s\], the median of the first thousand.
    pub usual: f64,
    /// The smallest and the largest step \[s\].
    pub steps: [f64; 2],
    /// Steps of more than one and a half usual ones.
    pub gaps: u64,
    /// Rows whose time is that of the one before.
    pub repeated: u64,
    /// Rows whose time goes back.
    pub back: u64,
    /// How often it begins anew, and what that is.
    pub turns: Option<(u64, String)>,
}

impl ClockOverview {
    /// The rate that people would have set \[Hz\].
    pub fn rate(&self) -> f64 {
        nominal(1.0 / self.usual)
    }
}

/// Follows the times of all rows.
struct Follower {
    index: usize,
    scale: Scale,
    clock: Clock,
    account: Account,
    head: Vec<f64>,
    last: Option<f64>,
    found: ClockOverview,
}

impl Overview {
    /// Looks at a log; `watch` hears now and then how much is done, and says whether to go on.
    ///
    /// # Errors
    /// [`RecordingError`] where it cannot be read as columns of numbers.
    pub fn read(path: &Path, mapping: &Mapping, watch: &Watch<'_>) -> Result<Self, RecordingError> {
        let mut source = formats::open(path, &mapping.format)?;
        source.be_lenient();
        let wanted = source.numeric();
        let clocked = match mapping.format.sample_rate.is_some() || source.clock().is_some() {
            true => Clocked::ByRate,
            false => Clocked::ByColumn,
        };
        let selection = Selection::of(source.file(), source.titles(), mapping, clocked);
        let channel_of = |index: usize| selection.as_ref().ok().and_then(|selection| selection.channel_of(index));
        let mut columns: Vec<ColumnOverview> = wanted
            .iter()
            .map(|&index| {
                let title = &source.titles()[index];
                let (name, unit) = (title.name.clone(), title.unit.clone());
                ColumnOverview {
                    number: index + 1,
                    name,
                    unit,
                    channel: channel_of(index),
                    summary: Summary::default(),
                }
            })
            .collect();
        let mut follower = time_column(source.as_ref(), &wanted, selection.as_ref().ok());
        let (mut cells, mut rows, mut broken) = (Vec::new(), 0u64, 0);
        loop {
            let [done, of] = source.progress();
            if rows.is_multiple_of(4096) && !watch(done, of) {
                return Err(RecordingError::of_file(path, "the import was interrupted"));
            }
            match source.next(&wanted, &mut cells)? {
                Next::End => break,
                Next::Broken { .. } => broken += 1,
                Next::Row(line) => {
                    rows += 1;
                    for (column, cell) in columns.iter_mut().zip(&cells) {
                        column.summary.push(*cell);
                    }
                    if let Some(follower) = &mut follower {
                        follower.push(cells.get(follower.index).copied().unwrap_or(f64::NAN), line);
                    }
                }
            }
        }
        if rows == 0 {
            return Err(RecordingError::of_file(path, "has no rows"));
        }
        let told = mapping.format.sample_rate.map(|rate| (0.0, 1.0 / rate));
        let by_head = told.or(source.clock().map(|clock| (clock.start, clock.interval)));
        Ok(Self {
            file: source.file().to_owned(),
            description: source.description(),
            remarks: source.remarks().to_vec(),
            rows,
            broken,
            columns,
            clock: match by_head {
                Some((start, interval)) => Some(even(start, interval, rows)),
                None => follower.and_then(Follower::found),
            },
            lacks: selection.err().map(|error| error.without_file(path)),
        })
    }
}

/// A clock of even rows.
fn even(start: f64, interval: f64, rows: u64) -> ClockOverview {
    ClockOverview {
        span: [start, start + (rows - 1) as f64 * interval],
        usual: interval,
        steps: [interval; 2],
        gaps: 0,
        repeated: 0,
        back: 0,
        turns: None,
    }
}

/// The column of time: the one that is chosen, else the first of times.
fn time_column(source: &dyn Source, wanted: &[usize], selection: Option<&Selection>) -> Option<Follower> {
    let titles = source.titles();
    let is_time = |title: &super::title::Title| {
        title.stamps || title.unit.as_deref().and_then(unit::dimension) == Some(Dimension::Time)
    };
    let chosen = selection.and_then(Selection::time_column);
    let column = chosen.or_else(|| titles.iter().position(is_time))?;
    let title = titles.get(column)?;
    let by_title = title.unit.as_deref().and_then(|text| unit::scale(Dimension::Time, text));
    let scale = match (title.stamps, selection.and_then(Selection::time_scale)) {
        (true, _) => Scale::Times(1.0),
        (false, Some(scale)) if chosen.is_some() => scale,
        _ => by_title?,
    };
    let index = wanted.iter().position(|&place| place == column)?;
    let lenient = Cleaning { unwrap: true, sort: true, merge_repeated: true, ..Cleaning::default() };
    Some(Follower {
        index,
        scale,
        clock: Clock::new(lenient, title.stamps, scale.apply(1.0).abs()),
        account: Account::default(),
        head: Vec::new(),
        last: None,
        found: even(0.0, f64::NAN, 1),
    })
}

impl Follower {
    fn push(&mut self, cell: f64, line: u64) {
        let raw = self.scale.apply(cell);
        let Ok(Some(time)) = self.clock.follow(raw, line, &mut self.account) else { return };
        if time.is_nan() {
            return;
        }
        let Some(last) = self.last.replace(time) else {
            self.found.span = [time; 2];
            return;
        };
        let step = time - last;
        let [from, to] = self.found.span;
        self.found.span = [from.min(time), to.max(time)];
        match step {
            step if step < 0.0 => self.found.back += 1,
            0.0 => self.found.repeated += 1,
            step => {
                let [least, largest] = self.found.steps;
                self.found.steps = [least.min(step), largest.max(step)];
                if self.head.len() < HEAD {
                    self.head.push(step);
                    self.settle(false);
                } else if step > GAP * self.found.usual {
                    self.found.gaps += 1;
                }
            }
        }
    }

    /// Finds the usual step once the head is full, and counts the gaps in it.
    fn settle(&mut self, last: bool) {
        if self.head.len() < HEAD && !last || self.head.is_empty() {
            return;
        }
        let mut sorted = self.head.clone();
        sorted.sort_by(f64::total_cmp);
        self.found.usual = sorted[(sorted.len() - 1) / 2];
        self.found.gaps += self.head.iter().filter(|step| **step > GAP * self.found.usual).count() as u64;
    }

    fn found(mut self) -> Option<ClockOverview> {
        if self.head.len() < HEAD {
            self.settle(true);
        }
        self.found.turns = self.account.turns.map(|(turn, tally)| (tally.count, what_turns(turn)));
        (self.found.usual > 0.0).then_some(self.found)
    }
}
