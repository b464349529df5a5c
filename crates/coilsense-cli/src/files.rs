//! Where a command writes, and what it may replace there.
//!
//! Next door: how files come to disk (`coilsense_lab::output`), the options (`coilsense_lab::request`).

use std::fs::File;
use std::io::{self, BufWriter};
use std::path::Path;

use coilsense_lab::identification::request::SPEC_OUT;
use coilsense_lab::input;
use coilsense_lab::output::{Output, OutputError};
use coilsense_lab::report::verbs::{CSV, REPORT};
use coilsense_lab::request::{Given, OUT, OVERWRITE, Takes, Verb};

/// Remembers all files that are named to be read, so that none is overwritten.
pub fn remember(verb: &Verb, given: &Given) {
    input::remember();
    let read = verb.rows().filter(|row| matches!(row.takes, Takes::File(_)));
    let read = read.filter(|row| ![OUT.name, SPEC_OUT.name, REPORT.name, CSV.name].contains(&row.name));
    read.filter_map(|row| given.file(row)).for_each(input::note);
}

/// A folder that is written.
pub fn folder(given: &Given, path: &Path) -> Result<Output, OutputError> {
    Ok(Output::begin(path)?.overwriting(given.holds(&OVERWRITE)))
}

/// The folder of --out, where one is named.
pub fn asked(given: &Given) -> Result<Option<Output>, OutputError> {
    given.file(&OUT).map(|path| folder(given, path)).transpose()
}

/// One file that is written, and its name in its folder; refused at once where it must not be.
pub fn one(given: &Given, path: &Path) -> Result<(Output, String), OutputError> {
    let (output, name) = Output::of_file(path)?;
    let output = output.overwriting(given.holds(&OVERWRITE));
    output.check(&name)?;
    Ok((output, name))
}

/// Writes one file, whole or not at all.
pub fn write_one(
    given: &Given,
    path: &Path,
    write: impl FnOnce(&mut BufWriter<File>) -> io::Result<()>,
) -> Result<(), OutputError> {
    let (mut output, name) = one(given, path)?;
    output.write(&name, write)?;
    output.commit()?;
    Ok(())
}
