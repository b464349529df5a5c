//! An account in words, for people.
//!
//! Next door: the account (`account`).

use std::fmt;

use coilsense::measures::ClockOffset;

use super::account::{Account, Gaps, Joined, Tally};
use crate::quantity::digits;

impl Account {
    /// One line for each thing to be said.
    pub fn lines(&self) -> Vec<String> {
        let mut lines = vec![format!("{}: {}", self.file.display(), self.description)];
        lines.extend(self.taken.iter().map(|(name, column)| format!("  {name:4} from {column}")));
        if !self.not_taken.is_empty() {
            lines.push(format!("  not taken: {}", listed(&self.not_taken)));
        }
        let left_out =
            if self.left_out.is_empty() { "none left out".to_owned() } else { format!("{} left out", self.left_out()) };
        lines.push(format!("  {} rows read, {left_out}, {} kept", self.read, self.rows));
        for (reason, tally) in &self.left_out {
            let line = if tally.line > 0 { format!(", the first in line {}", tally.line) } else { String::new() };
            lines.push(format!("    {} {}{line}", tally.count, reason.words()));
        }
        lines.extend(self.cleaned());
        lines.extend(self.timing());
        lines.extend(self.notes.iter().map(|note| format!("  {note}")));
        lines.extend(self.joined.iter().flat_map(|joined| joined.lines()));
        lines
    }

    /// What was left out or cleaned, in one sentence that names the file; none where every row came through as it was.
    pub fn cleaning(&self) -> Option<String> {
        let left_out = self.left_out.iter().map(|(reason, tally)| {
            let line = if tally.line > 0 { format!(" (the first in line {})", tally.line) } else { String::new() };
            format!("{} {} {} left out{line}", tally.count, rows(tally.count), reason.words())
        });
        let parts: Vec<String> = left_out.chain(self.cleaned().iter().map(|line| line.trim().to_owned())).collect();
        (!parts.is_empty()).then(|| format!("{}: {}.", self.file.display(), parts.join("; ")))
    }

    fn cleaned(&self) -> Vec<String> {
        let mut lines = Vec::new();
        if let Some((turn, Tally { count, line })) = self.turns {
            let times = if count == 1 { String::new() } else { format!(" {count} times") };
            lines.push(format!("  time counts on{times}, first in line {line}: {}", what_turns(turn)));
        }
        if self.sorted > 0 {
            lines.push(format!("  sorted: {} rows stood out of order", self.sorted));
        }
        for (name, (count, longest)) in &self.filled_values {
            lines.push(format!(
                "  {name}: {count} missing values filled along straight lines of up to {}",
                seconds(*longest)
            ));
        }
        if self.filled_rows > 0 {
            lines.push(format!("  {} rows added in gaps", self.filled_rows));
        }
        if let Some(rate) = self.resampled {
            lines.push(format!("  resampled to {}", hertz(rate)));
        }
        lines
    }

    fn timing(&self) -> Vec<String> {
        let mut lines = Vec::new();
        if let (Some(interval), Some([least, largest])) = (self.interval, self.steps) {
            let uneven = if largest - least > 1e-3 * interval {
                format!(", uneven: steps from {} to {}", seconds(least), seconds(largest))
            } else {
                String::new()
            };
            lines.push(format!("  sampled at {}{uneven}", hertz(1.0 / interval)));
        }
        if let Some([from, to]) = self.span {
            lines.push(format!("  from {from} s to {to} s"));
        }
        if self.gaps.count > 0 {
            let Gaps { count, longest, line } = self.gaps;
            let plural = if count == 1 { "gap" } else { "gaps" };
            let length = seconds(longest);
            lines.push(format!("  {count} {plural} of up to {length}, the first before line {line}: rows are missing, or the clock was set"));
        }
        lines
    }
}

impl Joined {
    fn lines(&self) -> Vec<String> {
        let mut lines = vec!["with a second device:".to_owned()];
        lines.extend(self.account.lines());
        let Some(([mine, theirs], found)) = &self.found else {
            lines.push(format!(
                "  its clock is off by {}, as told; a drift of it is not looked for",
                seconds(self.offset)
            ));
            return lines;
        };
        lines.push(format!(
            "  its clock is off by {:.9} s ± {} (95 %) at its {:.3} s, by its {theirs} against {mine} (correlation {:.3})",
            self.offset,
            half_width(found.half_width),
            found.at,
            found.correlation
        ));
        lines.extend(self.drift(found));
        lines
    }

    /// What that becomes at the ends of its record.
    fn drift(&self, found: &ClockOffset) -> Option<String> {
        let [from, to] = self.account.span?;
        let end = |time: f64| format!("{:.6} s ± {}", found.added(time), half_width(found.half_width_at(time)));
        let (from, to) = (format!("{} at {from} s", end(from)), format!("{} at {to} s", end(to)));
        Some(match found.drift {
            Some(drift) => {
                let (rate, half) = (1e6 * drift.rate, (1e6 * drift.half_width).max(1e-3));
                let decimals = (1.0 - half.log10()).floor().clamp(0.0, 3.0) as usize;
                format!("  its clock drifts: {rate:.decimals$} ± {half:.decimals$} ppm are added, so {from}, {to}")
            }
            None => format!(
                "  its drift is not resolved by the record; up to 100 ppm, as between two crystals, would make it {from}, {to}"
            ),
        })
    }
}

impl fmt::Display for Account {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.lines().join("\n"))
    }
}

fn rows(count: u64) -> &'static str {
    if count == 1 { "row" } else { "rows" }
}

fn listed(names: &[String]) -> String {
    const MOST: usize = 8;
    let shown = names.iter().take(MOST).cloned().collect::<Vec<_>>().join(", ");
    if names.len() > MOST { format!("{shown} and {} more", names.len() - MOST) } else { shown }
}

/// An uncertainty of an offset that is printed to the nanosecond: below that it is rounding.
fn half_width(value: f64) -> String {
    if value < 1e-9 { "less than 1 ns".to_owned() } else { seconds(value) }
}

/// What begins anew so.
pub(super) fn what_turns(turn: f64) -> String {
    match turn {
        86_400.0 => "midnight has passed".to_owned(),
        43_200.0 => "a clock of twelve hours begins anew".to_owned(),
        3600.0 => "a clock of minutes begins anew".to_owned(),
        turn => format!("a counter rolls over at {turn} s, or another run begins"),
    }
}

/// A time as people write it.
pub(super) fn seconds(value: f64) -> String {
    match value.abs() {
        0.0 => "0 s".to_owned(),
        size if size < 1e-3 => format!("{} us", digits(1e6 * value)),
        size if size < 1.0 => format!("{} ms", digits(1e3 * value)),
        _ => format!("{} s", digits(value)),
    }
}

/// A frequency as people write it.
pub(crate) fn hertz(value: f64) -> String {
    let (value, unit) = if value >= 1e3 { (value / 1e3, "kHz") } else { (value, "Hz") };
    // Ten digits hide how a step of time was rounded.
    let rounded = (value * 1e6).round() / 1e6;
    if rounded > 0.0 { format!("{rounded} {unit}") } else { format!("{value:.3e} {unit}") }
}
