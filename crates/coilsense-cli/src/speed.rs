//! `coilsense speed`.

use std::io::Write;

use coilsense_lab::output::Output;
use coilsense_lab::report::verbs::{CAM_RATIO, SPEED_FROM, SPEED_STEP, SPEED_TO};
use coilsense_lab::report::{add_speed, speed_json, speed_text};
use coilsense_lab::request::{Given, JSON, OUT, SPEC};
use coilsense_lab::spec::Spec;
use coilsense_lab::speed::{Range, SpeedError, SpeedMap};

use crate::date;
use crate::progress::Watch;

/// Runs the command.
pub fn run(given: &Given) -> anyhow::Result<()> {
    let spec = Spec::read(given.needed(&SPEC)?)?;
    let number = |row| given.number(row).unwrap_or_default();
    let range = Range {
        from: number(&SPEED_FROM),
        to: number(&SPEED_TO),
        step: number(&SPEED_STEP),
        ratio: number(&CAM_RATIO),
    };
    // Before anything is on disk, so that nothing is left there.
    let watch = Watch::begin("running speeds")?;
    let mut output = given.file(&OUT).map(Output::begin).transpose()?;
    let map = SpeedMap::of(spec, range, &|done, of| watch.tell(done, of))?;
    if let Some(output) = &mut output {
        add_speed(&map, &date::or_today(given), output)?;
    }
    watch.end();
    if watch.is_stopped() {
        return Err(SpeedError::Interrupted.into());
    }
    let text = if given.holds(&JSON) { speed_json(&map)? } else { speed_text(&map) };
    let files = output.map(Output::commit).transpose()?;
    let mut out = anstream::stdout().lock();
    // A reader that closes the pipe early has all it wants.
    let _ = write!(out, "{text}");
    if let (Some(files), Some(folder), false) = (files, given.file(&OUT), given.holds(&JSON)) {
        let _ = writeln!(out, "\n{files} files in {}; open {}", folder.display(), folder.join("report.html").display());
    }
    Ok(())
}
