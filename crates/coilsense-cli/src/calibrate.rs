//! `coilsense calibrate`.

use anyhow::Context;
use coilsense::inductance::theories::Coil;
use coilsense_lab::calibration::request::{LENGTH_AT_ZERO, SPEC};
use coilsense_lab::calibration::{ForceLaw, Measured, Outcome, Plan, read_lab_data};
use coilsense_lab::identification::request::coil;
use coilsense_lab::output::Output;
use coilsense_lab::recording::request::{LOG, is_lab_data};
use coilsense_lab::report::{add_calibration, calibration_json, calibration_text};
use coilsense_lab::request::{DATE, Given, JSON, OUT};
use coilsense_lab::spec::SpringSpec;

use crate::{date, files, log, options, terminal};

/// Runs the command.
pub fn run(given: &Given) -> anyhow::Result<()> {
    let spec = given.file(&SPEC).map(SpringSpec::read).transpose()?;
    let plan = plan(given, spec.as_ref())?;
    let measured = measured(given)?;
    let mut output = files::asked(given)?;
    let outcome = Outcome::new(measured, plan)?;
    if let Some(output) = &mut output {
        let date = date::or_today(given);
        add_calibration(&outcome, &date, output)?;
    }
    let mut text = match given.holds(&JSON) {
        true => calibration_json(&outcome, given.text(&DATE).as_deref())?,
        false => calibration_text(&outcome),
    };
    let files = output.map(Output::commit).transpose()?;
    if let (Some(files), Some(folder)) = (files, given.file(&OUT)) {
        text.push_str(&terminal::where_to_look(given, files, folder, None));
    }
    Ok(terminal::answer(given, &text)?)
}

fn measured(given: &Given) -> anyhow::Result<Measured> {
    let zero_length = given.number(&LENGTH_AT_ZERO);
    if is_lab_data(given) {
        let needed = "--length-at-zero is needed: the file holds displacements, the curve is one of lengths";
        return Ok(read_lab_data(given.needed(&LOG)?, zero_length.context(needed)?)?);
    }
    Ok(Measured::of_log(&log::points(given)?, zero_length)?)
}

/// Coil and force are from options, or of a spec's spring.
fn plan(given: &Given, spec: Option<&SpringSpec>) -> anyhow::Result<Plan> {
    let plan = Plan::of(given, None).map_err(options::wrong)?;
    if let Some(spec) = spec {
        return Ok(plan.of_spring(&spec.spring, Some(ForceLaw::of(spec)))?);
    }
    let coil = coil(given, None).map(|coil| Coil::new(coil.windings, coil.coil_radius, coil.wire_radius));
    Ok(Plan { coil: coil.transpose()?, force: ForceLaw::given(given), ..plan })
}
