//! Numbers as people and programs write them: with a decimal point or comma, with thousands parted or not; and whether a column leaves open which of
//! the two a sign is.
//!
//! Next door: other cells (`cell`), whole files (`text`).

/// Longest number that is read, in characters: 1e-300 written without an exponent fits.
const LONGEST: usize = 400;

/// The number of a cell without spaces around it; `None` where it is none.
pub(super) fn number(cell: &[u8], decimal_comma: bool) -> Option<f64> {
    if cell.len() > LONGEST || cell.ends_with(b",") {
        return None;
    }
    let plain = if decimal_comma {
        with_point(cell)
    } else {
        std::str::from_utf8(cell).ok().and_then(|text| text.parse().ok())
    };
    plain.or_else(|| grouped(cell, decimal_comma))
}

fn with_point(cell: &[u8]) -> Option<f64> {
    let mut buffer = [0; LONGEST];
    let copy = buffer.get_mut(..cell.len())?;
    for (to, &from) in copy.iter_mut().zip(cell) {
        *to = match from {
            b',' => b'.',
            b'.' => return None,
            other => other,
        };
    }
    std::str::from_utf8(copy).ok()?.parse().ok()
}

/// Spaces and strokes that part thousands and nothing else; some are no ASCII.
const APART: [&[u8]; 7] =
    [b"'", "\u{2019}".as_bytes(), b" ", "\u{a0}".as_bytes(), b"\xa0", "\u{202f}".as_bytes(), "\u{2009}".as_bytes()];
/// The minus of typographers.
const MINUS: &[u8] = "\u{2212}".as_bytes();

/// A number whose thousands are parted, or whose minus is a typographer's: `1.234,5`, `1 234.5`, `−1'234`.
fn grouped(cell: &[u8], decimal_comma: bool) -> Option<f64> {
    let (minus, unsigned) = match cell {
        [b'-', rest @ ..] => (true, rest),
        [b'+', rest @ ..] => (false, rest),
        _ => cell.strip_prefix(MINUS).map_or((false, cell), |rest| (true, rest)),
    };
    let (sign, other) = if decimal_comma { (b',', b"." as &[u8]) } else { (b'.', b"," as &[u8]) };
    let behind = unsigned.iter().position(|byte| *byte == sign);
    let (whole, fraction) = unsigned.split_at(behind.unwrap_or(unsigned.len()));
    let fraction = fraction.get(1..).unwrap_or_default();
    if !fraction.iter().all(u8::is_ascii_digit) {
        return None;
    }
    let separator = APART.iter().copied().chain([other]).find(|separator| contains(whole, separator));
    let digits = match separator {
        Some(separator) => joined(whole, separator)?,
        None if cell.starts_with(MINUS) && !whole.is_empty() && whole.iter().all(u8::is_ascii_digit) => whole.to_vec(),
        None => return None,
    };
    let digits = String::from_utf8(digits).ok()?;
    let fraction = std::str::from_utf8(fraction).ok()?;
    let value: f64 = format!("{digits}.{fraction}0").parse().ok()?;
    Some(if minus { -value } else { value })
}

fn contains(text: &[u8], part: &[u8]) -> bool {
    text.windows(part.len()).any(|window| window == part)
}

/// One to three digits, the first of which is no zero, and behind each separator three more.
fn joined(mut text: &[u8], separator: &[u8]) -> Option<Vec<u8>> {
    let mut digits = Vec::with_capacity(text.len());
    loop {
        let place = text.windows(separator.len()).position(|window| window == separator);
        let (group, rest) = text.split_at(place.unwrap_or(text.len()));
        let fits =
            if digits.is_empty() { (1..=3).contains(&group.len()) && group[0] != b'0' } else { group.len() == 3 };
        if !fits || !group.iter().all(u8::is_ascii_digit) {
            return None;
        }
        digits.extend_from_slice(group);
        match place {
            Some(_) => text = &rest[separator.len()..],
            None => return Some(digits),
        }
    }
}

/// What the cells of a column tell of a sign that may part thousands or decimals: `60.005` may be either where `998` stands beside it.
#[derive(Debug, Clone, Default)]
pub(super) struct Thousands {
    /// Whether a cell told it.
    settled: bool,
    /// A whole number below a thousand was there.
    plain: bool,
    /// The first cell with the decimal sign and three digits behind it.
    like: Option<String>,
    /// The first cell with the other sign and three digits behind it.
    grouped: Option<String>,
}

/// What a cell tells.
enum Told {
    Nothing,
    Settled,
    Plain,
    Like,
    Grouped,
}

impl Thousands {
    /// A column of which that is told.
    pub fn settled() -> Self {
        Self { settled: true, ..Self::default() }
    }

