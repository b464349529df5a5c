//! What is in a log: for people, and for machines.
//!
//! Next door: the page with figures (`super`), the log itself (`crate::recording`).

use std::path::Path;

use serde::Serialize;

use super::super::ReportError;
use super::super::outcome::{Outcome, to_json};
use crate::message::Door;
use crate::quantity::digits;
use crate::recording::{ClockOverview, ColumnOverview, Overview, hertz};

/// What `coilsense import LOG` says of a log where nothing is to be written.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "reference", derive(schemars::JsonSchema))]
pub struct OverviewOutcome<'a> {
    /// The log.
    pub file: &'a Path,
    /// How it is written.
    pub format: &'a str,
    /// Rows.
    pub rows: u64,
    /// Rows with too many or too few cells.
    pub broken: u64,
    /// Its columns.
    pub columns: Vec<ColumnOutcome<'a>>,
    /// Its clock; null where nothing tells one.
    pub clock: Option<ClockOutcome>,
    /// What stands above the rows.
    pub remarks: &'a [String],
    /// What is to be told before it can be imported, with the options that say it; null where all is told.
    pub lacks: Option<String>,
}

/// A column of a log.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "reference", derive(schemars::JsonSchema))]
pub struct ColumnOutcome<'a> {
    /// From 1.
    pub number: usize,
    /// Its title without the unit.
    pub name: &'a str,
    /// Its unit; null where none is told.
    pub unit: Option<&'a str>,
    /// The channel it is taken for; null where it is taken for none.
    pub channel: Option<&'a str>,
    /// Values.
    pub values: u64,
    /// Rows without one.
    pub missing: u64,
    /// Smallest and largest value, in its own unit; null without values.
    pub range: Option<[f64; 2]>,
    /// Their mean.
    pub mean: Option<f64>,
    /// How many values differ from the one before.
    pub changes: u64,
}

/// The clock of a log.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "reference", derive(schemars::JsonSchema))]
pub struct ClockOutcome {
    /// First and last time.
    pub span_s: [f64; 2],
    /// The usual step.
    pub usual_step_s: f64,
    /// The rate that people would have set for it.
    pub nominal_rate_hz: f64,
    /// Smallest and largest step.
    pub steps_s: [f64; 2],
    /// Steps of more than one and a half usual ones.
    pub gaps: u64,
    /// Rows whose time is that of the one before.
    pub repeated: u64,
    /// Rows whose time goes back.
    pub back: u64,
    /// How often it begins anew, at midnight or where a counter rolls over.
    pub turns: u64,
}

impl Outcome for OverviewOutcome<'_> {
    const SCHEMA: &'static str = "coilsense/log/1";
}

/// What is in a log, as JSON.
///
/// # Errors
/// [`ReportError`] where it cannot be written.
pub fn overview_json(overview: &Overview) -> Result<String, ReportError> {
    let clock = |clock: &ClockOverview| ClockOutcome {
        span_s: clock.span,
        usual_step_s: clock.usual,
        nominal_rate_hz: clock.rate(),
        steps_s: clock.steps,
        gaps: clock.gaps,
        repeated: clock.repeated,
        back: clock.back,
        turns: clock.turns.as_ref().map_or(0, |(count, _)| *count),
    };
    let text = to_json(OverviewOutcome {
        file: &overview.file,
        format: &overview.description,
        rows: overview.rows,
        broken: overview.broken,
        columns: overview.columns.iter().map(column_outcome).collect(),
        clock: overview.clock.as_ref().map(clock),
        remarks: &overview.remarks,
        lacks: overview.lacks.as_ref().map(|message| message.told(Door::Command)),
    })?;
    Ok(text)
}

fn column_outcome(column: &ColumnOverview) -> ColumnOutcome<'_> {
    ColumnOutcome {
        number: column.number,
        name: &column.name,
        unit: column.unit.as_deref(),
        channel: column.channel,
        values: column.summary.count,
        missing: column.summary.missing,
        range: column.summary.range,
        mean: column.summary.mean(),
        changes: column.summary.changes,
    }
}

/// Width of a column's course in signs, and most columns that are shown.
const COURSE: usize = 32;
const MOST_COLUMNS: usize = 64;

