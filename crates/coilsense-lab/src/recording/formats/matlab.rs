//! A MATLAB file of version 5 to 7: its numeric vectors of one length are the columns.
//!
//! Next door: other files that are read as a whole (`mdf`), their rows (`table`).

use std::io::Read;

use flate2::read::ZlibDecoder;
use matfile::{Array, MatFile, NumericData};

use super::super::error::RecordingError;
use super::super::input::Input;
use super::super::selection::TIMES;
use super::super::table::Table;
use super::super::title::Title;
use super::guarded::guarded;

/// Most bytes of such a file: all of it lies in memory.
const MOST_BYTES: u64 = 1 << 30;
/// Most columns of a matrix.
const MOST_COLUMNS: usize = 1000;

/// A variable: its name, rows, and columns one after the other.
struct Variable<'a> {
    name: &'a str,
    rows: usize,
    columns: usize,
    values: Vec<f64>,
}

/// Reads a file.
pub(super) fn read(input: Input) -> Result<Table, RecordingError> {
    let path = input.path().to_owned();
    let path = path.as_path();
    let wrong = |message: String| RecordingError::of_file(path, message);
    let bytes = input.bytes(MOST_BYTES, "a MATLAB file")?;
    let damaged = |message: &dyn std::fmt::Display| wrong(format!("is no MATLAB file that can be read: {message}"));
    let plain = unpacked(&bytes).map_err(|message| damaged(&message))?;
    let parsed = guarded(path, || MatFile::parse(plain.as_slice()).map_err(|error| damaged(&error)))?;
    let variables: Vec<Variable<'_>> = parsed.arrays().iter().filter_map(variable).collect();
    let is_time = |variable: &&Variable<'_>| TIMES.contains(&variable.name.to_lowercase().as_str());
    let rows = match variables.iter().find(is_time) {
        Some(time) => time.rows,
        None => variables.iter().map(|variable| variable.rows).max().unwrap_or(0),
    };
    let (taken, others): (Vec<_>, Vec<_>) = variables.iter().partition(|variable| variable.rows == rows && rows > 1);
    if taken.is_empty() {
        return Err(wrong("has no vector of numbers".to_owned()));
    }
    let others: Vec<String> = others.iter().map(|variable| format!("{} of {}", variable.name, variable.rows)).collect();
    let apart = if others.is_empty() { String::new() } else { format!("; of another length: {}", others.join(", ")) };
    let mut table = Table {
        file: path.to_owned(),
        description: format!("MATLAB 5 to 7, vectors of {rows}{apart}"),
        remarks: Vec::new(),
        titles: Vec::new(),
        columns: Vec::new(),
        lines: (1..=rows as u64).collect(),
    };
    for variable in taken {
        for (index, column) in variable.values.chunks(rows).enumerate() {
            let name = if variable.columns == 1 {
                variable.name.to_owned()
            } else {
                format!("{}(:,{})", variable.name, index + 1)
            };
            table.titles.push(Title { text: name.clone(), name, unit: None, stamps: false });
            table.columns.push(column.to_vec());
        }
    }
    Ok(table)
}

/// The arrays of a file, none of them compressed: the library neither bounds what it inflates nor is silent about what it cannot.
fn unpacked(bytes: &[u8]) -> Result<Vec<u8>, String> {
    const HEADER: usize = 128;
    const MATRIX: u32 = 14;
    const COMPRESSED: u32 = 15;
    let header = bytes.get(..HEADER).ok_or("it is cut off in its header")?;
    let little = header.ends_with(b"IM");
    let word = |bytes: &[u8]| -> Option<u32> {
        let four: [u8; 4] = bytes.get(..4)?.try_into().ok()?;
        Some(if little { u32::from_le_bytes(four) } else { u32::from_be_bytes(four) })
    };
    let (mut plain, mut rest) = (header.to_vec(), &bytes[HEADER..]);
    while let Some((kind, size)) = word(rest).zip(rest.get(4..).and_then(word)) {
        let end = 8 + size as usize;
        let body = rest.get(8..end).ok_or("it is cut off")?;
        match kind {
            MATRIX => plain.extend_from_slice(&rest[..end]),
            COMPRESSED => {
                let before = plain.len();
                let left = (MOST_BYTES + 1).saturating_sub(before as u64);
                let inflated = ZlibDecoder::new(body).take(left).read_to_end(&mut plain);
                inflated.map_err(|_| "a compressed array is damaged")?;
                if plain.len() as u64 > MOST_BYTES {
                    return Err("it is larger than 1 GiB when it is unpacked".to_owned());
                }
                let inner = &plain[before..];
                if word(inner) != Some(MATRIX)
                    || inner.get(4..).and_then(word).map(|size| 8 + size as usize) != Some(inner.len())
                {
                    plain.truncate(before);
                }
            }
            _ => {}
        }
        rest = &rest[end..];
    }
    Ok(plain)
}

/// A vector or matrix of real numbers; a row is a vector, too.
fn variable(array: &Array) -> Option<Variable<'_>> {
    let &[rows, columns] = array.size().as_slice() else { return None };
    let (rows, columns) = if rows == 1 { (columns, 1) } else { (rows, columns) };
    let values = real(array.data())?;
    let fits = columns <= MOST_COLUMNS && rows.checked_mul(columns) == Some(values.len()) && !values.is_empty();
    fits.then_some(Variable { name: array.name(), rows, columns, values })
}

fn real(data: &NumericData) -> Option<Vec<f64>> {
    use NumericData::{Double, Int8, Int16, Int32, Int64, Single, UInt8, UInt16, UInt32, UInt64};
    Some(match data {
        Double { real, imag: None } => real.clone(),
        Single { real, imag: None } => real.iter().map(|value| f64::from(*value)).collect(),
        Int8 { real, imag: None } => real.iter().map(|value| f64::from(*value)).collect(),
        UInt8 { real, imag: None } => real.iter().map(|value| f64::from(*value)).collect(),
        Int16 { real, imag: None } => real.iter().map(|value| f64::from(*value)).collect(),
        UInt16 { real, imag: None } => real.iter().map(|value| f64::from(*value)).collect(),
        Int32 { real, imag: None } => real.iter().map(|value| f64::from(*value)).collect(),
        UInt32 { real, imag: None } => real.iter().map(|value| f64::from(*value)).collect(),
        Int64 { real, imag: None } => real.iter().map(|value| *value as f64).collect(),
        UInt64 { real, imag: None } => real.iter().map(|value| *value as f64).collect(),
        _ => return None,
    })
}
