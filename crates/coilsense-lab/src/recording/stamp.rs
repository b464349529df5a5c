//! Dates and times of day as instruments write them.
//!
//! Next door: all other cells (`cell`).

/// Days since 1970 and seconds of `2026-11-21T12:00:00.5+01:00`, `2026-11-21 12:00:00`, `12:00:00.5` or `12:00`.
pub(super) fn stamp(text: &str) -> Option<(i64, f64)> {
    let (date, clock) = match text.split_once(['T', ' ']) {
        Some((date, clock)) => (Some(date), clock.trim_start()),
        None => (None, text),
    };
    let days = date.map_or(Some(0), days_since_1970)?;
    let (clock, zone) = match (date, clock.strip_suffix('Z'), clock.find(['+', '-'])) {
        (Some(_), Some(clock), _) => (clock, 0.0),
        (Some(_), None, Some(place)) => {
            let sign = if clock[place..].starts_with('-') { -1.0 } else { 1.0 };
            (&clock[..place], sign * time_of_day(&clock[place + 1..])?)
        }
        _ => (clock, 0.0),
    };
    Some((days, time_of_day(clock)? - zone))
}

/// `12:00`, `12:00:00` or `12:00:00.5` as seconds.
fn time_of_day(text: &str) -> Option<f64> {
    let mut parts = text.split(':');
    let whole = |part: Option<&str>| part.filter(|part| part.len() <= 2)?.parse::<u8>().ok().map(f64::from);
    let (hours, minutes) = (whole(parts.next())?, whole(parts.next())?);
    let seconds: f64 = parts.next().map_or(Some(0.0), |part| {
        part.starts_with(|c: char| c.is_ascii_digit()).then(|| part.parse().ok()).flatten()
    })?;
    let fits = parts.next().is_none() && hours <= 24.0 && minutes < 60.0 && (0.0..61.0).contains(&seconds);
    fits.then_some(3600.0 * hours + 60.0 * minutes + seconds)
}

/// Days of `2026-11-21` since 1970-01-01 in the Gregorian calendar.
fn days_since_1970(text: &str) -> Option<i64> {
    let mut parts = text.split('-').map(|part| part.parse::<i64>().ok().filter(|_| part.len() <= 4));
    let (year, month, day) = (parts.next()??, parts.next()??, parts.next()??);
    if parts.next().is_some() || !(1..=12).contains(&month) || !(1..=31).contains(&day) {
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
    use super::stamp;

    #[test]
    fn stamps_count_seconds_since_1970() {
        assert_eq!(stamp("1970-01-02 00:00:01"), Some((1, 1.0)));
        // date -u -d 2026-11-21T12:00:00 +%s
        assert_eq!(stamp("2026-11-21T12:00:00Z"), Some((1_795_262_400 / 86_400, 43_200.0)));
        assert_eq!(stamp("2026-11-21T13:00:00.25+01:00"), Some((20_778, 43_200.25)));
        assert_eq!(stamp("2024-02-29 00:00"), Some((1_709_164_800 / 86_400, 0.0)));
        assert_eq!(stamp("2026-13-01 00:00"), None);
    }
}
