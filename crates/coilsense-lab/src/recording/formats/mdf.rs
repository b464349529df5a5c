//! An MDF 4 file: the channels of all its groups, each at the times of its own group's clock.
//!
//! Next door: other files that are read as a whole (`matlab`), their rows (`table`).

use std::fs::File;
use std::io::{Read, Seek, SeekFrom};
use std::path::Path;
use std::sync::{Arc, Mutex, PoisonError};

use falcon_mdf::blocks::{DataType, SyncType};
use falcon_mdf::io::{ByteSlice, ByteSource};
use falcon_mdf::{ChannelGroup, Mf4Error, Mf4File};

use super::super::error::{RecordingError, shortened};
use super::super::input::{Input, unreadable};
use super::super::order::MOST_NUMBERS;
use super::super::table::Table;
use super::super::title::Title;
use super::guarded::guarded;

/// A group of channels that were sampled together.
struct Group {
    times: Vec<f64>,
    columns: Vec<(Title, Vec<f64>)>,
}

/// Reads a file.
pub(super) fn read(input: Input) -> Result<Table, RecordingError> {
    let path = input.path().to_owned();
    let file = input.file()?;
    guarded(&path, || decoded(&path, file))
}

/// A file as the library reads one.
struct Bytes {
    file: Mutex<File>,
    size: u64,
}

impl ByteSource for Bytes {
    fn len(&self) -> u64 {
        self.size
    }

    fn read_bytes(&self, offset: u64, len: usize) -> Result<ByteSlice<'_>, Mf4Error> {
        // Of a damaged file a length may be anything.
        let available = self.size.saturating_sub(offset);
        if len as u64 > available {
            return Err(Mf4Error::truncated(offset, len, available as usize));
        }
        let mut bytes = vec![0; len];
        let mut file = self.file.lock().unwrap_or_else(PoisonError::into_inner);
        file.seek(SeekFrom::Start(offset))?;
        file.read_exact(&mut bytes)?;
        Ok(ByteSlice::Owned(bytes))
    }
}

fn decoded(path: &Path, file: File) -> Result<Table, RecordingError> {
    let wrong = |error: Mf4Error| {
        RecordingError::of_file(path, format!("is no MDF 4 file that can be read: {}", shortened(&error.to_string())))
    };
    let size = file.metadata().map_err(|error| unreadable(path, &error))?.len();
    let file = Mf4File::from_source(Arc::new(Bytes { file: Mutex::new(file), size })).map_err(wrong)?;
    let all = file.data_groups().iter().flat_map(|data| &data.channel_groups);
    let timed = all.filter(|group| group.sample_count > 0 && clock(group).is_some());
    let numbers: u64 = timed.clone().map(|group| group.sample_count.saturating_mul(group.channels.len() as u64)).sum();
    if numbers > MOST_NUMBERS as u64 {
        return Err(RecordingError::of_file(path, "is too large to be held in memory"));
    }
    let groups = timed.map(|timed| group(&file, timed)).collect::<Result<Vec<Group>, Mf4Error>>().map_err(wrong)?;
    let description = format!("MDF {}, {} groups with a clock", file.version(), groups.len());
    let times = one_clock(path, &groups)?;
    let columns: usize = 1 + groups.iter().map(|group| group.columns.len()).sum::<usize>();
    if columns < 2 || times.is_empty() {
        return Err(RecordingError::of_file(path, "has no channel of numbers with a clock"));
    }
    if times.len().saturating_mul(columns) > MOST_NUMBERS {
        return Err(RecordingError::of_file(path, "is too large to be held in memory"));
    }
    let mut table = Table {
        file: path.to_owned(),
        description,
        remarks: file.comment().lines().map(|line| shortened(line.trim())).filter(|line| !line.is_empty()).collect(),
        titles: vec![titled("time", "s")],
        columns: Vec::new(),
        lines: (1..=times.len() as u64).collect(),
    };
    for group in &groups {
        for (title, values) in &group.columns {
            table.titles.push(title.clone());
            table.columns.push(spread(&group.times, values, &times));
        }
    }
    table.columns.insert(0, times);
    Ok(table)
}

fn titled(name: &str, unit: &str) -> Title {
    let unit = Some(unit.trim().to_owned()).filter(|unit| !unit.is_empty());
    let text = unit.as_ref().map_or(name.to_owned(), |unit| format!("{name} [{unit}]"));
    Title { text, name: name.to_owned(), unit, stamps: false }
}

/// The place of a group's clock among its channels.
fn clock(group: &ChannelGroup) -> Option<usize> {
    let master = group.master_channel()?;
    (master.sync_type == SyncType::Time).then_some(())?;
    group.channels.iter().position(|channel| channel.id == master.id)
}

fn group(file: &Mf4File, group: &ChannelGroup) -> Result<Group, Mf4Error> {
    let clock = clock(group);
    let numeric = |kind: DataType| {
        use DataType::{FloatBe, FloatLe, IntBe, IntLe, UIntBe, UIntLe};
        matches!(kind, UIntLe | UIntBe | IntLe | IntBe | FloatLe | FloatBe)
    };
    let (mut times, mut columns) = (Vec::new(), Vec::new());
    for (index, channel) in group.channels.iter().enumerate() {
        if !numeric(channel.data_type) && Some(index) != clock {
            continue;
        }
        let signal = file.signal(channel)?;
        let mut values = signal.values_f64()?;
        if let Some(valid) = signal.validity() {
            for (value, valid) in values.iter_mut().zip(valid) {
                if !valid {
                    *value = f64::NAN;
                }
            }
        }
        if Some(index) == clock {
            times = values;
        } else {
            columns.push((titled(&channel.name, &channel.unit), values));
        }
    }
    Ok(Group { times, columns })
}

/// All times of all groups, each once; those of a single group as they are.
fn one_clock(path: &Path, groups: &[Group]) -> Result<Vec<f64>, RecordingError> {
    if let [only] = groups {
        return Ok(only.times.clone());
    }
    for (index, group) in groups.iter().enumerate() {
        if let Some(row) = (1..group.times.len()).find(|&row| {
            !matches!(group.times[row].partial_cmp(&group.times[row - 1]), Some(std::cmp::Ordering::Greater))
        }) {
            let message =
                format!("group {}, row {}: time must rise where several groups are to be one log", index + 1, row + 1);
            return Err(RecordingError::of_file(path, message));
        }
    }
    let mut all: Vec<f64> = groups.iter().flat_map(|group| group.times.iter().copied()).collect();
    all.sort_by(f64::total_cmp);
    all.dedup();
    Ok(all)
}

/// A group's values at the times of all groups; NaN where it has none.
fn spread(own: &[f64], values: &[f64], times: &[f64]) -> Vec<f64> {
    let mut pairs = own.iter().zip(values).peekable();
    times.iter().map(|time| pairs.next_if(|(own, _)| *own == time).map_or(f64::NAN, |(_, value)| *value)).collect()
}
