//! `coilsense export`.

use coilsense_lab::plant::request::{AS, FILE};
use coilsense_lab::plant::{Plant, Request};
use coilsense_lab::report::{ExportOutcome, to_json, write_export};
use coilsense_lab::request::{Given, JSON, OVERWRITE, SPEC};
use coilsense_lab::spec::Spec;

use crate::{options, terminal};

/// Runs the command.
pub fn run(given: &Given) -> anyhow::Result<()> {
    let request = Request::of(given).map_err(options::wrong)?;
    let file = given.needed(&FILE)?;
    let made = Plant::of(Spec::read(given.needed(&SPEC)?)?, &request)?;
    let left_out = write_export(&made, file, given.holds(&OVERWRITE))?;
    for warning in &made.warnings {
        terminal::warn(format_args!("{}: {warning}", made.spec_file));
    }
    if let Some(left_out) = &left_out {
        terminal::warn(format_args!("{}: {left_out}", file.display()));
    }
    let plant = &made.plant;
    let told = match given.holds(&JSON) {
        true => to_json(ExportOutcome {
            spec_file: &made.spec_file,
            file,
            r#as: &given.text(&AS).unwrap_or_default(),
            damping: &made.damping,
            mean_length_m: plant.mean_length(),
            mean_force_n: plant.mean_force(),
            modes: plant.count(),
            kept_modes: plant.kept(),
            available_modes: plant.available(),
            bandwidth_hz: made.error.map(|(bandwidth, _)| bandwidth),
            error: made.error.map(|(_, error)| error).filter(|error| error.is_finite()),
            left_out: left_out.as_deref(),
            warnings: &made.warnings,
        })?,
        false => format!("{}{}\n", made.summary(), file.display()),
    };
    Ok(terminal::answer(given, &told)?)
}
