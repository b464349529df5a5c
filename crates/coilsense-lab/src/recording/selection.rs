//! Which columns of a file are which channels, and what takes their numbers to SI.
//!
//! Next door: what the user says about it (`mapping`), what the file says (`title`).

use std::path::Path;

use super::error::{RecordingError, clipped};
use super::mapping::{Columns, Mapping};
use super::quantity::Quantity;
use super::title::Title;
use crate::likeness::nearest;
use crate::message::{Hint, Message};
use crate::quantity::Scale;

/// Columns of a file that are taken.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Selection {
    /// Indices of all columns that are needed, rising.
    pub wanted: Vec<usize>,
    /// Time, where there is a column of it, then the channels in their order.
    pub slots: Vec<Slot>,
}

/// One quantity: places of its columns in `wanted`, of which the mean counts, and what takes that to SI.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Slot {
    pub quantity: Quantity,
    pub places: Vec<usize>,
    pub scale: Scale,
    pub offset: f64,
}

impl Slot {
    /// The SI value in a row; NaN where one of its columns has none.
    pub fn value(&self, row: &[f64]) -> f64 {
        let sum: f64 = self.places.iter().map(|&place| row.get(place).copied().unwrap_or(f64::NAN)).sum();
        self.scale.apply(sum / self.places.len() as f64) + self.offset
    }
}

/// Names of a time column that need no mapping, in lower case.
pub(super) const TIMES: [&str; 3] = ["time", "t", "timestamp"];

impl Selection {
    /// Finds the columns that a mapping names, and those that carry a channel's name.
    pub fn of(file: &Path, titles: &[Title], mapping: &Mapping) -> Result<Self, RecordingError> {
        let refused = |message: Message| RecordingError::of_file(file, message);
        let mut found: Vec<(Quantity, Vec<usize>, Scale, f64)> = Vec::new();
        for quantity in Quantity::all() {
            let told = mapping.columns.iter().find(|(other, _)| *other == quantity).map(|(_, columns)| columns.clone());
            let Some(columns) = told.or_else(|| by_name(titles, quantity)) else { continue };
            let places: Result<Vec<usize>, String> =
                columns.titles.iter().map(|title| find(titles, title, quantity)).collect();
            let places = places.map_err(|message| refused(message.into()))?;
            let scale = scale(titles, &places, &columns, quantity).map_err(refused)?;
            found.push((quantity, places, scale, columns.offset));
        }
        if !found.iter().any(|(quantity, ..)| *quantity != Quantity::Time) {
            let names: Vec<String> =
                titles.iter().enumerate().map(|(index, title)| title.place(index)).take(8).collect();
            let last = titles.last().filter(|title| !title.text.is_empty()).map_or("#2 [N]", |title| &title.text);
            let text = format!("no column is known as a channel; it has {}; ", names.join(", "));
            let example = Hint::Column("F_o", last.to_owned());
            return Err(refused(Message::from(text) + "say which is which, as in " + example));
        }
        let mut wanted: Vec<usize> = found.iter().flat_map(|(_, places, ..)| places.iter().copied()).collect();
        wanted.sort_unstable();
        wanted.dedup();
        let within = |index: usize| wanted.binary_search(&index).unwrap_or(usize::MAX);
        let slots = found.into_iter().map(|(quantity, places, scale, offset)| Slot {
            quantity,
            places: places.into_iter().map(within).collect(),
            scale,
            offset,
        });
        Ok(Self { slots: slots.collect(), wanted })
    }

    /// Whether there is a column of time.
    pub fn has_time(&self) -> bool {
        self.slots.first().is_some_and(|slot| slot.quantity == Quantity::Time)
    }

    /// Name and columns of each quantity, for people.
    pub fn taken(&self, titles: &[Title]) -> Vec<(&'static str, String)> {
        let place = |place: &usize| {
            let index = self.wanted.get(*place).copied().unwrap_or(0);
            titles.get(index).map_or(String::new(), |title| title.place(index))
        };
        let columns = |slot: &Slot| match slot.places.as_slice() {
            [one] => place(one),
            [first, .., last] => {
                format!("the mean of {} columns, {} to {}", slot.places.len(), place(first), place(last))
            }
            [] => String::new(),
        };
        self.slots.iter().map(|slot| (slot.quantity.name(), columns(slot))).collect()
    }
}

fn by_name(titles: &[Title], quantity: Quantity) -> Option<Columns> {
    let carries = |title: &&Title| match quantity {
        Quantity::Time => TIMES.contains(&title.name.to_lowercase().as_str()),
        Quantity::Channel(channel) => title.name == channel.name(),
    };
    let title = titles.iter().find(carries)?;
    Some(Columns { unit: None, ..Columns::titled(&title.text) })
}

/// The index of the column of a title, a name, or `#3`.
fn find(titles: &[Title], wanted: &str, quantity: Quantity) -> Result<usize, String> {
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

/// What takes the columns' numbers to SI.
fn scale(titles: &[Title], places: &[usize], columns: &Columns, quantity: Quantity) -> Result<Scale, Message> {
    let (name, dimension) = (quantity.name(), quantity.dimension());
    let times = |scale: Scale| match scale {
        Scale::Times(by) => Scale::Times(by * columns.factor),
        over if columns.factor == 1.0 => over,
        Scale::Over(by) => Scale::Times(columns.factor / by),
    };
    if let Some(gain) = columns.gain {
        return Ok(Scale::Times(gain * columns.factor));
    }
    let mut scales = Vec::new();
    for &index in places {
        let Some(title) = titles.get(index) else { continue };
        if title.stamps && quantity == Quantity::Time {
            scales.push(Scale::Times(1.0));
            continue;
        }
        let place = title.place(index);
        let unit = match (&columns.unit, &title.unit) {
            (Some(told), Some(own)) if dimension.scale(told) != dimension.scale(own) => {
                return Err(format!("{place}: its title says {own:?}, the mapping of {name} says {told:?}").into());
            }
            (Some(unit), _) | (None, Some(unit)) => unit,
            (None, None) => {
                let typed = if title.name.is_empty() { format!("#{}", index + 1) } else { title.name.clone() };
                let example = Hint::Column(name, format!("{typed} [{}]", dimension.si_unit()));
                return Err(Message::from(format!("{place}: its unit is not told; say it, as in ")) + example);
            }
        };
        let found = dimension.scale(unit);
        let message = || {
            format!("{place}: {unit:?} is not a unit of {}; {name} may have {}", dimension.name(), dimension.symbols())
        };
        scales.push(found.ok_or_else(message)?);
    }
    let first = scales.first().copied().unwrap_or(Scale::Times(1.0));
    if scales.iter().any(|scale| *scale != first) {
        return Err(format!("{name}: its columns have different units; only columns of one unit have a mean").into());
    }
    Ok(times(first))
}
