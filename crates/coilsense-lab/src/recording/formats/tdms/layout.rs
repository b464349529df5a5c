//! How the chunks of a segment are laid out: channel behind channel, value by value, or in the buffers of a card.
//!
//! Next door: a single channel's part (`index`), the segments (`metadata`), reading them (`data`).

use std::rc::Rc;

use super::index::Index;
use super::kind::Kind;

/// An object in the list of a segment.
#[derive(Debug, Clone)]
pub(super) struct Entry {
    pub object: usize,
    pub index: Option<Rc<Index>>,
    pub has_data: bool,
}

/// A chunk of a segment.
#[derive(Debug, Default)]
pub(super) struct Layout {
    /// Channels with values, in their order, and the index of each.
    pub channels: Vec<(usize, Rc<Index>)>,
    /// Buffers of a card.
    pub buffers: Vec<Buffer>,
    /// Bytes of the whole chunk.
    pub bytes: u64,
}

/// A buffer of a card, which holds rows of all channels' scalers.
#[derive(Debug, Clone, Default)]
pub(super) struct Buffer {
    pub rows: u64,
    pub width: u64,
    /// Places in `channels`, and which of their scalers.
    pub scalers: Vec<(usize, usize)>,
}

/// How much of a chunk there is.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum Part {
    /// All of it.
    Whole,
    /// So many values of each channel.
    Values(Vec<u64>),
    /// So many rows of each buffer.
    Rows(Vec<u64>),
}

/// Longest row of a card's buffer or of interleaved values.
const LONGEST_ROW: u64 = 1 << 22;

impl Layout {
    pub fn of(list: &[Entry]) -> Result<Self, String> {
        let with_data = list.iter().filter(|entry| entry.has_data).filter_map(|entry| {
            let index = entry.index.as_ref().filter(|index| index.values > 0)?;
            Some((entry.object, Rc::clone(index)))
        });
        let mut layout = Self { channels: with_data.collect(), ..Self::default() };
        let cards = layout.channels.iter().filter(|(_, index)| index.card.is_some()).count();
        if cards == 0 {
            let sizes = layout.channels.iter().map(|(_, index)| index.bytes);
            layout.bytes = sizes.into_iter().try_fold(0, u64::checked_add).ok_or("its sizes are impossible")?;
            return Ok(layout);
        }
        if cards != layout.channels.len() {
            return Err("a segment has channels of DAQmx and others".to_owned());
        }
        layout.lay_buffers()?;
        Ok(layout)
    }

    fn lay_buffers(&mut self) -> Result<(), String> {
        let mut widths: Option<&[u32]> = None;
        let mut buffers: Vec<Buffer> = Vec::new();
        for (place, (_, index)) in self.channels.iter().enumerate() {
            let Some(card) = &index.card else { continue };
            if widths.is_some_and(|widths| widths != card.widths) {
                return Err("DAQmx channels of a segment tell different widths".to_owned());
            }
            if widths.is_none() {
                widths = Some(&card.widths);
                let empty = |width: &u32| Buffer { width: u64::from(*width), ..Buffer::default() };
                buffers = card.widths.iter().map(empty).collect();
            }
            for (which, scaler) in card.scalers.iter().enumerate() {
                let buffer = buffers.get_mut(scaler.buffer).ok_or("a DAQmx scaler lies outside of its buffer")?;
                buffer.rows = buffer.rows.max(index.values);
                buffer.scalers.push((place, which));
            }
        }
        buffers.retain(|buffer| buffer.rows > 0);
        if buffers.iter().any(|buffer| buffer.width > LONGEST_ROW) {
            return Err("a DAQmx buffer has rows of more than 4 MiB".to_owned());
        }
        let sizes = buffers.iter().map(|buffer| buffer.rows.checked_mul(buffer.width));
        let bytes = sizes.into_iter().try_fold(0_u64, |sum, size| sum.checked_add(size?));
        self.bytes = bytes.ok_or("its sizes are impossible")?;
        self.buffers = buffers;
        Ok(())
    }

    /// Bytes of a row where values are interleaved; `None` where a single channel of texts is only called so.
    pub fn row(&self) -> Result<Option<u64>, String> {
        let sizes: Vec<Option<usize>> = self.channels.iter().map(|(_, index)| index.kind.size()).collect();
        if let [None] = sizes.as_slice() {
            return Ok(None);
        }
        let Some(sizes) = sizes.into_iter().collect::<Option<Vec<usize>>>() else {
            return Err("interleaved channels hold texts".to_owned());
        };
        let values = |place: usize| self.channels.get(place).map(|(_, index)| index.values);
        if (1..self.channels.len()).any(|place| values(place) != values(0)) {
            return Err("interleaved channels have different numbers of values".to_owned());
        }
        let row = sizes.iter().sum::<usize>() as u64;
        if row > LONGEST_ROW {
            Err("interleaved channels have rows of more than 4 MiB".to_owned())
        } else {
            Ok(Some(row))
        }
    }

    /// What there is of a chunk of which only some bytes are left; `cut` where the file ends there.
    ///
    /// As npTDMS does: where the segment itself is too short, each channel has its share.
    pub fn part(&self, left: u64, interleaved: bool, cut: bool) -> Part {
        if !self.buffers.is_empty() {
            let mut left = left;
            let rows = self.buffers.iter().map(|buffer| {
                let rows = (left / buffer.width).min(buffer.rows);
                left -= if rows == buffer.rows { rows * buffer.width } else { left };
                rows
            });
            return Part::Rows(rows.collect());
        }
        if self.channels.iter().any(|(_, index)| index.kind.size().is_none()) {
            return Part::Values(vec![0; self.channels.len()]);
        }
        let mut left_over = left;
        let values = self.channels.iter().map(|(_, index)| {
            if interleaved || !cut {
                return (u128::from(index.values) * u128::from(left) / u128::from(self.bytes.max(1))) as u64;
            }
            let values = (left_over / index.kind.size().unwrap_or(1) as u64).min(index.values);
            left_over -= if values == index.values { index.bytes } else { left_over };
            values
        });
        Part::Values(values.collect())
    }

    /// Numbers that a chunk, or a part of one, adds to what is held in memory.
    pub fn numbers(&self, part: &Part) -> u64 {
        let kept = |index: &Index| index.kind.is_number() || index.kind == Kind::Stamp;
        let all = |values: &dyn Fn(usize) -> u64| -> u64 {
            let plain = self.channels.iter().enumerate().filter(|(_, (_, index))| index.card.is_none() && kept(index));
            plain.map(|(place, _)| values(place)).fold(0, u64::saturating_add)
        };
        let of_buffers = |rows: &dyn Fn(usize) -> u64| -> u64 {
            let buffers = self.buffers.iter().enumerate();
            buffers
                .map(|(place, buffer)| rows(place).saturating_mul(buffer.scalers.len() as u64))
                .fold(0, u64::saturating_add)
        };
        match part {
            Part::Whole => all(&|place| self.channels[place].1.values)
                .saturating_add(of_buffers(&|place| self.buffers[place].rows)),
            Part::Values(values) => all(&|place| values[place]),
            Part::Rows(rows) => of_buffers(&|place| rows[place]),
        }
    }
}
