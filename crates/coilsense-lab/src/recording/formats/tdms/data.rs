//! Reading the chunks of a segment: every channel's numbers behind those of the segments before.
//!
//! Next door: how chunks are laid out (`layout`), what is made of the numbers (`scaling`).

use std::fs::File;
use std::io::{BufReader, Read, Seek, SeekFrom};

use super::index::{Index, Scaler};
use super::kind::{self, Kind, SECOND};
use super::layout::{Layout, Part};

/// What a channel holds.
#[derive(Debug, Default)]
pub(super) struct Raw {
    pub kind: Option<Kind>,
    /// Its numbers; of stamps the seconds since the first.
    pub values: Vec<f64>,
    /// The first stamp.
    pub origin: Option<i128>,
    /// The numbers of each scaler of a card.
    pub scalers: Vec<(u32, Vec<f64>)>,
}

/// The data of one segment.
pub(super) struct Segment<'a> {
    pub layout: &'a Layout,
    pub start: u64,
    pub end: u64,
    pub interleaved: bool,
    pub big_endian: bool,
    /// Whether the file ends before the segment does.
    pub cut: bool,
}

/// A file's bytes, read in blocks.
pub(super) struct Blocks {
    reader: BufReader<File>,
    place: u64,
    block: Vec<u8>,
}

/// Bytes that are read at once.
const BLOCK: u64 = 1 << 16;

impl Raw {
    /// How many numbers it has.
    pub fn len(&self) -> usize {
        self.scalers.first().map_or(self.values.len(), |(_, values)| values.len())
    }

    pub fn is_stamps(&self) -> bool {
        self.kind == Some(Kind::Stamp)
    }

    /// The channel goes on with this type.
    fn goes_on(&mut self, kind: Kind) -> Result<(), String> {
        match self.kind.replace(kind) {
            Some(before) if before != kind => Err("a channel changes its type from one segment to the next".to_owned()),
            _ => Ok(()),
        }
    }

    fn push(&mut self, kind: Kind, bytes: &[u8], big_endian: bool) {
        if kind != Kind::Stamp {
            return self.values.push(kind.number(bytes, big_endian));
        }
        let Some(stamp) = kind::stamp(bytes, big_endian) else { return };
        let origin = *self.origin.get_or_insert(stamp);
        self.values.push(stamp.wrapping_sub(origin) as f64 / SECOND);
    }

    /// One more number of one of its scalers.
    fn push_scaler(&mut self, kind: Kind, scaler: &Scaler, bytes: &[u8], big_endian: bool) {
        let value = match scaler.bit {
            None if kind != Kind::Card => return self.push(kind, bytes, big_endian),
            None => scaler.kind.number(bytes, big_endian),
            Some(bit) => kind::whole(bytes, big_endian).map_or(f64::NAN, |all| (all >> bit & 1) as f64),
        };
        if kind != Kind::Card {
            return self.values.push(value);
        }
        let place = self.scalers.iter().position(|(scale, _)| *scale == scaler.scale).unwrap_or_else(|| {
            self.scalers.push((scaler.scale, Vec::new()));
            self.scalers.len() - 1
        });
        self.scalers[place].1.push(value);
    }
}

impl Blocks {
    pub fn of(file: File) -> Self {
        Self { reader: BufReader::with_capacity(BLOCK as usize, file), place: 0, block: Vec::new() }
    }

    pub fn seek(&mut self, place: u64) -> Result<(), String> {
        let by = place as i64 - self.place as i64;
        let moved = self.reader.seek_relative(by).or_else(|_| self.reader.seek(SeekFrom::Start(place)).map(|_| ()));
        self.place = place;
        moved.map_err(|error| format!("it cannot be read: {error}"))
    }

    /// The next bytes, of which there may be fewer.
    pub fn read(&mut self, count: u64) -> Result<&[u8], String> {
        self.block.clear();
        let read = (&mut self.reader).take(count).read_to_end(&mut self.block);
        self.place += read.map_err(|error| format!("it cannot be read: {error}"))? as u64;
        Ok(&self.block)
    }
}