    /// Looks at a cell that holds a number, without spaces around it.
    pub fn see(&mut self, cell: &[u8], decimal_comma: bool) {
        if self.settled {
            return;
        }
        let words = || Some(String::from_utf8_lossy(cell).into_owned());
        match told(cell, decimal_comma) {
            Told::Nothing => {}
            Told::Settled => self.settled = true,
            Told::Plain => self.plain = true,
            Told::Like => self.like = self.like.take().or_else(words),
            Told::Grouped => self.grouped = self.grouped.take().or_else(words),
        }
    }

    /// A cell that may mean two numbers, a thousand times apart.
    pub fn doubt(&self) -> Option<&str> {
        match (self.settled, self.plain) {
            (true, _) => None,
            (false, true) => self.like.as_deref(),
            (false, false) => self.grouped.as_deref(),
        }
    }
}

fn told(cell: &[u8], decimal_comma: bool) -> Told {
    let cell = cell.strip_prefix(b"-").or(cell.strip_prefix(b"+")).unwrap_or(cell);
    let (sign, other) = if decimal_comma { (b',', b'.') } else { (b'.', b',') };
    if !cell.first().is_some_and(u8::is_ascii_digit)
        || !cell.iter().all(|byte| byte.is_ascii_digit() || b".,".contains(byte))
    {
        // An exponent, infinity, or thousands apart: none is a decimal for a thousand.
        return Told::Settled;
    }
    let signs = cell.iter().filter(|byte| !byte.is_ascii_digit()).count();
    let place = cell.iter().position(|byte| !byte.is_ascii_digit());
    match (signs, place) {
        (0, _) if cell.iter().all(|byte| *byte == b'0') => Told::Nothing,
        (0, _) if cell.len() > 3 => Told::Settled,
        (0, _) => Told::Plain,
        (1, Some(place)) => {
            let group = (1..=3).contains(&place) && cell[0] != b'0' && cell.len() == place + 4;
            match cell[place] {
                found if found == other => Told::Grouped,
                found if found == sign && group => Told::Like,
                _ => Told::Settled,
            }
        }
        _ => Told::Settled,
    }
}

#[cfg(test)]
mod tests {
    use super::{Thousands, number};

    #[test]
    fn parted_thousands_are_read_and_nothing_that_is_none() {
        for (text, comma, value) in [
            ("1,234.5", false, 1234.5),
            ("1.234,5", true, 1234.5),
            ("-12,345,678", false, -12_345_678.0),
            ("1 234,5", true, 1234.5),
            ("1'234.5", false, 1234.5),
            ("1\u{2019}234", false, 1234.0),
            ("1\u{202f}234\u{202f}567,25", true, 1_234_567.25),
            ("\u{2212}0.5", false, -0.5),
            ("\u{2212}1 234.5", false, -1234.5),
            ("60.005", false, 60.005),
            ("60.005", true, 60_005.0),
        ] {
            assert_eq!(number(text.as_bytes(), comma), Some(value), "{text}");
        }
        for (text, comma) in [
            ("1,23", false),
            ("1,2345", false),
            ("0,123", false),
            ("1234,567", false),
            ("1,234,56", false),
            ("12,34.5", false),
            (",123", false),
            ("1,234e3", false),
            ("1.5", true),
            ("0.004", true),
            ("1.234.5", true),
            ("1 23", true),
            ("1,234,", false),
            ("\u{2212}", false),
        ] {
            assert_eq!(number(text.as_bytes(), comma), None, "{text}");
        }
        assert_eq!(number(b"1\xa0234", false), Some(1234.0));
    }

    #[test]
    fn a_column_that_may_be_a_thousand_times_another_is_in_doubt() {
        let doubt = |cells: &[&str], comma: bool| {
            let mut seen = Thousands::default();
            cells.iter().for_each(|cell| seen.see(cell.as_bytes(), comma));
            seen.doubt().map(str::to_owned)
        };
        // Whole numbers below a thousand beside three digits behind the sign: as a writer of thousands leaves them.
        assert_eq!(doubt(&["998", "1.001", "60.005"], false).as_deref(), Some("1.001"));
        // Decimals of fixed length, of any length, or whole numbers of four digits: no doubt.
        assert_eq!(doubt(&["60.005", "59.998"], false), None);
        assert_eq!(doubt(&["998", "1.001", "1.5"], false), None);
        assert_eq!(doubt(&["998", "0.125", "1.001"], false), None);
        assert_eq!(doubt(&["998", "1001", "1.001"], false), None);
        assert_eq!(doubt(&["0", "12.345"], false), None);
        // The other sign with three digits behind it, and nothing else in the column.
        assert_eq!(doubt(&["60.005", "60.012"], true).as_deref(), Some("60.005"));
        assert_eq!(doubt(&["998", "60.005"], true), None);
        assert_eq!(doubt(&["60.005", "1,5"], true), None);
        assert_eq!(doubt(&["1.234.567", "60.005"], true), None);
    }
}
