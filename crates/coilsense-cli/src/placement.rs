//! `coilsense placement`.

use coilsense_lab::output::Output;
use coilsense_lab::placement::Placement;
use coilsense_lab::report::{add_placement, placement_json, placement_text};
use coilsense_lab::request::{Given, JSON, OUT, SPEC};
use coilsense_lab::spec::Spec;

use crate::{date, files, terminal};

/// Runs the command.
pub fn run(given: &Given) -> anyhow::Result<()> {
    let spec = Spec::read(given.needed(&SPEC)?)?;
    let mut output = files::asked(given)?;
    let placement = Placement::of(spec)?;
    let mut text = if given.holds(&JSON) { placement_json(&placement)? } else { placement_text(&placement) };
    if let Some(output) = &mut output {
        let date = date::or_today(given);
        add_placement(&placement, &date, output)?;
    }
    let files = output.map(Output::commit).transpose()?;
    if let (Some(files), Some(folder)) = (files, given.file(&OUT)) {
        text.push_str(&terminal::where_to_look(given, files, folder, None));
    }
    Ok(terminal::answer(given, &text)?)
}
