//! `coilsense calibrate`.

use std::io::Write;
use std::path::PathBuf;

use anyhow::{Context, bail};
use clap::ValueEnum;
use coilsense::calibrate::Inversion;
use coilsense::inductance::theories::Coil;
use coilsense_lab::calibration::{ForceLaw, Measured, Method, Outcome, Plan, Preload, read_lab_data};
use coilsense_lab::output::Output;
use coilsense_lab::quantity::Dimension;
use coilsense_lab::report::{add_calibration, calibration_json, calibration_text};
use coilsense_lab::spec::SpringSpec;

use crate::date;
use crate::log::LogArguments;

/// Options of `coilsense calibrate`. Lengths and the like come with their unit, as in `--wire "2.82 mm"`.
#[derive(clap::Args)]
pub struct Arguments {
    #[command(flatten)]
    log: LogArguments,
    /// Length of the coil, from wire end to wire end along the axis, where the log's positions read zero; without it u2 − u1, or u2, is the
    /// length itself
    #[arg(long, value_name = "LENGTH", value_parser = length, allow_hyphen_values = true)]
    length_at_zero: Option<f64>,
    /// Diameter of the wire, for the theories
    #[arg(long, value_name = "LENGTH", value_parser = length, allow_hyphen_values = true, requires_all = ["radius", "windings"])]
    wire: Option<f64>,
    /// Radius of the coil, from the axis to the centre of the wire
    #[arg(long, value_name = "LENGTH", value_parser = length, allow_hyphen_values = true, requires_all = ["wire", "windings"])]
    radius: Option<f64>,
    /// Windings, may be fractional
    #[arg(long, value_name = "N", requires_all = ["wire", "radius"])]
    windings: Option<f64>,
    /// Take coil, stiffness and length at zero force from the [spring] of a spec
    #[arg(long, value_name = "SPEC", conflicts_with_all = ["wire", "stiffness"])]
    spec: Option<PathBuf>,
    /// How the curve is put through the points; without it through-preload where a preload is given, two-point with --preset lab-data, else all
    #[arg(long, value_name = "METHOD")]
    method: Option<MethodName>,
    /// Length of the coil at the preload, and its inductance where the log has no point there, as in "141.8 mm, 3.35 uH"
    #[arg(long, value_name = "LENGTH[, L]", value_parser = preload)]
    preload: Option<Preload>,
    /// How a length is read from a theory; without it 25-lengths (straight lines) with --preset lab-data, as the runs' authors do, else exact
    #[arg(long, value_name = "WAY")]
    inversion: Option<InversionName>,
    /// Stiffness, to go on to force, as in "760 N/m"
    #[arg(long, value_name = "K", value_parser = stiffness, requires = "length_at_zero_force")]
    stiffness: Option<f64>,
    /// Standard uncertainty of the stiffness, as in "0.2 %"
    #[arg(long, value_name = "SHARE", value_parser = share, allow_hyphen_values = true, requires = "stiffness", default_value = "0 %")]
    stiffness_uncertainty: f64,
    /// Length of the coil at which its force is zero
    #[arg(long, value_name = "LENGTH", value_parser = length, allow_hyphen_values = true, requires = "stiffness")]
    length_at_zero_force: Option<f64>,
    /// Print JSON
    #[arg(long)]
    json: bool,
    /// Folder for report.html, results.json and figures; its other files are left alone
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Date that the report carries, such as 2026-11-21; without it, today's
    #[arg(long, value_name = "DATE", value_parser = date::parse)]
    date: Option<String>,
}

/// The layout of the measured runs, which are also processed as their authors do unless told otherwise.
const LAB_DATA: &str = "lab-data";

#[derive(Clone, Copy, ValueEnum)]
enum MethodName {
    TwoPoint,
    All,
    ThroughPreload,
}

#[derive(Clone, Copy, ValueEnum)]
enum InversionName {
    Exact,
    #[value(name = "25-lengths")]
    TwentyFiveLengths,
}

