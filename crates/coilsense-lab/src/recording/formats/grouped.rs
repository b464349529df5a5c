//! Groups of channels, each with a clock of its own, as one table at the times of all of them.
//!
//! Next door: the readers whose files have such groups (`mdf`, `tdms`), the table (`super::super::table`).

use std::path::Path;

use super::super::error::RecordingError;
use super::super::order::MOST_NUMBERS;
use super::super::table::Table;
use super::super::title::Title;

/// Channels that were sampled together.
pub(super) struct Group {
    /// The title of its times, which are in seconds where there are several groups.
    pub clock: Title,
    pub times: Vec<f64>,
    pub columns: Vec<(Title, Vec<f64>)>,
}

/// A title of a name and a unit, which may be empty.
pub(super) fn titled(name: &str, unit: &str) -> Title {
    let unit = Some(unit.trim().to_owned()).filter(|unit| !unit.is_empty());
    let text = unit.as_ref().map_or(name.to_owned(), |unit| format!("{name} [{unit}]"));
    Title { text, name: name.to_owned(), unit, stamps: false }
}

/// The channels of all groups at the times of all groups; NaN where one has no value at another's time.
pub(super) fn one_table(
    path: &Path,
    description: String,
    remarks: Vec<String>,
    groups: Vec<Group>,
) -> Result<Table, RecordingError> {
    let too_large = || RecordingError::of_file(path, "is too large to be held in memory");
    let columns: usize = 1 + groups.iter().map(|group| group.columns.len()).sum::<usize>();
    let rows: usize = groups.iter().map(|group| group.times.len()).sum();
    if columns < 2 || rows == 0 {
        return Err(RecordingError::of_file(path, "has no channel of numbers with a clock"));
    }
    if rows > MOST_NUMBERS {
        return Err(too_large());
    }
    let times = one_clock(path, &groups)?;
    if times.len().saturating_mul(columns) > MOST_NUMBERS {
        return Err(too_large());
    }
    let clock = match groups.as_slice() {
        [only] => only.clock.clone(),
        _ => titled("time", "s"),
    };
    let lines = (1..=times.len() as u64).collect();
    let mut table =
        Table { file: path.to_owned(), description, remarks, titles: vec![clock], columns: Vec::new(), lines };
    let alone = groups.len() == 1;
    for group in groups {
        for (title, mut values) in group.columns {
            table.titles.push(title);
            if alone {
                values.resize(times.len(), f64::NAN);
            } else {
                values = spread(&group.times, &values, &times);
            }
            table.columns.push(values);
        }
    }
    table.columns.insert(0, times);
    Ok(table)
}

/// All times of all groups, each once; those of a single group as they are.
fn one_clock(path: &Path, groups: &[Group]) -> Result<Vec<f64>, RecordingError> {
    if let [only] = groups {
        return Ok(only.times.clone());
    }
    for (index, group) in groups.iter().enumerate() {
        if let Some(row) = (1..group.times.len()).find(|&row| {
            !matches!(group.times[row].partial_cmp(&group.times[row - 1]), Some(std::cmp::Ordering::Greater))
        }) {
            let message =
                format!("group {}, row {}: time must rise where several groups are to be one log", index + 1, row + 1);
            return Err(RecordingError::of_file(path, message));
        }
    }
    let mut all: Vec<f64> = groups.iter().flat_map(|group| group.times.iter().copied()).collect();
    all.sort_by(f64::total_cmp);
    all.dedup();
    Ok(all)
}

/// A group's values at the times of all groups; NaN where it has none.
fn spread(own: &[f64], values: &[f64], times: &[f64]) -> Vec<f64> {
    let mut pairs = own.iter().zip(values).peekable();
    times.iter().map(|time| pairs.next_if(|(own, _)| *own == time).map_or(f64::NAN, |(_, value)| *value)).collect()
}
