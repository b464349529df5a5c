//! The types of values, and what their bytes mean.
//!
//! Next door: where the values lie (`index`, `data`).

/// A type of values.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    Int8,
    Int16,
    Int32,
    Int64,
    Uint8,
    Uint16,
    Uint32,
    Uint64,
    Float,
    Double,
    Bool,
    /// Seconds since 1904 and fractions of 2^-64 s.
    Stamp,
    Text,
    /// No values at all.
    Void,
    /// Complex numbers of so many bytes.
    Complex(usize),
    /// What the scalers of a card make of its own bytes.
    Card,
}

/// Fractions of a stamp in a second.
pub(super) const SECOND: f64 = 18_446_744_073_709_551_616.0;

impl Kind {
    /// By its number in a channel's index or a property.
    pub fn of(code: u32) -> Result<Self, String> {
        Ok(match code {
            0 => Self::Void,
            1 => Self::Int8,
            2 => Self::Int16,
            3 => Self::Int32,
            4 => Self::Int64,
            5 => Self::Uint8,
            6 => Self::Uint16,
            7 => Self::Uint32,
            8 => Self::Uint64,
            9 | 0x19 => Self::Float,
            10 | 0x1a => Self::Double,
            0x20 => Self::Text,
            0x21 => Self::Bool,
            0x44 => Self::Stamp,
            0x08_000c => Self::Complex(8),
            0x10_000d => Self::Complex(16),
            0xffff_ffff => Self::Card,
            11 | 0x1b => return Err("it holds extended floats, which only LabVIEW reads".to_owned()),
            other => return Err(format!("its data type {other:#x} is not known")),
        })
    }

    /// By its number in a scaler of a card.
    pub fn of_card(code: u32) -> Result<Self, String> {
        const KINDS: [Kind; 10] = [
            Kind::Uint8,
            Kind::Int8,
            Kind::Uint16,
            Kind::Int16,
            Kind::Uint32,
            Kind::Int32,
            Kind::Uint64,
            Kind::Int64,
            Kind::Float,
            Kind::Double,
        ];
        let kind = if code == u32::MAX { Some(Self::Stamp) } else { KINDS.get(code as usize).copied() };
        kind.ok_or_else(|| format!("the data type {code:#x} of a DAQmx scaler is not known"))
    }

    /// Bytes of a value, where all have the same number.
    pub fn size(self) -> Option<usize> {
        Some(match self {
            Self::Int8 | Self::Uint8 | Self::Bool => 1,
            Self::Int16 | Self::Uint16 => 2,
            Self::Int32 | Self::Uint32 | Self::Float => 4,
            Self::Int64 | Self::Uint64 | Self::Double => 8,
            Self::Stamp => 16,
            Self::Complex(size) => size,
            Self::Text | Self::Void | Self::Card => return None,
        })
    }

    /// Whether its values are numbers.
    pub fn is_number(self) -> bool {
        !matches!(self, Self::Stamp | Self::Text | Self::Void | Self::Complex(_) | Self::Card)
    }

    /// The number that bytes mean, of which there are [`Self::size`]; NaN of what is none.
    pub fn number(self, bytes: &[u8], big_endian: bool) -> f64 {
        let Some(whole) = whole(bytes, big_endian) else { return f64::NAN };
        match self {
            Self::Int8 => f64::from(whole as u8 as i8),
            Self::Int16 => f64::from(whole as u16 as i16),
            Self::Int32 => f64::from(whole as u32 as i32),
            Self::Int64 => whole as i64 as f64,
            Self::Uint8 | Self::Uint16 | Self::Uint32 | Self::Uint64 => whole as f64,
            Self::Float => f64::from(f32::from_bits(whole as u32)),
            Self::Double => f64::from_bits(whole),
            Self::Bool => f64::from(u8::from(whole != 0)),
            Self::Stamp | Self::Text | Self::Void | Self::Complex(_) | Self::Card => f64::NAN,
        }
    }
}

/// The bits of at most eight bytes.
pub(super) fn whole(bytes: &[u8], big_endian: bool) -> Option<u64> {
    if bytes.len() > 8 {
        return None;
    }
    let join = |all: u64, byte: &u8| all << 8 | u64::from(*byte);
    Some(if big_endian { bytes.iter().fold(0, join) } else { bytes.iter().rev().fold(0, join) })
}

/// Fractions of 2^-64 s since 1904 of the sixteen bytes of a stamp.
pub(super) fn stamp(bytes: &[u8], big_endian: bool) -> Option<i128> {
    let halves = bytes.split_at_checked(8)?;
    let (seconds, fractions) = if big_endian { halves } else { (halves.1, halves.0) };
    let seconds = whole(seconds, big_endian)? as i64;
    Some((i128::from(seconds) << 64) + i128::from(whole(fractions, big_endian)?))
}
