//! The blocks of a file, each found by its address in another one.
//!
//! Next door: what conversions do (`conversion`), the records of a group (`records`).

use super::conversion::Conversion;

/// A file's bytes.
pub(super) struct Reader<'a> {
    bytes: &'a [u8],
}

/// A channel.
#[derive(Debug, Clone)]
pub(super) struct Channel {
    pub name: String,
    pub unit: String,
    pub conversion: Conversion,
    pub is_clock: bool,
    /// Whether it holds numbers, and not texts or bytes.
    pub is_number: bool,
    /// Where its bits lie in a record.
    pub byte: usize,
    pub bit: u32,
    pub bits: u32,
    pub kind: Kind,
    pub big_endian: bool,
}

/// What bits mean.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    Unsigned,
    Signed,
    Float,
}

/// Channels that are sampled together.
#[derive(Debug, Clone)]
pub(super) struct Channels {
    pub channels: Vec<Channel>,
    pub record: u16,
    /// Bytes of a record without its number.
    pub size: usize,
    pub count: usize,
}

/// A block of data, and the groups whose records it holds.
#[derive(Debug, Clone)]
pub(super) struct Data {
    pub groups: Vec<Channels>,
    pub place: usize,
    /// Whether a record's number stands before it, and behind it, too.
    pub numbered: [bool; 2],
}

/// Most channels of a file, and groups.
const MOST_CHANNELS: usize = 100_000;
const MOST_GROUPS: usize = 10_000;

const CUT: &str = "it is cut off";

impl<'a> Reader<'a> {
    pub fn of(bytes: &'a [u8]) -> Result<Self, String> {
        let reader = Self { bytes };
        if reader.short(24)? != 0 {
            return Err("it is in Motorola's byte order".to_owned());
        }
        Ok(reader)
    }

    /// The version as it is written.
    pub fn version(&self) -> String {
        let version = self.bytes.get(8..16).unwrap_or_default();
        String::from_utf8_lossy(version).trim_matches(['\0', ' ']).chars().filter(|c| !c.is_control()).collect()
    }

    /// All blocks of data.
    pub fn data(&self) -> Result<Vec<Data>, String> {
        let (mut all, mut place, mut channels, mut groups) = (Vec::new(), self.address(64 + 4)?, 0, 0);
        while let Some(at) = place {
            self.is(at, b"DG")?;
            let numbers = self.short(at + 22)?;
            let (mut within, mut group) = (Vec::new(), self.address(at + 8)?);
            while let Some(at) = group {
                groups += 1;
                if groups > MOST_GROUPS {
                    return Err(format!("it has more than {MOST_GROUPS} groups"));
                }
                within.push(self.group(at, &mut channels)?);
                group = self.address(at + 4)?;
            }
            if let Some(place) = self.address(at + 16)? {
                all.push(Data { groups: within, place, numbered: [numbers >= 1, numbers >= 2] });
            }
            groups += 1;
            if groups > MOST_GROUPS {
                return Err(format!("it has more than {MOST_GROUPS} groups"));
            }
            place = self.address(at + 4)?;
        }
        Ok(all)
    }

    fn group(&self, at: usize, count: &mut usize) -> Result<Channels, String> {
        self.is(at, b"CG")?;
        let (mut channels, mut place) = (Vec::new(), self.address(at + 8)?);
        while let Some(at) = place {
            *count += 1;
            if *count > MOST_CHANNELS {
                return Err(format!("it has more than {MOST_CHANNELS} channels"));
            }
            channels.push(self.channel(at)?);
            place = self.address(at + 4)?;
        }
        let size = usize::from(self.short(at + 20)?);
        let inside = |channel: &Channel| channel.byte + (channel.bit + channel.bits).div_ceil(8) as usize <= size;
        if !channels.iter().filter(|channel| channel.is_number).all(inside) {
            return Err("a channel lies outside of its record".to_owned());
        }
        Ok(Channels { channels, record: self.short(at + 16)?, size, count: self.word(at + 22)? as usize })
    }

