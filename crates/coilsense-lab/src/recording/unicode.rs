//! Text in UTF-16, as spreadsheets and Windows write it, handed on as UTF-8.
//!
//! Next door: rows of text (`text`), where bytes come from (`input`).

use std::io::{self, Read};

use super::packing::{Bytes, spoilt};

/// Which of a unit's two bytes comes first.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Order {
    Little,
    Big,
}

impl Order {
    /// By the mark at the beginning; without one by the zero bytes that plain letters and digits have there.
    fn of(head: &[u8]) -> Option<Self> {
        match head {
            [0xff, 0xfe, ..] => return Some(Self::Little),
            [0xfe, 0xff, ..] => return Some(Self::Big),
            _ => {}
        }
        let pairs: Vec<[u8; 2]> = head.chunks_exact(2).take(16).map(|pair| [pair[0], pair[1]]).collect();
        let is_plain = |byte: u8| matches!(byte, b'\t' | b'\n' | b'\r' | b' '..=b'~');
        let all = |letter: usize| pairs.iter().all(|pair| is_plain(pair[letter]) && pair[1 - letter] == 0);
        match pairs.len() {
            0 | 1 => None,
            _ if all(0) => Some(Self::Little),
            _ if all(1) => Some(Self::Big),
            _ => None,
        }
    }

    fn unit(self, pair: [u8; 2]) -> u16 {
        match self {
            Self::Little => u16::from_le_bytes(pair),
            Self::Big => u16::from_be_bytes(pair),
        }
    }
}

/// UTF-8 of a text that begins with `head`, and whether it was UTF-16; any other text as it is.
pub(super) fn recoded(head: &[u8], text: Bytes) -> (Bytes, bool) {
    match Order::of(head) {
        Some(order) => {
            (Box::new(Recoded { inner: text, order, raw: vec![0; RAW], kept: 0, out: Vec::new(), given: 0 }), true)
        }
        None => (text, false),
    }
}

/// Bytes that are recoded at once.
const RAW: usize = 1 << 16;

/// A text on its way from UTF-16 to UTF-8.
struct Recoded {
    inner: Bytes,
    order: Order,
    raw: Vec<u8>,
    /// How many of them wait for what completes their character.
    kept: usize,
    out: Vec<u8>,
    /// How many of those were handed on.
    given: usize,
}

impl Recoded {
    /// Recodes what comes next; at the end nothing is there.
    fn advance(&mut self) -> io::Result<()> {
        (self.given, self.out) = (0, std::mem::take(&mut self.out));
        self.out.clear();
        while self.out.is_empty() {
            let read = self.inner.read(&mut self.raw[self.kept..])?;
            let there = self.kept + read;
            if read == 0 {
                if there % 2 == 1 {
                    return Err(spoilt("is cut off: it is UTF-16 and ends in the middle of a character".to_owned()));
                }
                if there > 0 {
                    self.out.extend_from_slice("\u{fffd}".as_bytes());
                }
                self.kept = 0;
                return Ok(());
            }
            let pairs = self.raw[..there].chunks_exact(2);
            let mut units: Vec<u16> = pairs.map(|pair| self.order.unit([pair[0], pair[1]])).collect();
            // The first half of a character whose other half comes next.
            if units.last().is_some_and(|last| (0xd800..0xdc00).contains(last)) {
                units.pop();
            }
            let mut letter = [0; 4];
            for next in char::decode_utf16(units.iter().copied()) {
                let next = next.unwrap_or(char::REPLACEMENT_CHARACTER);
                self.out.extend_from_slice(next.encode_utf8(&mut letter).as_bytes());
            }
            self.raw.copy_within(2 * units.len()..there, 0);
            self.kept = there - 2 * units.len();
        }
        Ok(())
    }
}

impl Read for Recoded {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        if self.given == self.out.len() {
            self.advance()?;
        }
        let left = &self.out[self.given..];
        let count = left.len().min(buffer.len());
        buffer[..count].copy_from_slice(&left[..count]);
        self.given += count;
        Ok(count)
    }
}

#[cfg(test)]
mod tests {
    use std::io::{self, Read};

    use super::super::packing::told;
    use super::recoded;

    /// Hands out so many bytes at once.
    struct Slowly(Vec<u8>, usize);

    impl Read for Slowly {
        fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
            let count = self.1.min(self.0.len()).min(buffer.len());
            buffer[..count].copy_from_slice(&self.0[..count]);
            self.0.drain(..count);
            Ok(count)
        }
    }

    #[test]
    fn every_order_of_bytes_gives_the_text_however_it_is_parted() {
        let text = "\u{feff}Zeit [s];F_o [N]\n0,5;µ 𝄞\n";
        for (order, at_once) in [(false, 1), (false, 3), (true, 1), (true, 7), (true, 1 << 20)] {
            let bytes: Vec<u8> = text
                .encode_utf16()
                .flat_map(|unit| if order { unit.to_be_bytes() } else { unit.to_le_bytes() })
                .collect();
            let (mut reader, is_wide) = recoded(&bytes[..8], Box::new(Slowly(bytes.clone(), at_once)));
            let mut found = String::new();
            reader.read_to_string(&mut found).unwrap();
            assert!(is_wide && found == text, "{found:?}");
        }
    }

    #[test]
    fn a_mark_may_be_missing_and_other_texts_stay() {
        let wide: Vec<u8> = "time\n0\n".encode_utf16().flat_map(u16::to_be_bytes).collect();
        assert!(recoded(&wide, Box::new(io::empty())).1);
        for other in [&b"time;F"[..], b"\xef\xbb\xbfa", b"\0\0\0\0", b"T\0", b"", b"a\0b\x01"] {
            assert!(!recoded(other, Box::new(io::empty())).1, "{other:?}");
        }
    }

    #[test]
    fn half_a_character_at_the_end_is_said() {
        let (mut reader, _) = recoded(b"\xff\xfe", Box::new(Slowly(b"\xff\xfe1\x002".to_vec(), 8)));
        let error = reader.read_to_end(&mut Vec::new()).unwrap_err();
        assert_eq!(told(&error), "is cut off: it is UTF-16 and ends in the middle of a character");
        let (mut reader, _) = recoded(b"\xff\xfe", Box::new(Slowly(b"\xff\xfe1\x00\x34\xd8".to_vec(), 8)));
        let mut text = String::new();
        reader.read_to_string(&mut text).unwrap();
        assert_eq!(text, "\u{feff}1\u{fffd}");
    }
}
