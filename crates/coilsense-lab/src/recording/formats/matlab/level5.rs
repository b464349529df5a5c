//! The variables of a MATLAB file of version 5 to 7: arrays of numbers, and those in the fields of structs.
//!
//! Next door: elements (`elements`), files of version 4 (`level4`).

use std::io::{BufReader, Read};
use std::path::Path;

use flate2::read::ZlibDecoder;

use super::super::super::error::{RecordingError, shortened};
use super::super::super::order::MOST_NUMBERS;
use super::super::apart::Apart;
use super::super::only_matlab::advice;
use super::super::vectors::Variable;
use super::elements::{Elements, Tag};

/// What a file holds.
#[derive(Default)]
pub(super) struct Found {
    pub variables: Vec<Variable>,
    pub apart: Apart,
    /// How to get at what only MATLAB reads.
    pub advice: Option<String>,
    /// Numbers so far.
    numbers: u64,
    arrays: usize,
}

/// An array before its numbers: its kind, dimensions and name.
struct Head {
    class: u8,
    complex: bool,
    dimensions: Vec<u32>,
    name: String,
}

const HEADER: usize = 128;
const MATRIX: u32 = 14;
const COMPRESSED: u32 = 15;
/// Most arrays of a file, and how deep structs may lie in one another.
const MOST_ARRAYS: usize = 100_000;
const DEEPEST: usize = 16;
/// Longest name of a field.
const LONGEST_FIELD: usize = 256;
/// Most bytes of a file when it is unpacked: the numbers, and as much again for what is passed over.
const MOST_BYTES: u64 = 16 * MOST_NUMBERS as u64;

/// Reads a file.
pub(super) fn read(path: &Path, bytes: impl Read) -> Result<Found, RecordingError> {
    let file = BufReader::with_capacity(1 << 16, bytes);
    let damaged =
        |message: String| RecordingError::of_file(path, format!("is no MATLAB file that can be read: {message}"));
    let mut found = Found::default();
    found.read(file).map_err(damaged)?;
    Ok(found)
}

impl Found {
    fn read(&mut self, mut file: impl Read) -> Result<(), String> {
        let mut header = [0; HEADER];
        file.read_exact(&mut header).map_err(|_| "it is cut off in its header")?;
        let big_endian = !header.ends_with(b"IM");
        let mut unpacked = 0;
        loop {
            let mut first = [0; 1];
            if file.read(&mut first).map_err(|error| error.to_string())? == 0 {
                return Ok(());
            }
            let Tag { kind, size, .. } = Elements::of((&first[..]).chain(&mut file), big_endian).tag()?;
            let mut body = (&mut file).take(size);
            match kind {
                MATRIX => self.matrix(&mut Elements::of(&mut body, big_endian), size, String::new(), 0)?,
                COMPRESSED => {
                    let left = MOST_BYTES - unpacked;
                    let mut elements = Elements::of(ZlibDecoder::new(&mut body).take(left), big_endian);
                    let tag = elements.tag()?;
                    if tag.size + 8 > left {
                        return Err("it is too large to be held in memory".to_owned());
                    }
                    unpacked += tag.size + 8;
                    if tag.kind == MATRIX {
                        self.matrix(&mut elements, tag.size, String::new(), 0)?;
                        elements.end()?;
                    }
                }
                _ => {}
            }
            std::io::copy(&mut body, &mut std::io::sink()).map_err(|error| error.to_string())?;
            if body.limit() > 0 {
                return Err("it is cut off".to_owned());
            }
        }
    }

    /// An array of `size` bytes; `name` is that of a field, empty of a variable.
    fn matrix<R: Read>(&mut self, from: &mut Elements<R>, size: u64, name: String, depth: usize) -> Result<(), String> {
        if size == 0 {
            return Ok(());
        }
        self.arrays += 1;
        if self.arrays > MOST_ARRAYS {
            return Err(format!("it has more than {MOST_ARRAYS} arrays"));
        }
        let end = from.read + size;
        let head = self.head(from, &name)?;
        if let Some(head) = head {
            let name = if name.is_empty() { head.name.clone() } else { name };
            // What has no name at all are the insides of objects.
            match head.class {
                _ if name.is_empty() => {}
                2 if depth < DEEPEST => self.fields(from, &head, &name, depth)?,
                6..=15 if head.complex => self.apart.leave(&name, "complex numbers"),
                6..=15 => self.array(from, &head, name)?,
                1 => self.apart.leave(&name, "a cell"),
                2 => self.apart.leave(&name, "structs too deep in one another"),
                3 => self.apart.leave(&name, "an object"),
                5 => self.apart.leave(&name, "a sparse matrix"),
                _ => {}
            }
        }
        match end.checked_sub(from.read) {
            Some(rest) => from.skip(rest),
            None => Err("the sizes of its arrays do not match".to_owned()),
        }
    }

    /// Kind, dimensions and name; `None` of an object, of which it is told.
    fn head<R: Read>(&mut self, from: &mut Elements<R>, field: &str) -> Result<Option<Head>, String> {
        let flags = from.words()?.first().copied().ok_or("an array in it has no type")?;
        let (class, complex) = (flags as u8, flags & 0x800 != 0);
        if class == 17 {
            let own = from.text()?;
            let name = if field.is_empty() { own } else { field.to_owned() };
            from.text()?;
            let kind = from.text()?;
            if !name.is_empty() {
                self.apart.leave(&name, &format!("a {}", shortened(&kind)));
                self.advice.get_or_insert_with(|| advice(&name, &kind));
            }
            return Ok(None);
        }
        let dimensions = from.words()?;
        Ok(Some(Head { class, complex, dimensions, name: from.text()? }))
    }

    /// The numbers of an array.
    fn array<R: Read>(&mut self, from: &mut Elements<R>, head: &Head, name: String) -> Result<(), String> {
        let &[rows, columns] = head.dimensions.as_slice() else { return Ok(()) };
        let values = from.numbers(MOST_NUMBERS as u64 - self.numbers)?;
        if let Some(variable) = Variable::of(name, [rows as usize, columns as usize], values) {
            self.numbers += variable.values.len() as u64;
            self.variables.push(variable);
        }
        Ok(())
    }

    /// The fields of a struct, or of an array of structs.
    fn fields<R: Read>(&mut self, from: &mut Elements<R>, head: &Head, name: &str, depth: usize) -> Result<(), String> {
        let length = from.words()?.first().copied().unwrap_or(0) as usize;
        let tag = from.tag()?;
        let names = from.bytes(tag)?;
        if length == 0 || names.is_empty() {
            return Ok(());
        }
        if length > LONGEST_FIELD {
            return Err(format!("a field of a struct has a name of more than {LONGEST_FIELD} characters"));
        }
        let names: Vec<String> = names
            .chunks(length)
            .map(|name| String::from_utf8_lossy(name.split(|byte| *byte == 0).next().unwrap_or_default()).into_owned())
            .collect();
        let count = head.dimensions.iter().fold(1_u64, |count, size| count.saturating_mul(u64::from(*size)));
        for place in 1..=count {
            for field in &names {
                let tag = from.tag()?;
                if tag.kind != MATRIX {
                    return Err("a field of a struct is no array".to_owned());
                }
                let name = match count {
                    1 => format!("{name}.{field}"),
                    _ => format!("{name}({place}).{field}"),
                };
                self.matrix(from, tag.size, name, depth + 1)?;
            }
        }
        Ok(())
    }
}
