//! A sheet's cells as the lines of a text, so that titles, units and rows are found as in any other log.
//!
//! Each line is a row of the sheet, from its first on, and has as many cells as the widest, so that rows and columns keep their numbers.
//!
//! Next door: where cells come from (`book`), the text that is made of them (`crate::recording::text`).

use calamine::Dimensions;

use super::book::Book;
use super::cell::Value;
use crate::recording::title::Title;

/// What a sheet holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(super) struct Extent {
    pub rows: u32,
    pub columns: u32,
    /// How many numbers there are.
    pub numbers: u64,
}

/// Most bytes of a sheet as a text.
const MOST_BYTES: usize = 1 << 30;
/// Most cells from its first to its last, those without anything counted.
const MOST_CELLS: u64 = 200_000_000;
/// Rows at the top in which titles may span several.
const TITLES: u32 = 100;

impl Extent {
    /// Looks through a sheet.
    pub fn of(book: &mut Book, sheet: &str) -> Result<Self, String> {
        let (mut extent, mut before) = (Self::default(), (0, 0));
        book.cells(sheet, &mut |row, column, value| {
            if (row, column) < before {
                return Err(format!("sheet {sheet:?}: its cells are out of order; save the workbook anew"));
            }
            before = (row, column);
            extent.rows = row + 1;
            extent.columns = extent.columns.max(column + 1);
            extent.numbers += u64::from(matches!(value, Value::Number(_)));
            Ok(())
        })?;
        let Self { rows, columns, .. } = extent;
        if u64::from(rows) * u64::from(columns) > MOST_CELLS {
            return Err(format!(
                "sheet {sheet:?} spans {rows} rows and {columns} columns, more than can be held in memory; save it as CSV, or clear what stands apart"
            ));
        }
        Ok(extent)
    }
}

/// The lines of a sheet.
pub(super) fn lines(book: &mut Book, sheet: &str, extent: Extent) -> Result<Vec<u8>, String> {
    let columns = extent.columns as usize;
    let mut lines = Lines {
        merged: book.merged(sheet).into_iter().filter(|merged| merged.start.0 < merged.end.0.min(TITLES)).collect(),
        spanning: Vec::new(),
        row: 0,
        cells: vec![None; columns],
        text: Vec::new(),
    };
    book.cells(sheet, &mut |row, column, value| {
        while lines.row < row {
            lines.close()?;
        }
        if let Some(cell) = lines.cells.get_mut(column as usize) {
            *cell = Some(value);
        }
        Ok(())
    })?;
    lines.close()?;
    Ok(lines.text)
}

/// The lines as far as they are made, and the row that is being read.
struct Lines {
    /// Cells over several rows, and the titles that stand in them.
    merged: Vec<Dimensions>,
    spanning: Vec<(Dimensions, Value)>,
    row: u32,
    cells: Vec<Option<Value>>,
    text: Vec<u8>,
}

impl Lines {
    fn close(&mut self) -> Result<(), String> {
        self.span();
        let is_empty = self.cells.iter().all(Option::is_none);
        for (index, cell) in self.cells.iter_mut().enumerate() {
            if index > 0 && !is_empty {
                self.text.push(b'\t');
            }
            if let Some(value) = cell.take() {
                value.write(&mut self.text);
            }
        }
        self.text.push(b'\n');
        self.row += 1;
        if self.text.len() > MOST_BYTES {
            return Err("has a sheet that is too large to be held in memory; save it as CSV".to_owned());
        }
        Ok(())
    }

    /// A title that spans several rows stands in all of them, but for a row of units below titles, where it would be taken for none.
    fn span(&mut self) {
        let is_unit = |cell: &Value| matches!(cell, Value::Text(text) if Title::unit_below(text).is_some());
        if !self.cells.iter().flatten().all(is_unit) {
            for (merged, title) in &self.spanning {
                let cell = self.cells.get_mut(merged.start.1 as usize);
                if let Some(cell) = cell.filter(|cell| cell.is_none() && self.row <= merged.end.0) {
                    *cell = Some(title.clone());
                }
            }
        }
        for merged in self.merged.iter().filter(|merged| merged.start.0 == self.row) {
            let cell = self.cells.get(merged.start.1 as usize).and_then(Option::as_ref);
            if let Some(title @ Value::Text(_)) = cell {
                self.spanning.push((*merged, title.clone()));
            }
        }
    }
}
