//! A log on the command line: which file, which column is what. Shared by all commands that read one.
//!
//! Next door: its options (`coilsense_lab::recording::request`), what is done with it (`import`).

use coilsense_lab::calibration::StoredCalibration;
use coilsense_lab::calibration::request::{CALIBRATION, RE_ZERO, parse_pair};
use coilsense_lab::recording::request::{LOG, MAPPING, PRESET, WITH, WITH_COLUMN, WITH_MAPPING};
use coilsense_lab::recording::{Cleaning, Clock, Mapping, Points, Recording, RecordingError};
use coilsense_lab::request::Given;

/// The log over time, a second device's beside it where there is one.
pub fn recording(given: &Given) -> anyhow::Result<Recording> {
    let cleaning = Cleaning::of(given);
    let recording = Recording::read(given.needed(&LOG)?, &mapping(given)?, &cleaning)?;
    let Some(with) = given.file(&WITH) else { return Ok(recording) };
    let mut mapping = given.file(&WITH_MAPPING).map_or(Ok(Mapping::default()), Mapping::read)?;
    given.texts(&WITH_COLUMN).iter().try_for_each(|column| mapping.set(column))?;
    // The window is one of the first device's clock.
    let cleaning = Cleaning { from: None, to: None, ..cleaning };
    Ok(recording.joined(&Recording::read(with, &mapping, &cleaning)?, Clock::of(given))?)
}

/// The log row by row, without a clock.
pub fn points(given: &Given) -> anyhow::Result<Points> {
    Ok(Points::read(given.needed(&LOG)?, &mapping(given)?, &Cleaning::of(given))?)
}

/// Which column is which channel.
pub fn mapping(given: &Given) -> Result<Mapping, RecordingError> {
    let mapping = match (given.text(&PRESET), given.file(&MAPPING)) {
        (Some(name), _) => Mapping::preset(&name)?,
        (None, Some(file)) => Mapping::read(file)?,
        (None, None) => Mapping::default(),
    };
    mapping.told(given)
}

/// The calibration that is applied to it, re-zeroed where that is asked for.
pub fn stored_calibration(given: &Given) -> anyhow::Result<Option<StoredCalibration>> {
    let Some(stored) = given.file(&CALIBRATION).map(StoredCalibration::read).transpose()? else { return Ok(None) };
    let Some(text) = given.text(&RE_ZERO) else { return Ok(Some(stored)) };
    let (length, inductance) = parse_pair(&text).map_err(|reason| anyhow::anyhow!("--re-zero: {reason}"))?;
    Ok(Some(stored.re_zeroed(length, inductance)?))
}
