//! `coilsense speed`.

use std::path::{Path, PathBuf};

use coilsense_lab::output::Output;
use coilsense_lab::report::{add_speed, speed_json, speed_text};
use coilsense_lab::request::{Given, JSON, OUT, SPEC};
use coilsense_lab::spec::Spec;
use coilsense_lab::speed::request::{CAM_RATIO, FROM, PART, STEP, TO};
use coilsense_lab::speed::{Part, Range, SpeedError, SpeedMap};

use crate::progress::Watch;
use crate::{date, files, terminal};

/// Runs the command.
pub fn run(given: &Given) -> anyhow::Result<()> {
    let spec = Spec::read(given.needed(&SPEC)?)?;
    let number = |row| given.number(row).unwrap_or_default();
    let range = Range { from: number(&FROM), to: number(&TO), step: number(&STEP), ratio: number(&CAM_RATIO) };
    if let Some(text) = given.text(&PART) {
        return part(given, spec, range, Part::parse(&text)?);
    }
    // Before anything is on disk, so that nothing is left there.
    let watch = Watch::begin("running speeds")?;
    let mut output = files::asked(given)?;
    let points = given.file(&OUT).map(points_of);
    if points.is_some() {
        terminal::keeps(KEPT);
    }
    let progress = |done, of| watch.tell(done, of);
    let map = match &points {
        Some(folder) => SpeedMap::kept(spec, range, folder, &progress)?,
        None => SpeedMap::of(spec, range, &progress)?,
    };
    if let Some(output) = &mut output {
        add_speed(&map, &date::or_today(given), output)?;
    }
    watch.end();
    if watch.is_stopped() {
        let kept = points.map(|folder| SpeedError::Paused(folder.display().to_string()));
        return Err(kept.unwrap_or(SpeedError::Interrupted).into());
    }
    let mut text = if given.holds(&JSON) { speed_json(&map)? } else { speed_text(&map) };
    let files = output.map(Output::commit).transpose()?;
    points.iter().try_for_each(|folder| map.forget(folder))?;
    if let (Some(files), Some(folder)) = (files, given.file(&OUT)) {
        text.push_str(&terminal::where_to_look(given, files, folder, None));
    }
    Ok(terminal::answer(given, &text)?)
}

/// What is said where the command is ended before a run is through.
const KEPT: &str = "interrupted; what was computed stays, the same command goes on from there";

/// Where points are kept until a map is whole: beside its folder.
fn points_of(out: &Path) -> PathBuf {
    // Without a slash at its end, which would mean a file in it.
    let mut name = out.components().collect::<PathBuf>().into_os_string();
    name.push(".points");
    name.into()
}

/// One part of the points.
fn part(given: &Given, spec: Spec, range: Range, part: Part) -> anyhow::Result<()> {
    let folder = points_of(given.needed(&OUT)?);
    anyhow::ensure!(!given.holds(&JSON), "json: a share prints no map; the same command without --part does");
    let watch = Watch::begin("running speeds")?;
    terminal::keeps(KEPT);
    let share = SpeedMap::part(spec, range, &folder, part, &|done, of| watch.tell(done, of))?;
    watch.end();
    let Part { number, of } = part;
    let left = match share.of - share.there {
        0 => "all are there: the same command without --part writes the map".to_owned(),
        missing => format!("{missing} of {} are still missing", share.of),
    };
    let text = format!("share {number} of {of}: {} runs are in {}; {left}\n", share.points, folder.display());
    Ok(terminal::say(&text)?)
}
