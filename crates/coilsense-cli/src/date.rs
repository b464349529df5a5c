//! The date that a report carries.
//!
//! Next door: the commands that write reports.

use coilsense_lab::request::{DATE, Given};
use time::{Date, Month, OffsetDateTime};

/// A date as a person writes it, `2026-11-21`.
pub fn parse(text: &str) -> Result<String, String> {
    let day = || {
        let [year, month, day] = text.split('-').collect::<Vec<_>>().try_into().ok()?;
        let figures = |part: &str, count: usize| part.len() == count && part.bytes().all(|byte| byte.is_ascii_digit());
        if !(figures(year, 4) && figures(month, 2) && figures(day, 2)) {
            return None;
        }
        let month = Month::try_from(month.parse::<u8>().ok()?).ok()?;
        Date::from_calendar_date(year.parse().ok()?, month, day.parse().ok()?).ok()
    };
    let allowed = "must be a day as YYYY-MM-DD, such as 2026-11-21";
    day().map(|_| text.to_owned()).ok_or_else(|| allowed.to_owned())
}

/// The date that is given, or today's.
pub fn or_today(given: &Given) -> String {
    given.text(&DATE).unwrap_or_else(|| OffsetDateTime::now_utc().date().to_string())
}
