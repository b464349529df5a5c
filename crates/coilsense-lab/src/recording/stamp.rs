//! Dates, times of day and durations as instruments, spreadsheets and programs write them.
//!
//! Next door: all other cells (`cell`).

/// A date, a time of day, or both; or a duration.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Stamp {
    /// Days since 1970; 0 where there is no date.
    pub day: i64,
    /// The same with day and month changed for each other, where they can be: `11/12/2026`.
    pub other: i64,
    /// Seconds of that day; all of a duration.
    pub second: f64,
}

impl Stamp {
    /// `2026-11-21T12:00:00.5+01:00`, `21.11.2026 12:00:00,5`, `11/21/2026 12:00:00 PM`, `21-Nov-2026 12:00:00`, `12:00:00.5`, `12:00`, `59:59.9`,
    /// `0.0004 sec`, `1 days 00:00:00.5`.
    pub fn of(text: &str) -> Option<Self> {
        let text = text.trim();
        if let Some(second) = duration(text) {
            return Some(Self { day: 0, other: 0, second });
        }
        let colon = text.find(':')?;
        let digits = text[..colon].bytes().rev().take_while(u8::is_ascii_digit).count();
        let (date, clock) = text.split_at(colon - digits);
        let date = date.trim_end_matches([' ', 'T', ',', '_']);
        let (day, other) = if date.is_empty() { (0, 0) } else { days(date)? };
        let (clock, zone) = zoned(clock, !date.is_empty())?;
        Some(Self { day, other, second: time_of_day(clock)? - zone })
    }

    /// Days from `first` to this; of a date that may be read two ways, the way that passes fewer.
    pub fn days_since(self, first: Self) -> i64 {
        let (one, other) = (self.day - first.day, self.other - first.other);
        match (one, other) {
            (one, other) if other >= 0 && (one < 0 || other < one) => other,
            _ => one,
        }
    }
}

/// A clock without its zone, and the zone in seconds: a time of day without a date has none.
fn zoned(clock: &str, dated: bool) -> Option<(&str, f64)> {
    if let Some(clock) = clock.strip_suffix('Z').filter(|_| dated) {
        return Some((clock, 0.0));
    }
    match clock.find(['+', '-']).filter(|_| dated) {
        Some(place) => {
            let sign = if clock[place..].starts_with('-') { -1.0 } else { 1.0 };
            let zone = &clock[place + 1..];
            let short = zone.len() == 4 && zone.bytes().all(|byte| byte.is_ascii_digit());
            let zone = if short { format!("{}:{}", &zone[..2], &zone[2..]) } else { zone.to_owned() };
            Some((&clock[..place], sign * time_of_day(&zone)?))
        }
        None => Some((clock, 0.0)),
    }
}

/// `12:00`, `12:00:00`, `12:00:00.5`, `12:00:00 PM`, `12:00:00:500` or `59:59.9` as seconds.
fn time_of_day(text: &str) -> Option<f64> {
    let lower = text.trim().to_ascii_lowercase();
    let (clock, half) = match (lower.strip_suffix("am"), lower.strip_suffix("pm")) {
        (Some(clock), _) => (clock.trim_end(), Some(0.0)),
        (_, Some(clock)) => (clock.trim_end(), Some(12.0)),
        _ => (lower.as_str(), None),
    };
    let parts: Vec<&str> = clock.split(':').collect();
    let whole = |part: &str| {
        let is_one = (1..=2).contains(&part.len()) && part.bytes().all(|byte| byte.is_ascii_digit());
        is_one.then(|| part.parse::<u8>().ok().map(f64::from)).flatten()
    };
    let seconds = |part: &str| -> Option<f64> {
        let part = part.replace(',', ".");
        part.starts_with(|c: char| c.is_ascii_digit()).then(|| part.parse().ok()).flatten()
    };
    let (hours, minutes, second): (f64, f64, f64) = match parts.as_slice() {
        // Spreadsheets' mm:ss.0.
        [minutes, second] if second.contains(['.', ',']) => (0.0, whole(minutes)?, seconds(second)?),
        [hours, minutes] => (whole(hours)?, whole(minutes)?, 0.0),
        [hours, minutes, second] => (whole(hours)?, whole(minutes)?, seconds(second)?),
        [hours, minutes, second, part] if matches!(part.len(), 3 | 6) => {
            (whole(hours)?, whole(minutes)?, seconds(&format!("{second}.{part}"))?)
        }
        _ => return None,
    };
    let hours = match half {
        Some(half) if (1.0..=12.0).contains(&hours) => hours % 12.0 + half,
        Some(_) => return None,
        None => hours,
    };
    let fits = hours <= 24.0 && minutes < 60.0 && (0.0..61.0).contains(&second);
    fits.then_some(3600.0 * hours + 60.0 * minutes + second)
}

