//! A cell of a spreadsheet as a text that a log may have: numbers to the last bit, dates and stretches of time as stamps.
//!
//! Next door: where cells come from (`book`), what becomes of them (`grid`).

use std::fmt::Write;

use calamine::DataType;

/// A cell's value.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Value {
    /// A number, or an instant as a stamp: what a row of a log has.
    Number(String),
    /// Anything else.
    Text(String),
}

impl Value {
    /// Of what the library reads; `None` of an empty cell.
    pub fn of(cell: &impl DataType) -> Option<Self> {
        if let Some(text) = cell.get_string() {
            return Self::text(text);
        }
        let number = (cell.get_float().map(written))
            .or_else(|| cell.get_int().map(|whole| whole.to_string()))
            .or_else(|| cell.get_datetime().map(|instant| serial((instant.as_f64(), 0.0))))
            .or_else(|| cell.get_datetime_iso().map(dated))
            .or_else(|| cell.get_duration_iso().map(|text| stretch(text).map_or(text.to_owned(), serial)));
        let other = || {
            let truth = cell.get_bool().map(|is| if is { "TRUE" } else { "FALSE" }.to_owned());
            truth.or_else(|| cell.get_error().map(ToString::to_string))
        };
        number.map(Self::Number).or_else(|| other().map(Self::Text))
    }

    fn text(text: &str) -> Option<Self> {
        (!text.trim().is_empty()).then(|| Self::Text(text.trim().to_owned()))
    }

    /// Appends it to a line whose cells stand between tabs.
    pub fn write(&self, line: &mut Vec<u8>) {
        match self {
            Self::Number(text) => line.extend_from_slice(text.as_bytes()),
            Self::Text(text) if text.contains(['"', '\t', '\n', '\r']) => {
                let text = text.replace(['\t', '\n', '\r'], " ").replace('"', "\"\"");
                line.push(b'"');
                line.extend_from_slice(text.as_bytes());
                line.push(b'"');
            }
            Self::Text(text) => line.extend_from_slice(text.as_bytes()),
        }
    }
}

/// The shortest text of a number that gives the number again.
fn written(number: f64) -> String {
    let size = number.abs();
    if size == 0.0 || (1e-5..1e15).contains(&size) { format!("{number}") } else { format!("{number:e}") }
}

/// Days since 1899-12-30 and seconds as a stamp, to the microsecond; times of day and stretches are of that day.
///
/// A number of days as of this century tells half a microsecond, so that what is within its last digits of ten microseconds is those. Workbooks that count from 1904 are four years early, which no log shows: its time counts
/// from its own first day.
fn serial((days, seconds): (f64, f64)) -> String {
    let size = days.abs() + seconds.abs() / 86_400.0;
    if size.is_nan() || size >= 1e7 {
        return written(days);
    }
    let whole = days.floor();
    let exact = (days - whole) * 86_400e6;
    let (tens, last_digits) = ((exact / 10.0).round() * 10.0, 3.0 * 86_400e6 * (days.abs().next_up() - days.abs()));
    let near = if (exact - tens).abs() <= last_digits { tens } else { exact.round() };
    let microseconds = near as i64 + (seconds * 1e6).round() as i64;
    let day = whole as i64 + microseconds.div_euclid(86_400_000_000);
    let rest = microseconds.rem_euclid(86_400_000_000);
    let (year, month, of_month) = date(day - 25_569);
    let (second, fraction) = (rest / 1_000_000, rest % 1_000_000);
    let (hours, minutes) = (second / 3600, second / 60 % 60);
    let mut text = format!("{year:04}-{month:02}-{of_month:02} {hours:02}:{minutes:02}:{:02}", second % 60);
    if fraction > 0 {
        let _ = write!(text, ".{fraction:06}");
    }
    text
}

