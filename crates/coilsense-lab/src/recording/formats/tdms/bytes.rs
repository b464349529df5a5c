//! The bytes of a segment's metadata, one value after the other, none beyond their end.
//!
//! Next door: what the values mean (`metadata`, `index`, `properties`).

/// What is left of them.
pub(super) struct Bytes<'a> {
    rest: &'a [u8],
    big_endian: bool,
}

impl<'a> Bytes<'a> {
    pub fn of(bytes: &'a [u8], big_endian: bool) -> Self {
        Self { rest: bytes, big_endian }
    }

    pub fn take(&mut self, count: usize) -> Result<&'a [u8], String> {
        let (taken, rest) = self.rest.split_at_checked(count).ok_or("it is cut off in its metadata")?;
        self.rest = rest;
        Ok(taken)
    }

    pub fn byte(&mut self) -> Result<u8, String> {
        Ok(self.take(1)?[0])
    }

    pub fn word(&mut self) -> Result<u32, String> {
        let mut four = [0; 4];
        four.copy_from_slice(self.take(4)?);
        Ok(if self.big_endian { u32::from_be_bytes(four) } else { u32::from_le_bytes(four) })
    }

    pub fn long(&mut self) -> Result<u64, String> {
        let mut eight = [0; 8];
        eight.copy_from_slice(self.take(8)?);
        Ok(if self.big_endian { u64::from_be_bytes(eight) } else { u64::from_le_bytes(eight) })
    }

    /// A text behind its length.
    pub fn text(&mut self) -> Result<&'a [u8], String> {
        let length = self.word()? as usize;
        self.take(length)
    }

    pub fn big_endian(&self) -> bool {
        self.big_endian
    }
}
