//! `coilsense spring`.

use coilsense_lab::data_sheet::DataSheet;
use coilsense_lab::report::verbs::MATERIALS;
use coilsense_lab::report::{data_sheet_json, data_sheet_text};
use coilsense_lab::request::{Given, JSON, SPEC};
use coilsense_lab::spec::{self, Spec};
use coilsense_lab::study;

use crate::terminal;

/// Runs the command.
pub fn run(given: &Given) -> anyhow::Result<()> {
    let text = if given.holds(&MATERIALS) {
        spec::materials()?
    } else {
        let spec = Spec::read(given.needed(&SPEC)?)?;
        if given.holds(&JSON) {
            spec.needs_one_spring("spring --json")?;
        }
        let each = spec.each().into_iter().map(|(_, spec)| sheet(spec, given.holds(&JSON)));
        each.collect::<anyhow::Result<Vec<_>>>()?.join("\n")
    };
    Ok(terminal::answer(given, &text)?)
}

/// The data sheet of a spec of one spring.
fn sheet(mut spec: Spec, json: bool) -> anyhow::Result<String> {
    study::prepare(&mut spec.spring, &mut spec.mount, &spec.conditions)?;
    let sheet = DataSheet::of(&spec)?;
    Ok(if json { data_sheet_json(&sheet)? } else { data_sheet_text(&sheet) })
}
