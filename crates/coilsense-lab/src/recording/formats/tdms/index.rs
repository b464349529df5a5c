//! Where the raw data of a channel lies in a chunk: its type and number of values, and of a DAQmx card its scalers.
//!
//! Next door: types (`kind`), which channels a segment has (`metadata`), reading them (`data`).

use super::bytes::Bytes;
use super::kind::Kind;

/// A channel's raw data index.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Index {
    pub kind: Kind,
    /// Values in a chunk.
    pub values: u64,
    /// Bytes in a chunk; of a card's channels none of their own.
    pub bytes: u64,
    pub card: Option<Card>,
}

/// How a channel lies in the buffers of its card.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Card {
    pub scalers: Vec<Scaler>,
    /// Bytes of a row in each buffer.
    pub widths: Vec<u32>,
}

/// One series of numbers in a card's buffer.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Scaler {
    pub scale: u32,
    pub kind: Kind,
    pub buffer: usize,
    pub offset: usize,
    /// Of a digital line its bit.
    pub bit: Option<u32>,
}

/// Headers of the index of a card's channel.
pub(super) const FORMAT_CHANGING: u32 = 0x1269;
pub(super) const DIGITAL_LINE: u32 = 0x126a;

impl Index {
    /// Reads what follows its header.
    pub fn read(header: u32, bytes: &mut Bytes<'_>) -> Result<Self, String> {
        let kind = Kind::of(bytes.word()?)?;
        if bytes.word()? != 1 {
            return Err("its data have more than one dimension".to_owned());
        }
        let values = bytes.long()?;
        if matches!(header, FORMAT_CHANGING | DIGITAL_LINE) {
            let card = Some(Card::read(header, kind, bytes)?);
            return Ok(Self { kind, values, bytes: 0, card });
        }
        let size = match kind {
            Kind::Text => bytes.long()?,
            _ if values == 0 => 0,
            _ => {
                let size = kind.size().ok_or("a channel of no type has values")?;
                values.checked_mul(size as u64).ok_or("its sizes are impossible")?
            }
        };
        Ok(Self { kind, values, bytes: size, card: None })
    }
}

impl Card {
    fn read(header: u32, kind: Kind, bytes: &mut Bytes<'_>) -> Result<Self, String> {
        let mut scalers = Vec::new();
        for _ in 0..bytes.word()? {
            scalers.push(Scaler::read(header, bytes)?);
        }
        if kind != Kind::Card && !matches!(scalers.as_slice(), [only] if only.kind == kind) {
            return Err("a DAQmx channel and its scaler are of two types".to_owned());
        }
        let mut widths = Vec::new();
        for _ in 0..bytes.word()? {
            widths.push(bytes.word()?);
        }
        let inside = |scaler: &Scaler| {
            let width = widths.get(scaler.buffer).copied().unwrap_or(0) as usize;
            scaler.kind.size().is_some_and(|size| scaler.offset.checked_add(size).is_some_and(|end| end <= width))
        };
        if !scalers.iter().all(inside) {
            return Err("a DAQmx scaler lies outside of its buffer".to_owned());
        }
        Ok(Self { scalers, widths })
    }
}

impl Scaler {
    fn read(header: u32, bytes: &mut Bytes<'_>) -> Result<Self, String> {
        let kind = Kind::of_card(bytes.word()?)?;
        let buffer = bytes.word()? as usize;
        let place = bytes.word()?;
        let (offset, bit) = match header {
            DIGITAL_LINE => {
                bytes.byte()?;
                (place as usize / 8, Some(place % 8))
            }
            _ => {
                bytes.word()?;
                (place as usize, None)
            }
        };
        Ok(Self { scale: bytes.word()?, kind, buffer, offset, bit })
    }
}
