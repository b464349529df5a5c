//! An MDF file of version 2 or 3: the channels of all its groups, each at the times of its own group's clock.
//!
//! | file | holds |
//! |---|---|
//! | `blocks` | the blocks of a file: groups, channels, conversions, by their addresses |
//! | `conversion` | what a channel's conversion makes of its raw numbers |
//! | `records` | the raw numbers of a group |
//!
//! Next door: version 4 (`mdf`), groups on one clock (`grouped`).
//!
//! Source: Vector, "MDF 3.3 format specification"; held against asammdf.

mod blocks;
mod conversion;
mod records;

use super::super::error::RecordingError;
use super::super::input::Input;
use super::super::order::MOST_NUMBERS;
use super::super::table::Table;
use super::apart::Apart;
use super::grouped::{Group, one_table, titled};
use blocks::{Channel, Channels, Data, Reader};
use conversion::Conversion;

/// Most bytes of a file: all of it lies in memory.
const MOST_BYTES: u64 = 1 << 30;

/// Reads a file.
pub(super) fn read(input: Input) -> Result<Table, RecordingError> {
    let path = input.path().to_owned();
    let path = path.as_path();
    let wrong = |message: String| RecordingError::of_file(path, message);
    let bytes = input.bytes(MOST_BYTES, "an MDF 3 file")?;
    let damaged = |message: String| wrong(format!("is no MDF 3 file that can be read: {message}"));
    let reader = Reader::of(&bytes).map_err(damaged)?;
    let version = reader.version();
    let (mut groups, mut apart, mut cut, mut numbers) = (Vec::new(), Apart::default(), false, 0_u64);
    for data in reader.data().map_err(damaged)? {
        let rows = data.rows(&bytes);
        cut |= rows.cut;
        numbers = data.groups.iter().zip(&rows.counts).fold(numbers, |sum, (group, count)| {
            sum.saturating_add((*count as u64).saturating_mul(group.channels.len() as u64))
        });
        if numbers > MOST_NUMBERS as u64 {
            return Err(wrong("is too large to be held in memory".to_owned()));
        }
        groups.extend(converted(&data, &bytes, &mut apart).map_err(damaged)?);
    }
    if groups.iter().all(|group| group.columns.is_empty()) {
        return Err(wrong(format!("has no channel of numbers with a clock{}", apart.told())));
    }
    let told = if cut { ", cut off in its data" } else { "" };
    let description = format!("MDF {version}, {} groups with a clock{told}{}", groups.len(), apart.told());
    let remarks = if cut { vec!["the file is cut off in its data".to_owned()] } else { Vec::new() };
    one_table(path, description, remarks, groups)
}

/// The groups of a data block that have a clock.
fn converted(data: &Data, bytes: &[u8], apart: &mut Apart) -> Result<Vec<Group>, String> {
    let mut all = Vec::new();
    for (group, raw) in data.groups.iter().zip(data.read(bytes)?) {
        if raw.first().is_none_or(Vec::is_empty) {
            continue;
        }
        if !group.channels.iter().any(|channel| channel.is_clock) {
            group.channels.iter().for_each(|channel| apart.leave(&channel.name, "without a clock"));
            continue;
        }
        all.extend(columns(group, raw, apart));
    }
    Ok(all)
}

/// The converted channels of a group.
fn columns(group: &Channels, raw: Vec<Vec<f64>>, apart: &mut Apart) -> Option<Group> {
    let (mut times, mut columns) = (None, Vec::new());
    for (channel, values) in group.channels.iter().zip(raw) {
        let Channel { name, unit, conversion, is_clock, is_number, .. } = channel;
        let values = match conversion {
            _ if !is_number => Err("no numbers".to_owned()),
            Conversion::Not(why) => Err((*why).to_owned()),
            conversion => Ok(values.into_iter().map(|value| conversion.apply(value)).collect::<Vec<f64>>()),
        };
        match values {
            Err(why) => apart.leave(name, &why),
            Ok(values) if *is_clock && times.is_none() => times = Some(values),
            Ok(values) => columns.push((titled(name, unit), values)),
        }
    }
    times.map(|times| Group { clock: titled("time", "s"), times, columns })
}
