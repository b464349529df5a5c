//! What a chunk's file says of itself: of which plan it is, which chunk, which rows, and a digest over all of its bytes, so that neither a bit
//! that flips nor a file that is copied over another is taken for rows.
//!
//! All of it stands in the Parquet footer as key-value metadata, where every reader of Parquet passes over it. The digest is that of the whole
//! file with zeros in place of the digest's own digits: it is checked before anything is decoded.
//!
//! Next door: the columns as bytes (`encoded`), the folder (`dataset`).

use std::ops::Range;

use parquet::file::metadata::KeyValue;
use sha2::{Digest, Sha256};

use super::identity::hexadecimal;

/// Keys of the metadata.
const PLAN: &str = "coilsense.plan";
const CHUNK: &str = "coilsense.chunk";
const ROWS: &str = "coilsense.rows";
const DIGEST: &str = "coilsense.sha256";

/// Digits of a digest.
const DIGITS: usize = 64;

/// What stands before the digest's digits in a footer: its key, and as Thrift's compact protocol writes them, that a text follows and how long it is.
fn before() -> Vec<u8> {
    [DIGEST.as_bytes(), &[0x18, DIGITS as u8]].concat()
}

/// What a chunk's file is to say of itself.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Seal {
    /// The plan's digest.
    pub plan: String,
    /// The chunk's number.
    pub chunk: u64,
    /// Its rows.
    pub rows: Range<u64>,
}

impl Seal {
    /// The metadata of a file that is being written, with zeros for the digest.
    pub fn open(&self) -> Vec<KeyValue> {
        let own = self.entries().map(|(key, value)| KeyValue::new(key.to_owned(), value));
        own.into_iter().chain([KeyValue::new(DIGEST.to_owned(), "0".repeat(DIGITS))]).collect()
    }

    fn entries(&self) -> [(&'static str, String); 3] {
        let Range { start, end } = self.rows;
        [
            (PLAN, self.plan.clone()),
            (CHUNK, self.chunk.to_string()),
            (ROWS, format!("{start} to {}", end.saturating_sub(1))),
        ]
    }

    /// Whether the metadata of a file are those of this chunk, or which it is instead.
    pub fn check(&self, metadata: &[KeyValue]) -> Result<(), String> {
        let said = |key: &str| metadata.iter().rev().find(|entry| entry.key == key)?.value.as_deref();
        let differs = |(key, value): &(&'static str, String)| said(key) != Some(value);
        match self.entries().iter().find(|entry| differs(entry)) {
            None => Ok(()),
            Some((PLAN, _)) => Err("is a chunk of another sweep".to_owned()),
            Some(_) => Err(format!("holds rows {}, which are those of another chunk", said(ROWS).unwrap_or("unknown"))),
        }
    }
}

/// Puts the digest of a file's bytes into its place among them; whether it has one.
pub(super) fn close(bytes: &mut [u8]) -> bool {
    let Some(place) = place(bytes) else { return false };
    let digest = hexadecimal(digest(bytes, &place));
    bytes[place].copy_from_slice(digest.as_bytes());
    true
}

/// Whether a file's bytes are those that were written.
pub(super) fn whole(bytes: &[u8]) -> Result<(), &'static str> {
    let place = place(bytes).ok_or("is damaged or cut off: the digest at its end is missing")?;
    match hexadecimal(digest(bytes, &place)).as_bytes() == &bytes[place] {
        true => Ok(()),
        false => Err("is damaged: its bytes are not those that its digest was made of"),
    }
}

/// Where the digest's digits stand: behind the last of its keys, for the footer's metadata come after all else that may hold a text.
fn place(bytes: &[u8]) -> Option<Range<usize>> {
    let before = before();
    let start = before.len() + bytes.windows(before.len()).rposition(|window| window == before)?;
    (start + DIGITS <= bytes.len()).then_some(start..start + DIGITS)
}

/// The digest of bytes with zeros in a place.
fn digest(bytes: &[u8], place: &Range<usize>) -> impl AsRef<[u8]> {
    let mut digest = Sha256::new();
    digest.update(&bytes[..place.start]);
    digest.update([b'0'; DIGITS]);
    digest.update(&bytes[place.end..]);
    digest.finalize()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sealed() -> Vec<u8> {
        let mut bytes = [b"pages".as_slice(), &before(), &[b'0'; DIGITS], b"footer"].concat();
        assert!(close(&mut bytes));
        bytes
    }

    #[test]
    fn each_bit_and_each_length_counts() {
        let good = sealed();
        assert_eq!(whole(&good), Ok(()));
        for bit in 0..8 * good.len() {
            let mut bytes = good.clone();
            bytes[bit / 8] ^= 1 << (bit % 8);
            assert!(whole(&bytes).is_err(), "bit {bit}");
        }
        for length in 0..good.len() {
            assert!(whole(&good[..length]).is_err(), "{length}");
        }
        assert!(whole(&[&good[..], b"x"].concat()).is_err());
        assert!(whole(&[&good[..], &good[..]].concat()).is_err());
    }

    #[test]
    fn bytes_without_a_place_for_the_digest_are_not_closed() {
        assert!(!close(&mut b"PAR1PAR1".to_vec()));
        assert!(!close(&mut before()));
    }

    #[test]
    fn another_chunk_and_another_plan_are_told_apart() {
        let seal = Seal { plan: "a".to_owned(), chunk: 1, rows: 8..16 };
        assert_eq!(seal.check(&seal.open()), Ok(()));
        let copied = Seal { chunk: 2, rows: 16..24, ..seal.clone() };
        assert_eq!(seal.check(&copied.open()).unwrap_err(), "holds rows 16 to 23, which are those of another chunk");
        let other = Seal { plan: "b".to_owned(), ..seal.clone() };
        assert_eq!(seal.check(&other.open()).unwrap_err(), "is a chunk of another sweep");
        assert!(seal.check(&[]).is_err());
    }
}
