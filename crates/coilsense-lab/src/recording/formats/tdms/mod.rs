//! A file of NI TDMS, as LabVIEW, FlexLogger and DAQmx write it: its channels of numbers, each at the times of its clock.
//!
//! | file | holds |
//! |---|---|
//! | `bytes`, `kind` | values of metadata, types of values |
//! | `properties`, `index` | what is told of a channel, and where its data lie |
//! | `layout`, `metadata` | a segment's chunks, by its own metadata and those of the segments before |
//! | `data` | reading them |
//! | `scaling` | raw numbers in the channel's own unit |
//! | `clock`, `columns` | when the values were taken, and the table of them |
//!
//! Next door: other files that are read as a whole (`mdf`, `matlab`), groups on one clock (`grouped`).
//!
//! Source: NI, "TDMS File Format Internal Structure"; where that is silent, as npTDMS does it.

mod bytes;
mod clock;
mod columns;
mod data;
mod index;
mod kind;
mod layout;
mod metadata;
mod properties;
mod scaling;

use super::super::error::RecordingError;
use super::super::input::Input;
use super::super::order::MOST_NUMBERS;
use super::super::table::Table;
use bytes::Bytes;
use data::{Blocks, Raw, Segment};
use metadata::{Contents, Metadata};

/// Bytes in front of a segment's metadata.
const LEAD: u64 = 28;
/// Most bytes of a segment's metadata.
const MOST_METADATA: u64 = 1 << 28;

/// Where a segment lies.
struct Extent {
    contents: Contents,
    data: u64,
    end: u64,
    cut: bool,
}

/// All that a file tells.
#[derive(Default)]
struct Contained {
    metadata: Metadata,
    channels: Vec<Raw>,
    numbers: u64,
    /// Whether the file ends before its last segment does.
    cut: bool,
}

/// Reads a file.
pub(super) fn read(input: Input) -> Result<Table, RecordingError> {
    let path = input.path().to_owned();
    let path = path.as_path();
    let wrong = |message: String| RecordingError::of_file(path, message);
    let unreadable = |error: std::io::Error| wrong(format!("cannot be read: {error}"));
    let file = input.file()?;
    let size = file.metadata().map_err(unreadable)?.len();
    let damaged = |message: String| wrong(format!("is no NI TDMS file that can be read: {message}"));
    let mut contained = Contained::default();
    contained.read(&mut Blocks::of(file), size).map_err(damaged)?;
    if contained.numbers > MOST_NUMBERS as u64 {
        return Err(wrong("is too large to be held in memory".to_owned()));
    }
    columns::table(path, contained)
}

impl Contained {
    /// Reads segment after segment, as far as there are any.
    fn read(&mut self, blocks: &mut Blocks, size: u64) -> Result<(), String> {
        let mut place = 0;
        while place < size {
            let Some(extent) = Extent::read(blocks, place, size)? else {
                self.cut = true;
                break;
            };
            let metadata = if extent.contents.has_metadata() {
                let length = extent.data - place - LEAD;
                if length > MOST_METADATA {
                    return Err("a segment has more than 256 MiB of metadata".to_owned());
                }
                blocks.seek(place + LEAD)?;
                blocks.read(length)?.to_vec()
            } else {
                Vec::new()
            };
            let layout = self.metadata.segment(extent.contents, &metadata)?;
            self.channels.resize_with(self.metadata.objects.len(), Raw::default);
            let segment = Segment {
                layout: &layout,
                start: extent.data,
                end: extent.end,
                interleaved: extent.contents.is_interleaved(),
                big_endian: extent.contents.is_big_endian(),
                cut: extent.cut,
            };
            self.cut |= extent.cut;
            self.numbers = self.numbers.saturating_add(segment.numbers()?);
            if self.numbers > MOST_NUMBERS as u64 {
                return Ok(());
            }
            segment.read(blocks, &mut self.channels)?;
            place = extent.end;
        }
        Ok(())
    }
}

impl Extent {
    /// Reads the lead of a segment; `None` where the file ends in it or in the metadata.
    fn read(blocks: &mut Blocks, place: u64, size: u64) -> Result<Option<Self>, String> {
        blocks.seek(place)?;
        let lead = blocks.read(LEAD)?;
        if (lead.len() as u64) < LEAD {
            return Ok(None);
        }
        let mut mask = Bytes::of(&lead[4..], false);
        if !lead.starts_with(b"TDSm") {
            return Err(format!("at byte {place} no segment begins"));
        }
        let contents = Contents::of(mask.word()?);
        let mut lead = Bytes::of(&lead[8..], contents.is_big_endian());
        lead.word()?;
        let (next, raw) = (lead.long()?, lead.long()?);
        let data = (place + LEAD).checked_add(raw);
        let end = (place + LEAD).checked_add(next).filter(|end| *end <= size);
        // All bits set are "not yet known": who wrote it was stopped.
        let cut = end.is_none();
        let end = end.unwrap_or(size);
        match data.filter(|data| *data <= end) {
            Some(data) => Ok(Some(Self { contents, data, end, cut })),
            None if cut => Ok(None),
            None => Err(format!("the data of the segment at byte {place} lie beyond its end")),
        }
    }
}
