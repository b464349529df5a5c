//! `coilsense placement`.

use std::io::Write;

use coilsense_lab::output::Output;
use coilsense_lab::placement::Placement;
use coilsense_lab::report::{add_placement, placement_json, placement_text};
use coilsense_lab::request::{Given, JSON, OUT, SPEC};
use coilsense_lab::spec::Spec;

use crate::date;

/// Runs the command.
pub fn run(given: &Given) -> anyhow::Result<()> {
    let spec = Spec::read(given.needed(&SPEC)?)?;
    let mut output = given.file(&OUT).map(Output::begin).transpose()?;
    let placement = Placement::of(spec)?;
    let text = if given.holds(&JSON) { placement_json(&placement)? } else { placement_text(&placement) };
    if let Some(output) = &mut output {
        let date = date::or_today(given);
        add_placement(&placement, &date, output)?;
    }
    let files = output.map(Output::commit).transpose()?;
    let mut out = anstream::stdout().lock();
    // A reader that closes the pipe early has all it wants.
    let _ = write!(out, "{text}");
    if let (Some(files), Some(folder), false) = (files, given.file(&OUT), given.holds(&JSON)) {
        let _ = writeln!(out, "\n{files} files in {}; open {}", folder.display(), folder.join("report.html").display());
    }
    Ok(())
}
