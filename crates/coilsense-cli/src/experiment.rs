//! `coilsense experiment`.

use std::io::Write;
use std::time::Instant;

use coilsense_lab::experiment::{Experiment, Findings};
use coilsense_lab::output::Output;
use coilsense_lab::recording::Cleaning;
use coilsense_lab::report::verbs::FOLDER;
use coilsense_lab::report::{add_experiment, experiment_json, experiment_text};
use coilsense_lab::request::{DATE, Given, JSON, OUT};

use crate::date;

/// Runs the command.
pub fn run(given: &Given) -> anyhow::Result<()> {
    let begun = Instant::now();
    let experiment = Experiment::read(given.needed(&FOLDER)?, &Cleaning::of(given))?;
    let findings = Findings::of(&experiment);
    let folder = given.needed(&OUT)?;
    let mut output = Output::begin(folder)?;
    let date = date::or_today(given);
    add_experiment(&experiment, &findings, &date, &mut output)?;
    let text = match given.holds(&JSON) {
        true => experiment_json(&experiment, &findings, given.text(&DATE).as_deref())?,
        false => experiment_text(&experiment, &findings),
    };
    let files = output.commit()?;
    let mut out = anstream::stdout().lock();
    // A reader that closes the pipe early has all it wants: the files are written.
    let _ = write!(out, "{text}");
    if !given.holds(&JSON) {
        let seconds = begun.elapsed().as_secs_f64();
        let page = folder.join("report.html");
        let _ = writeln!(out, "\n{files} files in {} in {seconds:.2} s; open {}", folder.display(), page.display());
    }
    Ok(())
}
