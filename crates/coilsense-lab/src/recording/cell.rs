//! One cell of a text: a number, a time stamp, nothing, or something else; and where a line's cells begin and end.
//!
//! Next door: numbers (`numeral`), dates and times of day (`stamp`), which signs part and mark them (`layout`), whole files (`text`).

use std::ops::Range;

use super::numeral::number;
use super::stamp::Stamp;

/// What parts the cells of a line.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Delimiter {
    /// One character.
    Sign(u8),
    /// Any number of spaces and tabs.
    Space,
}

/// What a cell holds.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Cell {
    /// A number; may be infinite.
    Number(f64),
    /// A date, a time of day, or both; or a duration.
    Stamp(Stamp),
    /// Nothing, or one of the words that mean so.
    Missing,
    /// Anything else.
    Text,
}

/// Words that mean "no value", in lower case.
const MISSING: [&str; 9] = ["nan", "na", "n/a", "#n/a", "null", "none", "-", "--", "missing"];

/// Finds the cells of a line; a delimiter between quotes does not part.
pub(super) fn split(line: &[u8], delimiter: Delimiter, cells: &mut Vec<Range<usize>>) {
    cells.clear();
    let parts = |byte: u8| match delimiter {
        Delimiter::Sign(sign) => byte == sign,
        Delimiter::Space => byte == b' ' || byte == b'\t',
    };
    let (mut start, mut quoted) = (0, false);
    for (index, &byte) in line.iter().enumerate() {
        if byte == b'"' {
            quoted = !quoted;
        } else if !quoted && parts(byte) {
            cells.push(start..index);
            start = index + 1;
        }
    }
    cells.push(start..line.len());
    if delimiter == Delimiter::Space {
        cells.retain(|cell| !cell.is_empty());
    }
}

/// A cell without spaces and quotes around it.
pub(super) fn bare(cell: &[u8]) -> &[u8] {
    let cell = cell.trim_ascii();
    match cell {
        [b'"', inner @ .., b'"'] => inner.trim_ascii(),
        _ => cell,
    }
}

/// A cell as text; what is not UTF-8 is Latin-1, as old instruments write it.
pub(super) fn words(cell: &[u8]) -> String {
    let cell = bare(cell);
    let text =
        std::str::from_utf8(cell).map_or_else(|_| cell.iter().map(|&byte| char::from(byte)).collect(), str::to_owned);
    text.replace("\"\"", "\"")
}

impl Cell {
    /// Reads a cell.
    pub fn of(cell: &[u8], decimal_comma: bool) -> Self {
        let cell = bare(cell);
        if cell.is_empty() {
            return Self::Missing;
        }
        match number(cell, decimal_comma) {
            Some(value) if value.is_nan() => Self::Missing,
            Some(value) => Self::Number(value),
            None => Self::other(cell),
        }
    }

    fn other(cell: &[u8]) -> Self {
        let Ok(text) = std::str::from_utf8(cell) else { return Self::Text };
        if MISSING.iter().any(|word| text.eq_ignore_ascii_case(word)) {
            return Self::Missing;
        }
        Stamp::of(text).map_or(Self::Text, Self::Stamp)
    }
}

#[cfg(test)]
mod tests {
    use super::{Cell, Delimiter, split};

    #[test]
    fn cells_are_numbers_stamps_gaps_or_text() {
        assert_eq!(Cell::of(b" +1.5e-3 ", false), Cell::Number(0.0015));
        assert_eq!(Cell::of(b"\"1,5\"", true), Cell::Number(1.5));
        assert_eq!(Cell::of(b"1,5", false), Cell::Text);
        assert_eq!(Cell::of(b"1.234,5", true), Cell::Number(1234.5));
        assert_eq!(Cell::of(b"1e999", false), Cell::Number(f64::INFINITY));
        for missing in [&b""[..], b"  ", b"NaN", b"-nan", b"N/A", b"\"\""] {
            assert_eq!(Cell::of(missing, false), Cell::Missing, "{missing:?}");
        }
        for text in [&b"abc"[..], b"1 N", b"0x10", b"\xb5", b"1:2:3:4", b"12:60:00"] {
            assert_eq!(Cell::of(text, false), Cell::Text, "{text:?}");
        }
        assert!(matches!(Cell::of(b"00:01:02,5", true), Cell::Stamp(stamp) if stamp.second == 62.5));
    }

    #[test]
    fn a_delimiter_between_quotes_does_not_part() {
        let mut cells = Vec::new();
        split(b"a,\"b,c\",d", Delimiter::Sign(b','), &mut cells);
        assert_eq!(cells, [0..1, 2..7, 8..9]);
        split(b"  1 \t 2 ", Delimiter::Space, &mut cells);
        assert_eq!(cells, [2..3, 6..7]);
    }
}
