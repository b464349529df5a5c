//! A workbook: which sheets it has, and their cells one after the other.
//!
//! Next door: what a cell says (`cell`), how workbooks are packed (`archive`).

use std::io::Cursor;

use calamine::{Data, Dimensions, Ods, OdsError, Range, Reader, SheetType, SheetVisible, Xlsx};

use super::archive::{Kind, looked_into};
use super::cell::Value;
use crate::recording::error::shortened;

/// A workbook that is open.
pub(super) enum Book {
    Xlsx(Box<Xlsx<Cursor<Vec<u8>>>>),
    Ods(Ods<Cursor<Vec<u8>>>),
}

/// A sheet of it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Sheet {
    pub name: String,
    pub is_visible: bool,
}

/// Takes a cell: row and column from 0, and what it holds.
pub(super) type Take<'a> = dyn FnMut(u32, u32, Value) -> Result<(), String> + 'a;

/// Why no sheet is read.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum Refusal {
    /// What is wrong, after the file's name.
    Wrong(String),
    /// What it is, and what can be done about it, where FILE is the file.
    Kind(&'static str, &'static str),
}

impl<T: Into<String>> From<T> for Refusal {
    fn from(message: T) -> Self {
        Self::Wrong(message.into())
    }
}

const CONVERT: &str = "which is not read; convert it by: soffice --headless --convert-to xlsx FILE";
const PROTECTED: &str = "is a workbook that opens with a password only; save it without one, or its sheet as CSV";

/// What the library says, on one line.
fn damaged(error: &impl std::fmt::Display) -> String {
    format!("is no workbook that can be read: {}", shortened(&error.to_string()))
}

impl Book {
    /// Opens a workbook of any kind that is read.
    pub fn open(bytes: Vec<u8>) -> Result<Self, Refusal> {
        if !bytes.starts_with(b"PK") {
            // With a password Office packs a workbook into what it wrote before 2007.
            let hidden: Vec<u8> = "EncryptedPackage".encode_utf16().flat_map(u16::to_le_bytes).collect();
            let is_hidden = bytes.windows(hidden.len()).any(|window| window == hidden);
            return Err(if is_hidden {
                PROTECTED.into()
            } else {
                Refusal::Kind("a file of old Office (.xls)", CONVERT)
            });
        }
        match looked_into(&bytes)? {
            Kind::Xlsx => Ok(Self::Xlsx(Box::new(Xlsx::new(Cursor::new(bytes)).map_err(|error| damaged(&error))?))),
            Kind::Ods => match Ods::new(Cursor::new(bytes)) {
                Ok(book) => Ok(Self::Ods(book)),
                Err(OdsError::Password) => Err(PROTECTED.into()),
                Err(other) => Err(damaged(&other).into()),
            },
            Kind::Xlsb => Err(Refusal::Kind("a binary workbook (.xlsb)", CONVERT)),
            Kind::Other => Err(Refusal::Kind("a ZIP archive", "which is not read; unpack it first: unzip FILE")),
        }
    }

    /// In words.
    pub fn kind(&self) -> &'static str {
        match self {
            Self::Xlsx(_) => "Excel workbook (.xlsx)",
            Self::Ods(_) => "OpenDocument spreadsheet (.ods)",
        }
    }

    /// Its sheets of cells, in order.
    pub fn sheets(&self) -> Vec<Sheet> {
        let all = match self {
            Self::Xlsx(book) => book.sheets_metadata(),
            Self::Ods(book) => book.sheets_metadata(),
        };
        let sheets = all.iter().filter(|sheet| sheet.typ == SheetType::WorkSheet);
        sheets
            .map(|sheet| Sheet { name: sheet.name.clone(), is_visible: sheet.visible == SheetVisible::Visible })
            .collect()
    }

    /// Hands out the cells of a sheet that hold something, in the order of the file.
    pub fn cells(&mut self, sheet: &str, take: &mut Take<'_>) -> Result<(), String> {
        match self {
            Self::Xlsx(book) => {
                let mut cells = book.worksheet_cells_reader(sheet).map_err(|error| damaged(&error))?;
                while let Some(cell) = cells.next_cell_with_formula_metadata().map_err(|error| damaged(&error))? {
                    // Programs that do not calculate write formulas so.
                    let formula = cell.formula.map(|_| Value::Text("a formula without a value".to_owned()));
                    let (row, column) = cell.pos;
                    Value::of(&cell.value).or(formula).map_or(Ok(()), |value| take(row, column, value))?;
                }
                Ok(())
            }
            Self::Ods(book) => of_range(&book.worksheet_range(sheet).map_err(|error| damaged(&error))?, take),
        }
    }

    /// Cells of a sheet that are one, where that is known.
    pub fn merged(&mut self, sheet: &str) -> Vec<Dimensions> {
        match self {
            Self::Xlsx(book) => book.merge_cells_by_sheet_name(sheet).unwrap_or_default(),
            Self::Ods(_) => Vec::new(),
        }
    }
}

fn of_range(range: &Range<Data>, take: &mut Take<'_>) -> Result<(), String> {
    let (top, left) = range.start().unwrap_or_default();
    for (row, column, cell) in range.used_cells() {
        let place = u32::try_from(row).ok().zip(u32::try_from(column).ok()).ok_or("is too large")?;
        Value::of(cell).map_or(Ok(()), |value| take(top + place.0, left + place.1, value))?;
    }
    Ok(())
}
