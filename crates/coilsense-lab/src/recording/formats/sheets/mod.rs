//! A sheet of a workbook of Excel or of OpenDocument, read as the text that it looks like.
//!
//! | file | holds |
//! |---|---|
//! | `archive` | what a workbook is packed into, and how large it is |
//! | `book` | its sheets and their cells |
//! | `cell` | a cell as text |
//! | `grid` | a sheet as lines of text |
//!
//! Next door: texts (`text`), where titles, units and rows are found (`trial`).

mod archive;
mod book;
mod cell;
mod grid;

use super::super::error::{RecordingError, clipped};
use super::super::input::Input;
use super::super::mapping::Format;
use super::super::text::Text;
use crate::guarded::guarded;
use book::{Book, Refusal};
use grid::Extent;

/// Most bytes of a workbook.
const MOST_BYTES: u64 = 256 << 20;
/// A sheet with so many times fewer numbers than the largest holds settings, not the log.
const SETTINGS: u64 = 10;
/// Most sheets whose names are told.
const MOST_NAMES: usize = 5;

/// Opens the sheet that is told, or the first that holds a log.
pub(super) fn open(input: Input, format: &Format) -> Result<Text, RecordingError> {
    let path = input.path().to_owned();
    let bytes = input.bytes(MOST_BYTES, "a workbook")?;
    guarded(&path, || {
        let (what, lines) = sheet(bytes, format).map_err(|refusal| {
            let message = match refusal {
                Refusal::Wrong(message) => message,
                Refusal::Kind(name, advice) => super::advised(&path, name, advice),
            };
            RecordingError::of_file(&path, message)
        })?;
        // What parts its cells is known; all else is found out, or told.
        let format = Format { delimiter: Some('\t'), ..format.clone() };
        Text::held(&path, lines, &format).map(|text| text.described(what))
    })
}

/// What was taken, in words, and its lines.
fn sheet(bytes: Vec<u8>, format: &Format) -> Result<(String, Vec<u8>), Refusal> {
    let mut book = Book::open(bytes)?;
    let sheets = book.sheets();
    let names = |names: &[&str]| {
        let shown: Vec<String> = names.iter().take(MOST_NAMES).map(|name| clipped(name)).collect();
        let more = names.len().saturating_sub(MOST_NAMES);
        shown.join(", ") + &if more > 0 { format!(" and {more} more") } else { String::new() }
    };
    let all: Vec<&str> = sheets.iter().map(|sheet| sheet.name.as_str()).collect();
    let kind = book.kind();
    if let Some(told) = &format.sheet {
        let found = sheets.iter().find(|sheet| sheet.name == *told);
        let found = found.or_else(|| sheets.iter().find(|sheet| sheet.name.eq_ignore_ascii_case(told)));
        let found = found.ok_or_else(|| format!("no sheet is called {}; it has {}", clipped(told), names(&all)))?;
        let extent = Extent::of(&mut book, &found.name)?;
        let what = format!("{kind}, sheet {}", clipped(&found.name));
        return Ok((what, grid::lines(&mut book, &found.name, extent)?));
    }
    let mut extents = Vec::new();
    for sheet in sheets.iter().filter(|sheet| sheet.is_visible) {
        extents.push((sheet.name.as_str(), Extent::of(&mut book, &sheet.name)?));
    }
    let most = extents.iter().map(|(_, extent)| extent.numbers).max().unwrap_or(0);
    extents.retain(|(_, extent)| extent.numbers > 0 && extent.numbers >= most / SETTINGS);
    let Some(((name, extent), others)) = extents.split_first() else {
        return Err(format!("has no sheet with numbers; it has {}", names(&all)).into());
    };
    let others: Vec<&str> = others.iter().map(|(name, _)| *name).collect();
    let also = match others.first() {
        Some(other) => {
            format!(" (numbers are in {}, too; sheet = {other:?} under [log] of a mapping takes that)", names(&others))
        }
        None => String::new(),
    };
    Ok((format!("{kind}, sheet {}{also}", clipped(name)), grid::lines(&mut book, name, *extent)?))
}
