//! Vectors and matrices by name, as one table of those whose lengths agree.
//!
//! Next door: the readers whose files hold such (`matlab`), the table (`super::super::table`).

use std::path::Path;

use super::super::error::{RecordingError, shortened};
use super::super::selection::TIMES;
use super::super::table::Table;
use super::super::title::Title;
use super::apart::Apart;

/// A vector, or the columns of a matrix one after the other.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Variable {
    pub name: String,
    pub unit: Option<String>,
    pub rows: usize,
    pub columns: usize,
    pub values: Vec<f64>,
}

/// Most columns of a matrix.
const MOST_COLUMNS: usize = 1000;
/// Most variables of another length that are named.
const MOST_NAMED: usize = 8;

impl Variable {
    /// Of a matrix that is stored column by column; a row is a vector, too. `None` of what is no such thing.
    pub fn of(name: String, [rows, columns]: [usize; 2], values: Vec<f64>) -> Option<Self> {
        let (rows, columns) = if rows == 1 { (columns, 1) } else { (rows, columns) };
        let fits = columns <= MOST_COLUMNS && rows.checked_mul(columns) == Some(values.len()) && !values.is_empty();
        fits.then_some(Self { name, unit: None, rows, columns, values })
    }

    fn is_time(&self) -> bool {
        let last = self.name.rsplit(['.', '/']).next().unwrap_or_default();
        TIMES.contains(&last.to_lowercase().as_str())
    }
}

/// The variables of the length of the time, or else of the longest.
pub(super) fn table(
    path: &Path,
    format: &str,
    variables: Vec<Variable>,
    apart: &Apart,
) -> Result<Table, RecordingError> {
    let rows = match variables.iter().find(|variable| variable.is_time()) {
        Some(time) => time.rows,
        None => variables.iter().map(|variable| variable.rows).max().unwrap_or(0),
    };
    let (taken, others): (Vec<_>, Vec<_>) = variables.into_iter().partition(|one| one.rows == rows && rows > 1);
    if taken.is_empty() {
        return Err(RecordingError::of_file(path, format!("has no vector of numbers{}", apart.told())));
    }
    let named = others.iter().take(MOST_NAMED).map(|one| format!("{} of {}", shortened(&one.name), one.rows));
    let mut named: Vec<String> = named.collect();
    if others.len() > MOST_NAMED {
        named.push(format!("and {} more", others.len() - MOST_NAMED));
    }
    let others = if named.is_empty() { String::new() } else { format!("; of another length: {}", named.join(", ")) };
    let mut table = Table {
        file: path.to_owned(),
        description: format!("{format}, vectors of {rows}{others}{}", apart.told()),
        remarks: Vec::new(),
        titles: Vec::new(),
        columns: Vec::new(),
        lines: (1..=rows as u64).collect(),
    };
    for Variable { name, unit, columns, values, .. } in taken {
        let titled = |name: String| {
            let text = unit.as_ref().map_or(name.clone(), |unit| format!("{name} [{unit}]"));
            Title { text, name, unit: unit.clone(), stamps: false }
        };
        if columns == 1 {
            table.titles.push(titled(name));
            table.columns.push(values);
            continue;
        }
        for (index, column) in values.chunks(rows).enumerate() {
            table.titles.push(titled(format!("{name}(:,{})", index + 1)));
            table.columns.push(column.to_vec());
        }
    }
    Ok(table)
}