/// Year, month and day of a day since 1970 in the Gregorian calendar.
fn date(day: i64) -> (i64, i64, i64) {
    // Years that begin in March, so that the leap day comes last.
    let day = day + 719_468;
    let (era, of_era) = (day.div_euclid(146_097), day.rem_euclid(146_097));
    let year = (of_era - of_era / 1460 + of_era / 36_524 - of_era / 146_096) / 365;
    let of_year = of_era - (365 * year + year / 4 - year / 100);
    let month = (5 * of_year + 2) / 153;
    let of_month = of_year - (153 * month + 2) / 5 + 1;
    let month = if month < 10 { month + 3 } else { month - 9 };
    (era * 400 + year + i64::from(month <= 2), month, of_month)
}

/// A date, with a time of day where it has one, as a stamp.
fn dated(text: &str) -> String {
    if text.len() == 10 { format!("{text} 00:00") } else { text.to_owned() }
}

/// Days and seconds of `PT12H00M00.25S`.
fn stretch(text: &str) -> Option<(f64, f64)> {
    let (sign, text) = text.strip_prefix('-').map_or((1.0, text), |text| (-1.0, text));
    let (days, clock) = text.strip_prefix('P')?.split_once('T')?;
    let days: f64 = if days.is_empty() { 0.0 } else { days.strip_suffix('D')?.parse().ok()? };
    let (mut seconds, mut rest) = (0.0, clock);
    for (unit, size) in [('H', 3600.0), ('M', 60.0), ('S', 1.0)] {
        if let Some((number, after)) = rest.split_once(unit) {
            seconds += size * number.replace(',', ".").parse::<f64>().ok()?;
            rest = after;
        }
    }
    rest.is_empty().then_some((sign * days, sign * seconds))
}

#[cfg(test)]
mod tests {
    use super::{date, dated, serial, stretch, written};

    #[test]
    fn numbers_come_back_to_the_last_bit() {
        for number in [0.1, -0.0, 1e-300, 1.797e308, 123_456.789, 5e-324, 1e15, 0.1 + 0.2] {
            assert_eq!(written(number).parse::<f64>().unwrap().to_bits(), f64::to_bits(number));
            assert!(written(number).len() < 30);
        }
    }

    #[test]
    fn instants_are_stamps_to_the_microsecond() {
        // 2025-10-13 12:59:02.4, from calamine's documentation.
        assert_eq!(serial((45_943.541, 0.0)), "2025-10-13 12:59:02.400000");
        assert_eq!(serial((45_943.0, 0.0)), "2025-10-13 00:00:00");
        // 2026-11-21 12:00:00.008 as openpyxl writes it; a time of day tells single microseconds.
        assert_eq!(serial((46_347.500_000_092_59, 0.0)), "2026-11-21 12:00:00.008000");
        assert_eq!(serial((3e-6 / 86_400.0, 0.0)), "1899-12-30 00:00:00.000003");
        assert_eq!(serial((0.5, 0.0)), "1899-12-30 12:00:00");
        assert_eq!(serial((1.5, 0.0)), "1899-12-31 12:00:00");
        assert_eq!(serial((0.999_999_999_999, 0.0)), "1899-12-31 00:00:00");
        assert_eq!(serial((-0.25, 0.0)), "1899-12-29 18:00:00");
        assert_eq!(serial((1e300, 0.0)), "1e300");
        assert_eq!(serial(stretch("PT12H00M00.25S").unwrap()), "1899-12-30 12:00:00.250000");
        assert_eq!(serial(stretch("P1DT0H0M1S").unwrap()), "1899-12-31 00:00:01");
        assert_eq!(serial(stretch("-PT1S").unwrap()), "1899-12-29 23:59:59");
        assert_eq!((stretch("12:00"), stretch("PT1X")), (None, None));
        assert_eq!(dated("2026-11-21"), "2026-11-21 00:00");
    }

    #[test]
    fn days_are_those_of_the_calendar() {
        assert_eq!((date(0), date(-1), date(19_782)), ((1970, 1, 1), (1969, 12, 31), (2024, 2, 29)));
        assert_eq!((date(20_778), date(-25_569)), ((2026, 11, 21), (1899, 12, 30)));
    }
}