impl Segment<'_> {
    /// Whole chunks, and what there is of one more.
    pub fn chunks(&self) -> Result<(u64, Option<Part>), String> {
        let (bytes, chunk) = (self.end - self.start, self.layout.bytes);
        if chunk == 0 {
            return if bytes == 0 { Ok((0, None)) } else { Err("a segment has data of no channel".to_owned()) };
        }
        let left = bytes % chunk;
        let part = (left > 0).then(|| self.layout.part(left, self.interleaved, self.cut));
        Ok((bytes / chunk, part))
    }

    /// Numbers that it adds.
    pub fn numbers(&self) -> Result<u64, String> {
        let (whole, part) = self.chunks()?;
        let partial = part.map_or(0, |part| self.layout.numbers(&part));
        Ok(self.layout.numbers(&Part::Whole).saturating_mul(whole).saturating_add(partial))
    }

    /// Reads it.
    pub fn read(&self, blocks: &mut Blocks, channels: &mut [Raw]) -> Result<(), String> {
        let (whole, part) = self.chunks()?;
        if whole == 0 && part.is_none() {
            return Ok(());
        }
        for (object, index) in &self.layout.channels {
            channels[*object].goes_on(index.kind)?;
        }
        let interleaved = self.interleaved && self.layout.buffers.is_empty();
        if let Some(row) = if interleaved { self.layout.row()? } else { None } {
            return self.read_rows(row, whole, part.as_ref(), blocks, channels);
        }
        for chunk in 0..whole {
            blocks.seek(self.start + chunk * self.layout.bytes)?;
            self.read_chunk(&Part::Whole, blocks, channels)?;
        }
        match part {
            Some(part) => {
                blocks.seek(self.start + whole * self.layout.bytes)?;
                self.read_chunk(&part, blocks, channels)
            }
            None => Ok(()),
        }
    }

    fn read_chunk(&self, part: &Part, blocks: &mut Blocks, channels: &mut [Raw]) -> Result<(), String> {
        if !self.layout.buffers.is_empty() {
            return self.read_buffers(part, blocks, channels);
        }
        for (place, (object, index)) in self.layout.channels.iter().enumerate() {
            let values = if let Part::Values(values) = part { values[place] } else { index.values };
            self.read_channel(index, values, blocks, &mut channels[*object])?;
        }
        Ok(())
    }

    fn read_channel(&self, index: &Index, values: u64, blocks: &mut Blocks, raw: &mut Raw) -> Result<(), String> {
        let kind = index.kind;
        let (true, Some(size)) = (kind.is_number() || kind == Kind::Stamp, kind.size()) else {
            let bytes = if values == index.values { index.bytes } else { values * kind.size().unwrap_or(0) as u64 };
            return blocks.seek(blocks.place + bytes);
        };
        let mut left = values;
        while left > 0 {
            let values = left.min(BLOCK / size as u64);
            let block = blocks.read(values * size as u64)?;
            if (block.len() as u64) < values * size as u64 {
                return Err("it is cut off".to_owned());
            }
            for value in block.chunks_exact(size) {
                raw.push(kind, value, self.big_endian);
            }
            left -= values;
        }
        Ok(())
    }

    /// Interleaved values, row by row.
    fn read_rows(
        &self,
        row: u64,
        whole: u64,
        part: Option<&Part>,
        blocks: &mut Blocks,
        channels: &mut [Raw],
    ) -> Result<(), String> {
        let Some((_, first)) = self.layout.channels.first() else { return Ok(()) };
        let partial = if let Some(Part::Values(values)) = part { values.first().copied().unwrap_or(0) } else { 0 };
        blocks.seek(self.start)?;
        each_row(blocks, row, whole * first.values + partial, |row, _| {
            let mut rest = row;
            for (object, index) in &self.layout.channels {
                let (value, others) = rest.split_at(index.kind.size().unwrap_or(0));
                if index.kind.is_number() || index.kind == Kind::Stamp {
                    channels[*object].push(index.kind, value, self.big_endian);
                }
                rest = others;
            }
        })
    }

    /// The buffers of a card, one behind the other.
    fn read_buffers(&self, part: &Part, blocks: &mut Blocks, channels: &mut [Raw]) -> Result<(), String> {
        for (place, buffer) in self.layout.buffers.iter().enumerate() {
            let rows = if let Part::Rows(rows) = part { rows[place] } else { buffer.rows };
            each_row(blocks, buffer.width, rows, |row, number| {
                for (channel, scaler) in &buffer.scalers {
                    let (object, index) = &self.layout.channels[*channel];
                    let Some(scaler) = index.card.as_ref().map(|card| card.scalers[*scaler]) else { continue };
                    let bytes = &row[scaler.offset..scaler.offset + scaler.kind.size().unwrap_or(0)];
                    if number < index.values {
                        channels[*object].push_scaler(index.kind, &scaler, bytes, self.big_endian);
                    }
                }
            })?;
        }
        Ok(())
    }
}

/// Hands out rows of bytes, and their numbers from 0.
fn each_row(blocks: &mut Blocks, width: u64, rows: u64, mut row: impl FnMut(&[u8], u64)) -> Result<(), String> {
    let mut done = 0;
    while done < rows {
        let count = (rows - done).min((BLOCK / width).max(1));
        let block = blocks.read(count * width)?;
        if (block.len() as u64) < count * width {
            return Err("it is cut off".to_owned());
        }
        for (bytes, number) in block.chunks_exact(width as usize).zip(done..) {
            row(bytes, number);
        }
        done += count;
    }
    Ok(())
}
