//! `coilsense spring`.

use std::io::Write;
use std::path::PathBuf;

use anyhow::Context;
use coilsense_lab::data_sheet::DataSheet;
use coilsense_lab::report::{data_sheet_json, data_sheet_text};
use coilsense_lab::spec::{self, Spec};
use coilsense_lab::study;

/// Options of `coilsense spring`.
#[derive(clap::Args)]
pub struct Arguments {
    /// The spec; its [spring] and [mount] make the sheet, its conditions say how many masses its chain needs
    #[arg(value_name = "SPEC", required_unless_present = "materials")]
    spec: Option<PathBuf>,
    /// Print JSON
    #[arg(long)]
    json: bool,
    /// List the material table in place of a data sheet
    #[arg(long, conflicts_with_all = ["spec", "json"])]
    materials: bool,
}

/// Runs the command.
pub fn run(arguments: &Arguments) -> anyhow::Result<()> {
    let text = if arguments.materials {
        spec::materials()?
    } else {
        let path = arguments.spec.as_ref().context("a SPEC is needed")?;
        let mut spec = Spec::read(path)?;
        study::prepare(&mut spec.spring, &mut spec.mount, &spec.conditions)?;
        let sheet = DataSheet::of(&spec)?;
        if arguments.json { data_sheet_json(&sheet)? } else { data_sheet_text(&sheet) }
    };
    // A reader that closes the pipe early has all it wants.
    let _ = write!(anstream::stdout().lock(), "{text}");
    Ok(())
}