/// Words of durations, as MATLAB, pandas and people write them behind a number, and their seconds.
const LENGTHS: [(&[&str], f64); 7] = [
    (&["days", "day", "d"], 86_400.0),
    (&["hours", "hour", "hrs", "hr", "h"], 3600.0),
    (&["minutes", "minute", "mins", "min"], 60.0),
    (&["seconds", "second", "secs", "sec", "s"], 1.0),
    (&["ms", "msec"], 1e-3),
    (&["us", "usec", "µs"], 1e-6),
    (&["ns"], 1e-9),
];

/// `0.0004 sec`, `1 days 00:00:00.5`.
fn duration(text: &str) -> Option<f64> {
    let (number, rest) = text.split_once(' ')?;
    let number = number.replace(',', ".");
    let number: f64 =
        number.starts_with(|c: char| c.is_ascii_digit() || c == '-').then(|| number.parse().ok()).flatten()?;
    let (word, clock) = rest.trim_start().split_once(' ').unwrap_or((rest.trim_start(), ""));
    let (names, seconds) = LENGTHS.iter().find(|(words, _)| words.contains(&word))?;
    let whole = if *seconds < 1.0 { number / (1.0 / seconds).round() } else { number * seconds };
    match (names[0], clock.trim()) {
        (_, "") => Some(whole),
        ("days", clock) => Some(whole + time_of_day(clock)?),
        _ => None,
    }
}

/// Days since 1970 of a date; a second time with day and month changed for each other where both could be either.
fn days(text: &str) -> Option<(i64, i64)> {
    let parts: Vec<&str> = text.split(['-', '/', '.', ' ', ',']).filter(|part| !part.is_empty()).collect();
    let [first, second, third] = parts.as_slice() else { return None };
    let number =
        |part: &str| part.parse::<i64>().ok().filter(|_| part.len() <= 4 && part.bytes().all(|b| b.is_ascii_digit()));
    let year = |part: &str| match part.len() {
        4 => number(part),
        2 => number(part).map(|year| 2000 + year),
        _ => None,
    };
    let once = |day: i64| (day, day);
    if let Some(month) = month(second) {
        return days_since_1970(year(third)?, month, number(first)?).map(once);
    }
    if let Some(month) = month(first) {
        return days_since_1970(year(third)?, month, number(second)?).map(once);
    }
    if first.len() == 4 {
        return days_since_1970(number(first)?, number(second)?, number(third)?).map(once);
    }
    let (one, two, year) = (number(first)?, number(second)?, year(third)?);
    let day_first = days_since_1970(year, two, one);
    let month_first = days_since_1970(year, one, two);
    // Points part days and months in that order; strokes do it both ways.
    if text.contains('.') {
        return day_first.map(once);
    }
    Some((month_first.or(day_first)?, day_first.or(month_first)?))
}

/// January to December by its first letters in English.
fn month(text: &str) -> Option<i64> {
    const NAMES: [&str; 12] = ["jan", "feb", "mar", "apr", "may", "jun", "jul", "aug", "sep", "oct", "nov", "dec"];
    let lower = text.to_ascii_lowercase();
    let place = NAMES
        .iter()
        .position(|name| lower.starts_with(name) && lower.bytes().all(|byte| byte.is_ascii_alphabetic()))?;
    Some(place as i64 + 1)
}

