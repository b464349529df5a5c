//! `coilsense mitigate`.

use std::time::Instant;

use anyhow::Context;
use coilsense_lab::calibration::Applied;
use coilsense_lab::mitigation::export::Precision;
use coilsense_lab::mitigation::request::{LOG, PRECISION, STATED};
use coilsense_lab::mitigation::{Request, Study};
use coilsense_lab::output::Output;
use coilsense_lab::report::{add_mitigation, mitigation_json, mitigation_text};
use coilsense_lab::request::{Given, JSON, OUT, SPEC};
use coilsense_lab::spec::Spec;

use crate::{date, files, log, options, terminal};

/// Runs the command.
pub fn run(given: &Given) -> anyhow::Result<()> {
    let spec = Spec::read(given.needed(&SPEC)?)?;
    spec.needs_chain("mitigate")?;
    spec.needs_no_contact("mitigate")?;
    let mut output = files::asked(given)?;
    let file = spec.file.clone();
    let study = if given.holds(&STATED) {
        Study::stated(&spec.spring.spring)?
    } else {
        let asked = Request::of(given).map_err(options::wrong)?;
        match given.holds(&LOG) {
            true => on_log(given, &spec, &asked)?,
            false => Study::of(&spec, &asked)?,
        }
    };
    let begun = Instant::now();
    let answer = study.run().context(file)?;
    let took = begun.elapsed();
    let mut text = if given.holds(&JSON) { mitigation_json(&answer)? } else { mitigation_text(&answer) };
    if let Some(output) = &mut output {
        let precision = match given.text(&PRECISION).as_deref() {
            Some("double") => Precision::Double,
            _ => Precision::Single,
        };
        let date = date::or_today(given);
        add_mitigation(&answer, &spec, &date, precision, output)?;
    }
    let files = output.map(Output::commit).transpose()?;
    if let (Some(files), Some(folder)) = (files, given.file(&OUT)) {
        text.push_str(&terminal::where_to_look(given, files, folder, Some(took)));
    }
    Ok(terminal::answer(given, &text)?)
}

/// On the log, its lengths by its inductance where a calibration is given.
fn on_log(given: &Given, spec: &Spec, asked: &Request) -> anyhow::Result<Study> {
    let stored = log::stored_calibration(given)?;
    let log = log::recording(given)?;
    let Some(stored) = stored else { return Ok(Study::on(spec, asked, &log)?) };
    let applied = Applied::new(&stored, log.signals(), &log.account().file.display().to_string())?;
    Ok(Study::on_lengths(spec, asked, &log, &applied)?)
}
