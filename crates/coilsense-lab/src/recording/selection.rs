//! Which columns of a file are which channels, and what takes their numbers to SI.
//!
//! Next door: what the user says about it (`mapping`), what the file says (`title`), what neither says (`proposal`).

use std::path::Path;

use super::error::{RecordingError, clipped};
use super::mapping::{Columns, Mapping};
use super::proposal::Proposal;
use super::quantity::Quantity;
use super::title::Title;
use super::unit;
use crate::likeness::nearest;
use crate::message::Message;
use crate::quantity::{Dimension, Scale};

/// Columns of a file that are taken.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Selection {
    /// Indices of all columns that are needed, rising.
    pub wanted: Vec<usize>,
    /// Time, where there is a column of it, then the channels in their order.
    pub slots: Vec<Slot>,
}

/// One quantity: places of its columns in `wanted`, of which the mean counts, and what takes that to SI; without places the offset alone.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Slot {
    pub quantity: Quantity,
    pub places: Vec<usize>,
    pub scale: Scale,
    pub offset: f64,
    /// What the user said of its numbers, in words.
    pub told: String,
}

impl Slot {
    /// The SI value in a row; NaN where one of its columns has none.
    pub fn value(&self, row: &[f64]) -> f64 {
        if self.places.is_empty() {
            return self.offset;
        }
        let sum: f64 = self.places.iter().map(|&place| row.get(place).copied().unwrap_or(f64::NAN)).sum();
        self.scale.apply(sum / self.places.len() as f64) + self.offset
    }
}

/// Whether rows are told by a clock.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Clocked {
    /// A column of time is needed.
    ByColumn,
    /// A rate is told: a column of time is left alone.
    ByRate,
    /// Time plays no part.
    No,
}

/// Names of a time column that need no mapping, in lower case.
pub(super) const TIMES: [&str; 3] = ["time", "t", "timestamp"];

impl Selection {
    /// Finds the columns that a mapping names, and those that carry a channel's name. What is missing of all of them is one error.
    pub fn of(file: &Path, titles: &[Title], mapping: &Mapping, clocked: Clocked) -> Result<Self, RecordingError> {
        let refused = |message: Message| RecordingError::of_file(file, message);
        let (mut proposal, mut found) = (Proposal::default(), Vec::new());
        for quantity in Quantity::all() {
            let is_time = quantity == Quantity::Time;
            if is_time && (clocked == Clocked::ByRate || clocked == Clocked::No && !mapping.tells(quantity)) {
                continue;
            }
            let told = mapping.columns.iter().find(|(other, _)| *other == quantity).map(|(_, columns)| columns.clone());
            let columns = match told {
                Some(told) if told.titles.is_empty() && told.constant.is_none() => {
                    let named = by_name(titles, quantity).map(|title| vec![title]);
                    let lacks = || refused(format!("no column is called {}", quantity.name()).into());
                    Columns { titles: named.ok_or_else(lacks)?, ..told }
                }
                Some(told) => told,
                None => match by_name(titles, quantity) {
                    Some(title) => Columns { titles: vec![title], ..Columns::BY_NAME },
                    None => continue,
                },
            };
            let places: Result<Vec<usize>, String> =
                columns.titles.iter().map(|title| find(titles, title, quantity)).collect();
            let places = places.map_err(|message| refused(message.into()))?;
            // A column of time that somebody told is looked for, and plays no part.
            if is_time && clocked == Clocked::No {
                continue;
            }
            let scale = scale(titles, &places, &columns, quantity, &mut proposal).map_err(refused)?;
            let told = told_of(&columns);
            let offset = columns.constant.unwrap_or(columns.offset);
            found.push(Slot { quantity, places, scale, offset, told });
        }
        let taken: Vec<usize> = found.iter().flat_map(|slot| slot.places.iter().copied()).collect();
        if clocked == Clocked::ByColumn && !found.iter().any(|slot| slot.quantity == Quantity::Time) {
            proposal.time(titles, &taken);
        }
        if !found.iter().any(|slot| slot.quantity != Quantity::Time && !slot.places.is_empty()) {
            proposal.channels(titles, &taken);
        }
        if !proposal.is_empty() {
            return Err(refused(proposal.message()));
        }
        let mut wanted = taken;
        wanted.sort_unstable();
        wanted.dedup();
        for slot in &mut found {
            for place in &mut slot.places {
                *place = wanted.binary_search(place).unwrap_or(usize::MAX);
            }
        }
        Ok(Self { slots: found, wanted })
    }

    /// The channel, or time, that a column is taken for.
    pub fn channel_of(&self, column: usize) -> Option<&'static str> {
        let place = self.wanted.binary_search(&column).ok()?;
        self.slots.iter().find(|slot| slot.places.contains(&place)).map(|slot| slot.quantity.name())
    }

    fn time(&self) -> Option<&Slot> {
        self.slots.first().filter(|slot| slot.quantity == Quantity::Time)
    }

    /// The column of time.
    pub fn time_column(&self) -> Option<usize> {
        self.wanted.get(*self.time()?.places.first()?).copied()
    }

    /// What takes its numbers to seconds.
    pub fn time_scale(&self) -> Option<Scale> {
        self.time().map(|slot| slot.scale)
    }

    /// Name and columns of each quantity, for people.
    pub fn taken(&self, titles: &[Title]) -> Vec<(&'static str, String)> {
        let place = |place: &usize| {
            let index = self.wanted.get(*place).copied().unwrap_or(0);
            titles.get(index).map_or(String::new(), |title| title.place(index))
        };
        let columns = |slot: &Slot| match slot.places.as_slice() {
            [one] => format!("{}{}", place(one), slot.told),
            [first, .., last] => {
                let count = slot.places.len();
                format!("the mean of {count} columns, {} to {}{}", place(first), place(last), slot.told)
            }
            [] => format!("no column: {} {} in every row, as told", slot.offset, slot.quantity.dimension().si_unit()),
        };
        self.slots.iter().map(|slot| (slot.quantity.name(), columns(slot))).collect()
    }
}

