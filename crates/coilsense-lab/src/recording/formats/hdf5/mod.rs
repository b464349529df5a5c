//! An HDF5 file, and MATLAB's of version 7.3, which is one: its numeric datasets of one length are the columns.
//!
//! | file | holds |
//! |---|---|
//! | `datasets` | which datasets there are, and their numbers |
//! | `members` | the numbers among the bytes of a row |
//!
//! Next door: MATLAB files of version 4 to 7 (`matlab`), vectors as a table (`vectors`).

mod datasets;
mod members;

use super::super::error::RecordingError;
use super::super::input::Input;
use super::super::table::Table;
use super::vectors::{self, Variable};
use crate::guarded::guarded;
use datasets::{Datasets, Order};

/// Reads a file.
pub(super) fn read(input: Input) -> Result<Table, RecordingError> {
    of(input, "HDF5", Order::Rows)
}

/// Reads a file of MATLAB's, which stores a matrix column by column.
pub(super) fn read_matlab(input: Input) -> Result<Table, RecordingError> {
    of(input, "MATLAB 7.3", Order::Columns)
}

fn of(input: Input, format: &str, order: Order) -> Result<Table, RecordingError> {
    let path = input.path().to_owned();
    let path = path.as_path();
    let file = input.file()?;
    let wrong = |message: String| RecordingError::of_file(path, message);
    let damaged = |message: String| wrong(format!("is no HDF5 file that can be read: {message}"));
    let mut found = Datasets::of(order);
    guarded(path, || found.read(path, file).map_err(damaged))?;
    let Datasets { variables, apart, advice, .. } = found;
    match advice.filter(|_| variables.iter().all(|variable| variable.rows < 2)) {
        Some(advice) => Err(wrong(advice)),
        None => vectors::table(path, format, named(variables), &apart),
    }
}

/// Variables without the folder that all of them share.
fn named(mut variables: Vec<Variable>) -> Vec<Variable> {
    let folder = |name: &str| name.rsplit_once('/').map(|(folder, _)| format!("{folder}/"));
    let shared = variables.first().and_then(|first| folder(&first.name));
    if let Some(shared) = shared.filter(|shared| variables.iter().all(|one| folder(&one.name).as_ref() == Some(shared)))
    {
        for variable in &mut variables {
            variable.name.drain(..shared.len());
        }
    }
    variables
}
