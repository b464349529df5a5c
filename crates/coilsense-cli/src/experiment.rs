//! `coilsense experiment`.

use std::time::Instant;

use coilsense_lab::experiment::{Experiment, Findings};
use coilsense_lab::recording::Cleaning;
use coilsense_lab::report::verbs::FOLDER;
use coilsense_lab::report::{add_experiment, experiment_json, experiment_text};
use coilsense_lab::request::{DATE, Given, JSON, OUT};

use crate::{date, files, terminal};

/// Runs the command.
pub fn run(given: &Given) -> anyhow::Result<()> {
    let begun = Instant::now();
    let experiment = Experiment::read(given.needed(&FOLDER)?, &Cleaning::of(given))?;
    let findings = Findings::of(&experiment);
    let folder = given.needed(&OUT)?;
    let mut output = files::folder(given, folder)?;
    let date = date::or_today(given);
    add_experiment(&experiment, &findings, &date, &mut output)?;
    let text = match given.holds(&JSON) {
        true => experiment_json(&experiment, &findings, given.text(&DATE).as_deref())?,
        false => experiment_text(&experiment, &findings),
    };
    let files = output.commit()?;
    let text = text + &terminal::where_to_look(given, files, folder, Some(begun.elapsed()));
    Ok(terminal::answer(given, &text)?)
}
