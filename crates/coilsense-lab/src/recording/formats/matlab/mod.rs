//! A MATLAB file of version 4 to 7: its numeric vectors of one length are the columns, fields of structs by their full names.
//!
//! | file | holds |
//! |---|---|
//! | `level5` | the variables of a file of version 5 to 7, packed or not |
//! | `elements` | the elements that such a file is made of |
//! | `level4` | the variables of a file of version 4, and whether a file is one |
//!
//! Next door: other files that are read as a whole (`mdf`, `tdms`), vectors as a table (`vectors`).
//!
//! Source: MathWorks, "MAT-File Format", versions 4 and 5.

mod elements;
mod level4;
mod level5;

use super::super::error::RecordingError;
use super::super::input::Input;
use super::super::table::Table;
use super::vectors;
use crate::guarded::guarded;

/// Reads a file of version 5 to 7.
pub(super) fn read(input: Input) -> Result<Table, RecordingError> {
    let path = input.path().to_owned();
    let path = path.as_path();
    let found = guarded(path, || level5::read(path, input.stream().bytes))?;
    if let Some(advice) = found.advice.filter(|_| found.variables.iter().all(|variable| variable.rows < 2)) {
        return Err(RecordingError::of_file(path, advice));
    }
    vectors::table(path, "MATLAB 5 to 7", found.variables, &found.apart)
}

/// Whether a file that begins so is one of version 4, by all of it.
pub(super) fn is_level4(input: &mut Input) -> bool {
    level4::is_plausible(input.head()) && input.in_file(level4::is_level4).unwrap_or(false)
}

/// Reads a file of version 4.
pub(super) fn read_level4(input: Input) -> Result<Table, RecordingError> {
    let path = input.path().to_owned();
    let (variables, apart) = level4::read(&path, input.file()?)?;
    vectors::table(&path, "MATLAB 4", variables, &apart)
}