/// Days since 1970-01-01 in the Gregorian calendar.
fn days_since_1970(year: i64, month: i64, day: i64) -> Option<i64> {
    if !(1..=12).contains(&month) || !(1..=31).contains(&day) {
        return None;
    }
    // Years that begin in March, so that the leap day comes last.
    let year = if month <= 2 { year - 1 } else { year };
    let day_of_year = (153 * ((month + 9) % 12) + 2) / 5 + day - 1;
    let (era, year_of_era) = (year.div_euclid(400), year.rem_euclid(400));
    Some(era * 146_097 + year_of_era * 365 + year_of_era / 4 - year_of_era / 100 + day_of_year - 719_468)
}

#[cfg(test)]
mod tests {
    use super::Stamp;

    fn stamp(text: &str) -> Option<(i64, f64)> {
        Stamp::of(text).map(|stamp| (stamp.day, stamp.second))
    }

    #[test]
    fn stamps_count_seconds_since_1970() {
        assert_eq!(stamp("1970-01-02 00:00:01"), Some((1, 1.0)));
        // date -u -d 2026-11-21T12:00:00 +%s
        assert_eq!(stamp("2026-11-21T12:00:00Z"), Some((1_795_262_400 / 86_400, 43_200.0)));
        assert_eq!(stamp("2026-11-21T13:00:00.25+01:00"), Some((20_778, 43_200.25)));
        assert_eq!(stamp("2026-11-21T13:00:00.25+0100"), Some((20_778, 43_200.25)));
        assert_eq!(stamp("2024-02-29 00:00"), Some((1_709_164_800 / 86_400, 0.0)));
        assert_eq!(stamp("2026-13-01 00:00"), None);
    }

    #[test]
    fn dates_are_read_as_people_write_them() {
        for text in [
            "21.11.2026 12:00:00,25",
            "21.11.26 12:00:00.25",
            "11/21/2026 12:00:00.25 PM",
            "21/11/2026 12:00:00.25",
            "2026/11/21 12:00:00.25",
            "2026.11.21 12:00:00.25",
            "21-Nov-2026 12:00:00.25",
            "21 November 2026 12:00:00.25",
            "Nov 21, 2026, 12:00:00.25",
            "2026-11-21_12:00:00.25",
            "2026-11-21 12:00:00:250",
        ] {
            assert_eq!(stamp(text), Some((20_778, 43_200.25)), "{text}");
        }
        assert_eq!(stamp("11/21/2026 12:00:00 AM"), Some((20_778, 0.0)));
        assert_eq!(stamp("1:30:00 PM"), Some((0, 48_600.0)));
        assert_eq!(stamp("59:59.9"), Some((0, 3599.9)));
        for text in [
            "31.13.2026 12:00",
            "13:00:00 PM",
            "0:30 PM",
            "21.Nov 12:00",
            "1:2:3:4",
            "12:60:00",
            "a 12:00",
            "12:00+01:00",
        ] {
            assert_eq!(stamp(text), None, "{text}");
        }
    }

    #[test]
    fn of_two_ways_to_read_a_date_the_shorter_step_is_meant() {
        let day = |text: &str| Stamp::of(text).unwrap();
        assert_eq!(day("01/12/2026 00:00").days_since(day("30/11/2026 00:00")), 1);
        assert_eq!(day("11/12/2026 00:00").days_since(day("10/12/2026 00:00")), 1);
        assert_eq!(day("11/12/2026 00:00").days_since(day("11/11/2026 00:00")), 1);
        assert_eq!(day("21.11.2026 00:00").days_since(day("22.11.2026 00:00")), -1);
    }

    #[test]
    fn durations_are_read_as_matlab_and_pandas_write_them() {
        assert_eq!(stamp("0.0004 sec"), Some((0, 0.0004)));
        assert_eq!(stamp("0 days 00:00:00.000400"), Some((0, 0.0004)));
        assert_eq!(stamp("2 days 01:00:00"), Some((0, 176_400.0)));
        assert_eq!(stamp("400 us"), Some((0, 0.0004)));
        assert_eq!(stamp("1,5 min"), Some((0, 90.0)));
        for text in ["1 N", "5 mm", "sec", "1 sec 00:00:01", "1 days x", "nan sec"] {
            assert_eq!(stamp(text), None, "{text}");
        }
    }
}
