//! The elements of a MATLAB file of version 5 to 7, one after the other: a tag of type and size, and its bytes, padded to eight.
//!
//! Next door: what they mean (`level5`).

use std::io::Read;

/// Elements from a file, or from what is unpacked of one.
pub(super) struct Elements<R> {
    reader: R,
    big_endian: bool,
    /// Bytes so far.
    pub read: u64,
}

/// Type and size of an element.
#[derive(Debug, Clone, Copy)]
pub(super) struct Tag {
    pub kind: u32,
    pub size: u64,
    /// The bytes of an element of at most four, which stand in its tag.
    inside: Option<[u8; 4]>,
}

/// Most bytes of an element that is no array of numbers, such as the names of a struct's fields, and of a single name.
const LONGEST: u64 = 1 << 20;
const LONGEST_NAME: u64 = 4096;
/// Bytes that are turned into numbers at once; a multiple of eight.
const BLOCK: u64 = 1 << 16;

impl<R: Read> Elements<R> {
    pub fn of(reader: R, big_endian: bool) -> Self {
        Self { reader, big_endian, read: 0 }
    }

    /// The next tag.
    pub fn tag(&mut self) -> Result<Tag, String> {
        let mut first = [0; 4];
        self.exact(&mut first)?;
        let kind = self.word(first);
        let mut second = [0; 4];
        self.exact(&mut second)?;
        Ok(match kind >> 16 {
            0 => Tag { kind, size: u64::from(self.word(second)), inside: None },
            size => Tag { kind: kind & 0xffff, size: u64::from(size).min(4), inside: Some(second) },
        })
    }

    /// The bytes of an element that is not long.
    pub fn bytes(&mut self, tag: Tag) -> Result<Vec<u8>, String> {
        if let Some(inside) = tag.inside {
            return Ok(inside[..tag.size as usize].to_vec());
        }
        if tag.size > LONGEST {
            return Err("its names and sizes are longer than 1 MiB".to_owned());
        }
        let mut bytes = vec![0; tag.size as usize];
        self.exact(&mut bytes)?;
        self.pad(tag)?;
        Ok(bytes)
    }

    /// A text.
    pub fn text(&mut self) -> Result<String, String> {
        let tag = self.tag()?;
        if tag.size > LONGEST_NAME {
            return Err("a name in it is longer than 4 kiB".to_owned());
        }
        Ok(String::from_utf8_lossy(&self.bytes(tag)?).trim_end_matches('\0').to_owned())
    }

    /// Whole numbers of 32 bits.
    pub fn words(&mut self) -> Result<Vec<u32>, String> {
        let tag = self.tag()?;
        let bytes = self.bytes(tag)?;
        Ok(bytes.chunks_exact(4).map(|four| self.word([four[0], four[1], four[2], four[3]])).collect())
    }

    /// The numbers of the next element, of which there may be at most so many.
    pub fn numbers(&mut self, most: u64) -> Result<Vec<f64>, String> {
        let tag = self.tag()?;
        let (size, number) = number(tag.kind, self.big_endian).ok_or("an array in it has no numbers")?;
        let count = tag.size / size;
        if count > most {
            return Err("it is too large to be held in memory".to_owned());
        }
        if let Some(inside) = tag.inside {
            return Ok(inside[..tag.size as usize].chunks_exact(size as usize).map(number).collect());
        }
        let mut numbers = Vec::with_capacity(count.min(BLOCK) as usize);
        let mut left = count * size;
        let mut block = vec![0; left.min(BLOCK) as usize];
        while left > 0 {
            block.truncate(left.min(BLOCK) as usize);
            self.exact(&mut block)?;
            numbers.extend(block.chunks_exact(size as usize).map(number));
            left -= block.len() as u64;
        }
        self.skip(tag.size % size)?;
        self.pad(tag)?;
        Ok(numbers)
    }

    /// Passes over bytes.
    pub fn skip(&mut self, count: u64) -> Result<(), String> {
        let passed = std::io::copy(&mut (&mut self.reader).take(count), &mut std::io::sink());
        self.read += count;
        if passed.map_err(|error| damage(&error))? == count { Ok(()) } else { Err(CUT.to_owned()) }
    }

    /// Reads what is left, so that a checksum at the end is looked at.
    pub fn end(&mut self) -> Result<(), String> {
        std::io::copy(&mut self.reader, &mut std::io::sink()).map(|_| ()).map_err(|error| damage(&error))
    }

    fn pad(&mut self, tag: Tag) -> Result<(), String> {
        self.skip(tag.size.wrapping_neg() % 8)
    }

    fn exact(&mut self, bytes: &mut [u8]) -> Result<(), String> {
        self.read += bytes.len() as u64;
        self.reader.read_exact(bytes).map_err(|error| damage(&error))
    }

    fn word(&self, bytes: [u8; 4]) -> u32 {
        if self.big_endian { u32::from_be_bytes(bytes) } else { u32::from_le_bytes(bytes) }
    }
}

const CUT: &str = "it is cut off";

/// What is wrong where bytes do not come.
fn damage(error: &std::io::Error) -> String {
    match error.kind() {
        std::io::ErrorKind::UnexpectedEof => CUT.to_owned(),
        _ => "a compressed array is damaged".to_owned(),
    }
}

/// The number that bytes mean.
pub(super) type Meaning = fn(&[u8]) -> f64;

/// Bytes of a number of a type, and what they mean.
pub(super) fn number(kind: u32, big_endian: bool) -> Option<(u64, Meaning)> {
    macro_rules! of {
        ($kind:ty) => {{
            const SIZE: usize = size_of::<$kind>();
            fn bytes(from: &[u8]) -> [u8; SIZE] {
                let mut bytes = [0; SIZE];
                bytes.copy_from_slice(&from[..SIZE]);
                bytes
            }
            let read: Meaning = if big_endian {
                |from| <$kind>::from_be_bytes(bytes(from)) as f64
            } else {
                |from| <$kind>::from_le_bytes(bytes(from)) as f64
            };
            (SIZE as u64, read)
        }};
    }
    Some(match kind {
        1 => of!(i8),
        2 => of!(u8),
        3 => of!(i16),
        4 => of!(u16),
        5 => of!(i32),
        6 => of!(u32),
        7 => of!(f32),
        9 => of!(f64),
        12 => of!(i64),
        13 => of!(u64),
        _ => return None,
    })
}
