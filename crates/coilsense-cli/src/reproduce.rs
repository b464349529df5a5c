//! `coilsense reproduce`.

use std::time::Instant;

use coilsense_lab::analysis::AnalysisError;
use coilsense_lab::report::verbs::{PROTOCOL, SPRINGS};
use coilsense_lab::report::{add_reproduction, reproduction_json, reproduction_text};
use coilsense_lab::reproduce::{PaperSprings, Protocol, reproduce};
use coilsense_lab::request::{Given, JSON, OUT};

use crate::progress::Watch;
use crate::{files, terminal};

/// Runs the command.
pub fn run(given: &Given) -> anyhow::Result<()> {
    let begun = Instant::now();
    let springs = match given.file(&SPRINGS) {
        Some(springs) => PaperSprings::read(springs)?,
        None => PaperSprings::built_in()?,
    };
    let protocols: &[Protocol] = match given.text(&PROTOCOL).as_deref() {
        Some("text") => &[Protocol::Text],
        Some("tables") => &[Protocol::Tables],
        _ => &Protocol::ALL,
    };
    let folder = given.needed(&OUT)?;
    let watch = Watch::begin("reproducing")?;
    let mut output = files::folder(given, folder)?;
    let reproduction = reproduce(springs, protocols)?;
    add_reproduction(&reproduction, &mut output)?;
    if watch.is_stopped() {
        return Err(AnalysisError::Interrupted.into());
    }
    let text = if given.holds(&JSON) { reproduction_json(&reproduction)? } else { reproduction_text(&reproduction) };
    let files = output.commit()?;
    let text = text + &terminal::where_to_look(given, files, folder, Some(begun.elapsed()));
    Ok(terminal::answer(given, &text)?)
}
