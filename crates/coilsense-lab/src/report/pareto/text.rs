//! A front in the terminal: the answer, then a table of designs.
//!
//! Next door: the same as a page (`html`) and for machines (`json`).

use std::fmt::Write;

use anstyle::Style;

use super::table::{columns, listed, role};
use crate::pareto::{Study, answer};

const BOLD: Style = Style::new().bold();
/// Most designs that are listed.
const MOST: usize = 16;

/// The answer in the first lines, then the named designs and others along the front.
pub fn pareto_text(study: &Study) -> String {
    let mut text = String::new();
    // Writing to a String cannot fail.
    for (index, line) in answer(study).into_iter().enumerate() {
        let _ = if index == 0 { writeln!(text, "{BOLD}{line}{BOLD:#}") } else { writeln!(text, "{line}") };
    }
    let places = listed(study, MOST);
    let columns = columns(study, &places);
    let width = |column: &super::table::Listed| {
        column.cells.iter().chain([&column.title]).map(|cell| cell.chars().count()).max().unwrap_or(0)
    };
    let widths: Vec<usize> = columns.iter().map(width).collect();
    let mut head = format!("{:>9}", "row");
    for (column, width) in columns.iter().zip(&widths) {
        let _ = write!(head, "  {:>width$}", column.title);
    }
    let _ = writeln!(text, "\n{BOLD}{head}{BOLD:#}");
    for (index, place) in places.iter().enumerate() {
        let mut line = format!("{:>9}", study.rows[*place]);
        for (column, width) in columns.iter().zip(&widths) {
            let _ = write!(line, "  {:>width$}", column.cells[index]);
        }
        let role = role(study, *place);
        let _ = writeln!(text, "{line}{}{role}", if role.is_empty() { "" } else { "  " });
    }
    if places.len() < study.rows.len() {
        let _ = writeln!(text, "{} of the {} designs on the front are listed", places.len(), study.rows.len());
    }
    text
}