/// What is in a log, for people.
pub fn overview_text(overview: &Overview) -> String {
    let mut lines = summary(overview);
    let rows = lines.split_off(1);
    lines.extend(rows.into_iter().take(1).map(|line| format!("  {line}")));
    let header = ["", "column", "unit", "as", "from", "to", "mean", "", ""].map(str::to_owned);
    let table: Vec<[String; 9]> = std::iter::once(header).chain(columns(overview)).collect();
    lines.extend(aligned(&table));
    if overview.columns.len() > MOST_COLUMNS {
        lines.push(format!("  and {} columns more", overview.columns.len() - MOST_COLUMNS));
    }
    lines.extend(
        overview.clock.iter().flat_map(|clock| irregular(clock, overview.rows)).map(|line| format!("  {line}")),
    );
    lines.extend(overview.remarks.iter().take(3).map(|remark| format!("  header: {remark}")));
    match &overview.lacks {
        Some(message) => lines.push(format!("still needed to import it: {message}")),
        None => lines.push(
            "ready: add --out FILE to import it or --report DIR for a page, or go on with identify, calibrate or mitigate"
                .to_owned(),
        ),
    }
    lines.join("\n") + "\n"
}

/// The file, its rows, and what is odd about its clock, a line each.
pub(super) fn summary(overview: &Overview) -> Vec<String> {
    let first = [format!("{}: {}", overview.file.display(), overview.description), rows(overview)];
    let clock = overview.clock.iter().flat_map(|clock| irregular(clock, overview.rows));
    first.into_iter().chain(clock).collect()
}

/// The rows of the table of columns: number, name, unit, channel, range, mean, course, what is odd.
pub(super) fn columns(overview: &Overview) -> Vec<[String; 9]> {
    let span = overview.clock.as_ref().map(|clock| clock.span[1] - clock.span[0]);
    let row = |column: &ColumnOverview| {
        let [from, to] = column.summary.range.map_or([String::new(), String::new()], |range| range.map(digits));
        [
            format!("#{}", column.number),
            column.name.clone(),
            column.unit.clone().unwrap_or_default(),
            column.channel.unwrap_or("–").to_owned(),
            from,
            to,
            column.summary.mean().map_or(String::new(), digits),
            column.summary.sparkline(COURSE),
            said(column, overview.rows, span),
        ]
    };
    overview.columns.iter().take(MOST_COLUMNS).map(row).collect()
}

fn rows(overview: &Overview) -> String {
    let broken = if overview.broken > 0 {
        format!(", {} with too many or too few cells", overview.broken)
    } else {
        String::new()
    };
    match &overview.clock {
        Some(clock) => {
            let [from, to] = clock.span;
            let rate = hertz(clock.rate());
            format!("{} rows{broken}; {rate}, from {from} s to {to} s", overview.rows)
        }
        None => format!("{} rows{broken}; no column is recognised as the time", overview.rows),
    }
}

/// What is odd about a column: values that are not there, a device slower than the rows.
fn said(column: &ColumnOverview, rows: u64, span: Option<f64>) -> String {
    let summary = &column.summary;
    let mut said = Vec::new();
    if summary.missing > 0 {
        said.push(format!("missing in {} of {rows} rows", summary.missing));
    }
    let slow = summary.count > 100 && summary.changes > 0 && 3 * summary.changes < summary.count;
    if let (true, Some(span)) = (slow && column.channel != Some("time"), span.filter(|span| *span > 0.0)) {
        said.push(format!("changes {} times a second", digits(summary.changes as f64 / span)));
    }
    if summary.changes == 0 && summary.count > 1 {
        said.push("constant".to_owned());
    }
    said.join(", ")
}

/// What is odd about the clock.
fn irregular(clock: &ClockOverview, rows: u64) -> Vec<String> {
    let [least, largest] = clock.steps;
    let mut lines = Vec::new();
    if let Some((count, what)) = &clock.turns {
        let times = if *count == 1 { "once".to_owned() } else { format!("{count} times") };
        lines.push(format!("{times}: {what}"));
    }
    for (count, what) in [(clock.back, "go back in time"), (clock.repeated, "have the time of the row before")] {
        if count > 0 {
            lines.push(format!("{count} of {rows} rows {what}"));
        }
    }
    if clock.gaps > 0 {
        lines.push(format!("{} gaps, the longest {} s", clock.gaps, digits(largest)));
    } else if largest - least > 1e-3 * clock.usual {
        lines.push(format!("its steps of time are from {} to {} s", digits(least), digits(largest)));
    }
    lines
}

/// Rows of a table below each other; numbers to the right.
fn aligned(table: &[[String; 9]]) -> Vec<String> {
    let width = |column: usize| table.iter().map(|row| row[column].chars().count()).max().unwrap_or(0);
    let widths: Vec<usize> = (0..9).map(width).collect();
    let line = |row: &[String; 9]| {
        let cells = row.iter().zip(&widths).enumerate().map(|(column, (cell, &width))| {
            let space = " ".repeat(width - cell.chars().count());
            if (4..7).contains(&column) { format!("{space}{cell}") } else { format!("{cell}{space}") }
        });
        format!("  {}", cells.collect::<Vec<_>>().join("  ")).trim_end().to_owned()
    };
    table.iter().map(line).collect()
}