/// The title of the column that carries a quantity's name; of time, the first column where it is one of times.
pub(super) fn by_name(titles: &[Title], quantity: Quantity) -> Option<String> {
    let carries = |title: &&Title| match quantity {
        Quantity::Time => TIMES.contains(&title.name.to_lowercase().as_str()),
        Quantity::Channel(channel) => title.name == channel.name(),
    };
    let named = titles.iter().find(carries).map(|title| title.text.clone());
    let is_time =
        |title: &&Title| title.stamps || title.unit.as_deref().and_then(unit::dimension) == Some(Dimension::Time);
    let first = || titles.first().filter(|_| quantity == Quantity::Time).filter(is_time).map(|_| "#1".to_owned());
    named.or_else(first)
}

/// What is said of a column's numbers beside their unit.
fn told_of(columns: &Columns) -> String {
    let gain = columns.gain.as_ref().map_or(String::new(), |gain| format!(", {}", gain.text));
    let sign = match columns.factor {
        -1.0 => ", its sign turned".to_owned(),
        1.0 => String::new(),
        factor => format!(", times {factor}"),
    };
    let offset = if columns.offset == 0.0 { "" } else { ", an offset added" };
    format!("{gain}{sign}{offset}")
}

/// The index of the column of a title, a name, or `#3`.
pub(super) fn find(titles: &[Title], wanted: &str, quantity: Quantity) -> Result<usize, String> {
    let name = quantity.name();
    if let Some(number) = wanted.strip_prefix('#') {
        let count = titles.len();
        let index = number.parse::<usize>().ok().filter(|number| (1..=count).contains(number));
        return index.map(|number| number - 1).ok_or_else(|| format!("{name} = {wanted}: must be from #1 to #{count}"));
    }
    let all = |fits: &dyn Fn(&Title) -> bool| -> Vec<usize> {
        titles.iter().enumerate().filter(|(_, title)| fits(title)).map(|(index, _)| index).collect()
    };
    let exact = all(&|title| title.name == wanted || title.text == wanted);
    let places = if exact.is_empty() { all(&|title| title.name.eq_ignore_ascii_case(wanted)) } else { exact };
    match places.as_slice() {
        [one] => Ok(*one),
        [] if titles.iter().all(|title| title.text.is_empty()) => Err(format!(
            "{name} = {}: the file has no header; name the column by its number, such as #2",
            clipped(wanted)
        )),
        [] => {
            let nearest = nearest(wanted, titles.iter().map(|title| title.name.as_str()));
            let nearest = nearest.map_or(String::new(), |name| format!("; did you mean {}?", clipped(name)));
            Err(format!("{name} = {}: no column has this title{nearest}", clipped(wanted)))
        }
        [first, second, ..] => Err(format!(
            "{name} = {}: columns {} and {} both have this title; name one by its number, such as #{}",
            clipped(wanted),
            first + 1,
            second + 1,
            first + 1
        )),
    }
}

/// What takes the columns' numbers to SI. What is not told of their units goes to the proposal.
fn scale(
    titles: &[Title],
    places: &[usize],
    columns: &Columns,
    quantity: Quantity,
    proposal: &mut Proposal,
) -> Result<Scale, Message> {
    let (name, dimension) = (quantity.name(), quantity.dimension());
    let times = |scale: Scale| match scale {
        Scale::Times(by) => Scale::Times(by * columns.factor),
        over if columns.factor == 1.0 => over,
        Scale::Over(by) => Scale::Times(columns.factor / by),
    };
    let mut scales = Vec::new();
    for &index in places {
        let Some(title) = titles.get(index) else { continue };
        if title.stamps && quantity == Quantity::Time {
            scales.push(Scale::Times(1.0));
            continue;
        }
        let place = title.place(index);
        if let Some(gain) = &columns.gain {
            let unit = columns.unit.as_deref().or(title.unit.as_deref());
            let si = gain.of_unit(unit).map_err(|wrong| format!("{place}: {wrong}; {name} = {:?}", gain.text))?;
            scales.push(Scale::Times(si));
            continue;
        }
        let unit = match (&columns.unit, &title.unit) {
            (Some(told), Some(own)) if unit::scale(dimension, told) != unit::scale(dimension, own) => {
                return Err(format!("{place}: its title says {own:?}, the mapping of {name} says {told:?}").into());
            }
            (Some(unit), _) | (None, Some(unit)) => unit,
            (None, None) => {
                proposal.unit(titles, index, quantity);
                continue;
            }
        };
        let Some(scale) = unit::scale(dimension, unit) else {
            if unit::is_signal(unit) {
                proposal.gain(titles, index, quantity, unit);
                continue;
            }
            let (what, symbols) = (dimension.name(), dimension.symbols());
            return Err(format!("{place}: {unit:?} is not a unit of {what}; {name} may have {symbols}").into());
        };
        scales.push(scale);
    }
    let first = scales.first().copied().unwrap_or(Scale::Times(1.0));
    if scales.iter().any(|scale| *scale != first) {
        return Err(format!("{name}: its columns have different units; only columns of one unit have a mean").into());
    }
    Ok(times(first))
}
