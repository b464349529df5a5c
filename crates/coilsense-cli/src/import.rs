//! `coilsense import`.

use std::path::Path;
use std::time::Instant;

use anyhow::{Context, bail};
use coilsense_lab::analysis::AnalysisError;
use coilsense_lab::calibration::Applied;
use coilsense_lab::calibration::request::CALIBRATION;
use coilsense_lab::recording::request::{LOG, WITH};
use coilsense_lab::recording::{
    Account, Cleaning, ImportError, Overview, import, write_recording, write_recording_with,
};
use coilsense_lab::report::verbs::REPORT;
use coilsense_lab::report::{ImportOutcome, add_overview, overview_json, overview_text, to_json};
use coilsense_lab::request::{Given, JSON, OUT};
use coilsense_lab::series::{Column, Format};

use crate::progress::Watch;
use crate::{date, files, log, terminal};

/// Runs the command.
pub fn run(given: &Given) -> anyhow::Result<()> {
    let begun = Instant::now();
    let Some(path) = given.file(&OUT) else { return look(given) };
    let known = Format::ALL.iter().map(|(ending, _)| *ending).collect::<Vec<_>>().join(", ");
    let ending = path.extension().and_then(std::ffi::OsStr::to_str).unwrap_or_default();
    let wrong = || format!("{}: must end in one of {known}", path.display());
    let format = Format::of_ending(ending).with_context(wrong)?;
    let (mapping, cleaning) = (log::mapping(given)?, Cleaning::of(given));
    // Before anything is on disk, so that nothing is left there.
    let watch = Watch::begin("reading")?;
    let (mut output, name) = files::one(given, path)?;
    let name = name.as_str();
    let stored = log::stored_calibration(given)?;
    let tell = |done: u64, of: u64| watch.tell(done as usize, of as usize);
    let mut told = Vec::new();
    let imported = if let Some(stored) = stored {
        let recording = log::recording(given)?;
        let applied = Applied::new(&stored, recording.signals(), &recording.account().file.display().to_string())?;
        let written = write_recording_with(&recording, &columns(&applied), format, name, &mut output);
        told = applied.told;
        written
    } else if given.holds(&WITH) {
        write_recording(&log::recording(given)?, format, name, &mut output)
    } else {
        import(given.needed(&LOG)?, &mapping, &cleaning, &tell, format, name, &mut output)
    };
    watch.end();
    let account = imported.map_err(|error| match error {
        ImportError::Interrupted => AnalysisError::Interrupted.into(),
        other => anyhow::Error::from(other),
    })?;
    output.commit()?;
    if given.holds(&JSON) {
        return Ok(terminal::answer(given, &to_json(outcome(&account, path, told))?)?);
    }
    let wrote = format!("wrote {} in {:.2} s", path.display(), begun.elapsed().as_secs_f64());
    let lines = [account.to_string()].into_iter().chain(told).chain([wrote]);
    Ok(terminal::say(&lines.map(|line| line + "\n").collect::<String>())?)
}

/// Shows what is in the log.
fn look(given: &Given) -> anyhow::Result<()> {
    if let Some(option) = [&WITH, &CALIBRATION].into_iter().find(|option| given.holds(option)) {
        bail!("--{} needs --out FILE: without it a log is only looked at", option.name);
    }
    let watch = Watch::begin("reading")?;
    let tell = |done: u64, of: u64| watch.tell(done as usize, of as usize);
    let overview = Overview::read(given.needed(&LOG)?, &log::mapping(given)?, &tell);
    watch.end();
    if watch.is_stopped() {
        return Err(AnalysisError::Interrupted.into());
    }
    let overview = overview?;
    let mut text = if given.holds(&JSON) { overview_json(&overview)? } else { overview_text(&overview) };
    if let Some(folder) = given.file(&REPORT) {
        let begun = Instant::now();
        let recording = log::recording(given)?;
        let mut output = files::folder(given, folder)?;
        add_overview(&overview, &recording, &date::or_today(given), &mut output)?;
        let files = output.commit()?;
        text += &terminal::where_to_look(given, files, folder, Some(begun.elapsed()));
    }
    Ok(terminal::answer(given, &text)?)
}

/// Length and force with their uncertainties, as columns.
fn columns(applied: &Applied) -> Vec<Column<'_>> {
    let all = [
        ("length", "m", Some(&applied.lengths)),
        ("u_length", "m", applied.lengths_u.as_ref()),
        ("F_L", "N", applied.forces.as_ref()),
        ("u_F_L", "N", applied.forces_u.as_ref()),
    ];
    all.into_iter().filter_map(|(name, unit, values)| Some(Column::new(name, unit, values?))).collect()
}

fn outcome<'a>(account: &'a Account, out: &'a Path, calibration: Vec<String>) -> ImportOutcome<'a> {
    ImportOutcome {
        file: &account.file,
        out,
        format: &account.description,
        read: account.read,
        rows: account.rows,
        left_out: account.left_out(),
        span_s: account.span,
        account: account.lines(),
        calibration,
    }
}