    fn channel(&self, at: usize) -> Result<Channel, String> {
        self.is(at, b"CN")?;
        let length = self.short(at + 2)?;
        let long = if length >= 222 { self.address(at + 218)? } else { None };
        let name = match long {
            Some(place) => self.text(place)?,
            None => self.words(at + 26, 32)?,
        };
        let further = if length >= 228 { self.short(at + 226)? } else { 0 };
        let (start, bits) = (self.short(at + 186)?, u32::from(self.short(at + 188)?));
        let kind = match self.short(at + 190)? {
            0 | 9 | 13 => Some(Kind::Unsigned),
            1 | 10 | 14 => Some(Kind::Signed),
            2 | 3 | 11 | 12 | 15 | 16 => Some(Kind::Float),
            _ => None,
        };
        let big_endian = (9..=12).contains(&self.short(at + 190)?);
        let fits = match kind {
            Some(Kind::Float) => bits == 32 || bits == 64,
            Some(_) => (1..=64).contains(&bits),
            None => false,
        };
        let (unit, conversion) = match self.address(at + 8)? {
            Some(place) => self.conversion(place)?,
            None => (String::new(), Conversion::None),
        };
        Ok(Channel {
            // Behind a stroke some recorders write their device's name.
            name: name.split('\\').next().unwrap_or_default().to_owned(),
            unit,
            conversion,
            is_clock: self.short(at + 24)? == 1,
            is_number: fits,
            byte: usize::from(start / 8) + usize::from(further),
            bit: u32::from(start % 8),
            bits,
            kind: kind.unwrap_or(Kind::Unsigned),
            big_endian,
        })
    }

    fn conversion(&self, at: usize) -> Result<(String, Conversion), String> {
        self.is(at, b"CC")?;
        let (kind, count) = (self.short(at + 42)?, usize::from(self.short(at + 44)?));
        let parameters = |count: usize| {
            (0..count).map(|index| self.double(at + 46 + 8 * index)).collect::<Result<Vec<f64>, String>>()
        };
        let wanted = match kind {
            0 => 2,
            1 | 2 => 2 * count,
            6 | 9 => 6,
            7 | 8 => 7,
            _ => 0,
        };
        Ok((self.words(at + 22, 20)?, Conversion::of(kind, &parameters(wanted)?)))
    }

    /// Refuses an address that leads to another kind of block.
    fn is(&self, at: usize, name: &[u8; 2]) -> Result<(), String> {
        if self.take(at, 2)? == name {
            Ok(())
        } else {
            Err(format!("at byte {at} no {} begins", String::from_utf8_lossy(name)))
        }
    }

    fn take(&self, at: usize, count: usize) -> Result<&'a [u8], String> {
        self.bytes.get(at..).and_then(|bytes| bytes.get(..count)).ok_or_else(|| CUT.to_owned())
    }

    fn short(&self, at: usize) -> Result<u16, String> {
        let bytes = self.take(at, 2)?;
        Ok(u16::from_le_bytes([bytes[0], bytes[1]]))
    }

    fn word(&self, at: usize) -> Result<u32, String> {
        let bytes = self.take(at, 4)?;
        Ok(u32::from_le_bytes([bytes[0], bytes[1], bytes[2], bytes[3]]))
    }

    fn double(&self, at: usize) -> Result<f64, String> {
        let mut eight = [0; 8];
        eight.copy_from_slice(self.take(at, 8)?);
        Ok(f64::from_le_bytes(eight))
    }

    /// An address; none where it is zero.
    fn address(&self, at: usize) -> Result<Option<usize>, String> {
        Ok(Some(self.word(at)? as usize).filter(|place| *place != 0))
    }

    /// A text in a block of its own.
    fn text(&self, at: usize) -> Result<String, String> {
        self.is(at, b"TX")?;
        let length = usize::from(self.short(at + 2)?).saturating_sub(4);
        self.words(at + 4, length)
    }

    /// Latin-1 up to a zero.
    fn words(&self, at: usize, count: usize) -> Result<String, String> {
        let bytes = self.take(at, count)?.split(|byte| *byte == 0).next().unwrap_or_default();
        Ok(bytes.iter().map(|byte| char::from(*byte)).collect::<String>().trim().to_owned())
    }
}
