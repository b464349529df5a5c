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
use super::grouped::{Group, one_table, titled};
use crate::guarded::guarded;

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
    let remarks = file.comment().lines().map(|line| shortened(line.trim())).filter(|line| !line.is_empty()).collect();
    one_table(path, description, remarks, groups)
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
    Ok(Group { clock: titled("time", "s"), times, columns })
}
