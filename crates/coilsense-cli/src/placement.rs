//! `coilsense placement`.

use std::io::Write;
use std::path::PathBuf;

use coilsense_lab::output::Output;
use coilsense_lab::placement::Placement;
use coilsense_lab::report::{add_placement, placement_json, placement_text};
use coilsense_lab::spec::Spec;

use crate::date;

/// Options of `coilsense placement`.
#[derive(clap::Args)]
pub struct Arguments {
    /// The spec; its table [control] describes the loop
    #[arg(value_name = "SPEC")]
    spec: PathBuf,
    /// Folder for report.html and results.json; its other files are left alone
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Print JSON
    #[arg(long)]
    json: bool,
    /// Date that the report carries, such as 2026-11-21; without it, today's
    #[arg(long, value_name = "DATE", requires = "out", value_parser = date::parse)]
    date: Option<String>,
}

/// Runs the command.
pub fn run(arguments: &Arguments) -> anyhow::Result<()> {
    let spec = Spec::read(&arguments.spec)?;
    let mut output = arguments.out.as_deref().map(Output::begin).transpose()?;
    let placement = Placement::of(spec)?;
    let text = if arguments.json { placement_json(&placement)? } else { placement_text(&placement) };
    if let Some(output) = &mut output {
        let date = date::or_today(arguments.date.as_ref());
        add_placement(&placement, &date, output)?;
    }
    let files = output.map(Output::commit).transpose()?;
    let mut out = anstream::stdout().lock();
    // A reader that closes the pipe early has all it wants.
    let _ = write!(out, "{text}");
    if let (Some(files), Some(folder), false) = (files, &arguments.out, arguments.json) {
        let _ = writeln!(out, "\n{files} files in {}; open {}", folder.display(), folder.join("report.html").display());
    }
    Ok(())
}
