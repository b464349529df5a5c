//! Rows of a file that is read as a whole, one after the other.
//!
//! Next door: the readers of such files (`matlab`, `mdf`), their columns (`super::super::table`).

use std::path::Path;

use super::super::error::RecordingError;
use super::super::source::{Next, Source};
use super::super::table::Table;
use super::super::title::Title;

/// Rows of a table, one after the other.
pub(super) struct TableRows {
    table: Table,
    row: usize,
}

impl TableRows {
    /// From the first row on.
    pub fn of(table: Table) -> Self {
        Self { table, row: 0 }
    }
}

impl Source for TableRows {
    fn file(&self) -> &Path {
        &self.table.file
    }

    fn description(&self) -> String {
        self.table.description.clone()
    }

    fn titles(&self) -> &[Title] {
        &self.table.titles
    }

    fn remarks(&self) -> &[String] {
        &self.table.remarks
    }

    fn progress(&self) -> [u64; 2] {
        [self.row as u64, self.table.lines.len() as u64]
    }

    fn whole(&mut self) -> Option<(Vec<Vec<f64>>, Vec<u64>)> {
        self.row = 0;
        Some((std::mem::take(&mut self.table.columns), std::mem::take(&mut self.table.lines)))
    }

    fn next(&mut self, wanted: &[usize], values: &mut Vec<f64>) -> Result<Next, RecordingError> {
        let Some(&line) = self.table.lines.get(self.row) else { return Ok(Next::End) };
        values.clear();
        let cell = |&index: &usize| self.table.columns.get(index).and_then(|column| column.get(self.row)).copied();
        values.extend(wanted.iter().map(|index| cell(index).unwrap_or(f64::NAN)));
        self.row += 1;
        Ok(Next::Row(line))
    }
}
