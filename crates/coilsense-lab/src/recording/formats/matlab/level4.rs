//! A MATLAB file of version 4: headers of twenty bytes, each before a name and numbers, and nothing that says so at the beginning.
//!
//! Next door: files of version 5 to 7 (`level5`), types of numbers (`elements`).

use std::fs::File;
use std::io::{BufReader, Read, Seek, SeekFrom};
use std::path::Path;

use super::super::super::error::RecordingError;
use super::super::super::order::MOST_NUMBERS;
use super::super::apart::Apart;
use super::super::vectors::Variable;
use super::elements::number;

/// A variable before its numbers.
#[derive(Debug, Clone, PartialEq)]
struct Head {
    name: String,
    rows: usize,
    columns: usize,
    complex: bool,
    /// Its type as `elements` counts them.
    kind: u32,
    /// 0 of numbers, 1 of a text, 2 of a sparse matrix.
    form: u32,
    big_endian: bool,
    bytes: u64,
}

/// Most variables of a file, and the longest name with its end.
const MOST: usize = 100_000;
const LONGEST_NAME: u32 = 64;
/// Types in the order of their digit: double, single, int32, int16, uint16, uint8.
const KINDS: [u32; 6] = [9, 7, 5, 3, 4, 2];

/// Whether a file may begin so.
pub(super) fn is_plausible(head: &[u8]) -> bool {
    head.get(..4).and_then(|four| four.try_into().ok()).is_some_and(|four| kind(four).is_some())
}

/// Whether a file is one: a chain of plausible headers from its first byte to its last.
pub(super) fn is_level4(file: &mut File) -> bool {
    heads(file).is_some_and(|heads| !heads.is_empty())
}

/// The variables of a file.
pub(super) fn read(path: &Path, mut file: File) -> Result<(Vec<Variable>, Apart), RecordingError> {
    let wrong = |message: &str| RecordingError::of_file(path, message);
    let heads = heads(&mut file).ok_or_else(|| wrong("is no MATLAB file of version 4"))?;
    file.seek(SeekFrom::Start(0)).map_err(|_| wrong("cannot be read"))?;
    let mut file = BufReader::new(file);
    let (mut variables, mut apart, mut numbers) = (Vec::new(), Apart::default(), 0_usize);
    for head in heads {
        let begins = 20 + head.name.len() as i64 + 1;
        let skipped = match (head.form, head.complex) {
            (0, false) => None,
            (1, _) => Some("a text"),
            (2, _) => Some("a sparse matrix"),
            _ => Some("complex numbers"),
        };
        let cut = |_: std::io::Error| wrong("is cut off");
        file.seek_relative(begins).map_err(cut)?;
        if let Some(why) = skipped {
            apart.leave(&head.name, why);
            file.seek_relative(head.bytes as i64).map_err(cut)?;
            continue;
        }
        let Some((size, value)) = number(head.kind, head.big_endian) else { continue };
        numbers = numbers.saturating_add(head.rows * head.columns);
        if numbers > MOST_NUMBERS {
            return Err(wrong("is too large to be held in memory"));
        }
        let mut values = Vec::with_capacity(head.rows * head.columns);
        let mut bytes = [0; 8];
        for _ in 0..head.rows * head.columns {
            file.read_exact(&mut bytes[..size as usize]).map_err(cut)?;
            values.push(value(&bytes));
        }
        variables.extend(Variable::of(head.name, [head.rows, head.columns], values));
    }
    Ok((variables, apart))
}

/// Type, form and order of bytes that the first number of a header tells.
fn kind(bytes: [u8; 4]) -> Option<(u32, u32, bool)> {
    let of = |digits: u32| {
        let (kind, form) = (KINDS.get(digits as usize / 10)?, digits % 10);
        (form <= 2).then_some((*kind, form))
    };
    let (little, big) = (u32::from_le_bytes(bytes), u32::from_be_bytes(bytes));
    let little = (little < 100).then(|| of(little)).flatten().map(|(kind, form)| (kind, form, false));
    little.or_else(|| of(big.checked_sub(1000).filter(|digits| *digits < 100)?).map(|(kind, form)| (kind, form, true)))
}

/// All headers, where they lead to the end of the file and not beyond.
fn heads(file: &mut File) -> Option<Vec<Head>> {
    let size = file.metadata().ok()?.len();
    file.seek(SeekFrom::Start(0)).ok()?;
    let mut file = BufReader::new(file);
    let (mut heads, mut place) = (Vec::new(), 0_u64);
    while place < size && heads.len() < MOST {
        let mut fixed = [0; 20];
        file.read_exact(&mut fixed).ok()?;
        let words: Vec<[u8; 4]> = fixed.chunks_exact(4).map(|four| [four[0], four[1], four[2], four[3]]).collect();
        let (kind, form, big_endian) = kind(words[0])?;
        let word =
            |index: usize| if big_endian { u32::from_be_bytes(words[index]) } else { u32::from_le_bytes(words[index]) };
        let (rows, columns, complex, length) = (word(1), word(2), word(3), word(4));
        if complex > 1 || !(2..=LONGEST_NAME).contains(&length) || rows > i32::MAX as u32 || columns > i32::MAX as u32 {
            return None;
        }
        let mut name = vec![0; length as usize];
        file.read_exact(&mut name).ok()?;
        let name = String::from_utf8(name).ok()?;
        let name = name.strip_suffix('\0').filter(|name| is_name(name))?.to_owned();
        let each = number(kind, big_endian)?.0 << complex;
        let bytes = u64::from(rows).checked_mul(u64::from(columns))?.checked_mul(each)?;
        place = place.checked_add(20 + u64::from(length))?.checked_add(bytes).filter(|end| *end <= size)?;
        file.seek(SeekFrom::Start(place)).ok()?;
        let complex = complex == 1;
        heads.push(Head {
            name,
            rows: rows as usize,
            columns: columns as usize,
            complex,
            kind,
            form,
            big_endian,
            bytes,
        });
    }
    (place == size).then_some(heads)
}

/// Whether MATLAB would take it for a name.
fn is_name(name: &str) -> bool {
    name.starts_with(|c: char| c.is_ascii_alphabetic()) && name.chars().all(|c| c.is_ascii_alphanumeric() || c == '_')
}