/// Runs the command.
pub fn run(arguments: &Arguments) -> anyhow::Result<()> {
    let spec = arguments.spec.as_deref().map(SpringSpec::read).transpose()?;
    let plan = plan(arguments, spec.as_ref())?;
    let measured = measured(arguments)?;
    let mut output = arguments.out.as_deref().map(Output::begin).transpose()?;
    let outcome = Outcome::new(measured, plan)?;
    if let Some(output) = &mut output {
        let date = date::or_today(arguments.date.as_ref());
        add_calibration(&outcome, &date, output)?;
    }
    let text = match arguments.json {
        true => calibration_json(&outcome, arguments.date.as_deref())?,
        false => calibration_text(&outcome),
    };
    let files = output.map(Output::commit).transpose()?;
    let mut out = anstream::stdout().lock();
    // A reader that closes the pipe early has all it wants: the files are written.
    let _ = write!(out, "{text}");
    if let (Some(files), Some(folder), false) = (files, &arguments.out, arguments.json) {
        let _ = writeln!(out, "\n{files} files in {}; open {}", folder.display(), folder.join("report.html").display());
    }
    Ok(())
}

fn measured(arguments: &Arguments) -> anyhow::Result<Measured> {
    if arguments.log.preset() == Some(LAB_DATA) {
        let needed = "--length-at-zero is needed: the file holds displacements, the curve is one of lengths";
        return Ok(read_lab_data(&arguments.log.log, arguments.length_at_zero.context(needed)?)?);
    }
    Ok(Measured::of_log(&arguments.log.points()?, arguments.length_at_zero)?)
}

fn plan(arguments: &Arguments, spec: Option<&SpringSpec>) -> anyhow::Result<Plan> {
    let as_authors = arguments.log.preset() == Some(LAB_DATA);
    let method = match arguments.method {
        Some(MethodName::TwoPoint) => Method::TwoPoint,
        Some(MethodName::All) => Method::All,
        Some(MethodName::ThroughPreload) => Method::ThroughPreload,
        None if arguments.preload.is_some() => Method::ThroughPreload,
        None if as_authors => Method::TwoPoint,
        None => Method::All,
    };
    if arguments.preload.is_some() && method != Method::ThroughPreload {
        bail!("--preload goes with --method through-preload only");
    }
    let inversion = match arguments.inversion {
        Some(InversionName::Exact) => Inversion::Exact,
        Some(InversionName::TwentyFiveLengths) => twenty_five(arguments)?,
        None if as_authors => twenty_five(arguments)?,
        None => Inversion::Exact,
    };
    let coil = match (spec, arguments.wire, arguments.radius, arguments.windings) {
        (Some(spec), ..) => Some(Coil::of(&spec.spring)?),
        (None, Some(wire), Some(radius), Some(windings)) => Some(Coil::new(windings, radius, 0.5 * wire)?),
        _ => None,
    };
    Ok(Plan { method, preload: arguments.preload, inversion, coil, force: force(arguments, spec) })
}

fn twenty_five(arguments: &Arguments) -> anyhow::Result<Inversion> {
    let zero_length =
        arguments.length_at_zero.context("--length-at-zero is needed, from which the 25 lengths start")?;
    Ok(Inversion::TwentyFiveLengths { zero_length })
}

/// From options, or a spec's spring.
fn force(arguments: &Arguments, spec: Option<&SpringSpec>) -> Option<ForceLaw> {
    if let Some(spec) = spec {
        return Some(ForceLaw::of(spec));
    }
    let (stiffness, rest_length) = (arguments.stiffness?, arguments.length_at_zero_force?);
    let stiffness_u = stiffness * arguments.stiffness_uncertainty;
    Some(ForceLaw { stiffness, stiffness_u, rest_length, rest_length_u: 0.0 })
}

/// A quantity above zero.
fn quantity(dimension: Dimension, text: &str) -> Result<f64, String> {
    let value = dimension.parse(text).ok_or_else(|| dimension.refusal(text))?;
    if value > 0.0 && value.is_finite() { Ok(value) } else { Err("must be above zero and finite".to_owned()) }
}

fn length(text: &str) -> Result<f64, String> {
    quantity(Dimension::Length, text)
}

fn stiffness(text: &str) -> Result<f64, String> {
    quantity(Dimension::Stiffness, text)
}

fn share(text: &str) -> Result<f64, String> {
    let value = Dimension::Share.parse(text).ok_or_else(|| Dimension::Share.refusal(text))?;
    if (0.0..1.0).contains(&value) { Ok(value) } else { Err("must be from 0 % to below 100 %".to_owned()) }
}

fn preload(text: &str) -> Result<Preload, String> {
    match text.split_once(',') {
        None => Ok(Preload { length: length(text)?, inductance: None }),
        Some((at, inductance)) => {
            Ok(Preload { length: length(at)?, inductance: Some(quantity(Dimension::Inductance, inductance)?) })
        }
    }
}
