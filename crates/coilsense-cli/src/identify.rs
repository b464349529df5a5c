//! `coilsense identify`.

use std::io::Write;
use std::path::PathBuf;
use std::time::Instant;

use anyhow::Context;
use clap::ValueEnum;
use coilsense::identify::Settings;
use coilsense::modes::ChainModes;
use coilsense::{FarEnd, Spring};
use coilsense_lab::identification::{Coil, Identified, spec_file};
use coilsense_lab::output::Output;
use coilsense_lab::quantity::Dimension;
use coilsense_lab::report::{add_identification, identification_json, identification_text};
use coilsense_lab::spec::SpringSpec;

use crate::date;
use crate::init::write_one;
use crate::log::LogArguments;

/// Options of `coilsense identify`. Quantities come with their unit, as in `--mass "65 g"`.
#[derive(clap::Args)]
pub struct Arguments {
    #[command(flatten)]
    log: LogArguments,
    /// Foretell f1, and take windings, radius and wire, from the [spring] of a spec
    #[arg(long, value_name = "SPEC", conflicts_with_all = ["mass", "windings", "radius", "wire"])]
    spec: Option<PathBuf>,
    /// Mass of the active coil: with the stiffness it foretells f1
    #[arg(long, value_name = "MASS", value_parser = mass, allow_hyphen_values = true)]
    mass: Option<f64>,
    /// Active windings, may be fractional: the steps between modes are then those of a chain of so many
    #[arg(long, value_name = "N")]
    windings: Option<f64>,
    /// Radius of the coil to the wire's centre, for --spec-out
    #[arg(long, value_name = "LENGTH", value_parser = length, allow_hyphen_values = true)]
    radius: Option<f64>,
    /// Diameter of the wire, for --spec-out
    #[arg(long, value_name = "LENGTH", value_parser = length, allow_hyphen_values = true)]
    wire: Option<f64>,
    /// What end 2 is tied to; without it the record decides, by whether u2 moves with the ringing
    #[arg(long, value_name = "WHAT")]
    end2: Option<End2>,
    /// Mass at end 2; without it F_o over the acceleration of u2
    #[arg(long, value_name = "MASS", value_parser = mass, allow_hyphen_values = true)]
    end_mass: Option<f64>,
    /// How far a predicted f1 may be off
    #[arg(long, value_name = "SHARE", value_parser = open_share, allow_hyphen_values = true, default_value = "5 %")]
    prediction_tolerance: f64,
    /// Dynamic error up to which a force counts as trusted
    #[arg(long, value_name = "SHARE", value_parser = open_share, allow_hyphen_values = true, default_value = "1 %")]
    tolerance: f64,
    /// Limit of error of the force sensors, of reading, which the intervals then hold
    #[arg(long, value_name = "SHARE", value_parser = share, allow_hyphen_values = true, default_value = "0 %")]
    accuracy_force: f64,
    /// Limit of error of the position sensors, of reading
    #[arg(long, value_name = "SHARE", value_parser = share, allow_hyphen_values = true, default_value = "0 %")]
    accuracy_position: f64,
    /// Write what was identified as a spec that `coilsense analyze` reads; needs --spec, or --windings, --radius and --wire
    #[arg(long, value_name = "FILE")]
    spec_out: Option<PathBuf>,
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

#[derive(Clone, Copy, ValueEnum)]
enum End2 {
    Held,
    Free,
    Mass,
}

/// Runs the command.
pub fn run(arguments: &Arguments) -> anyhow::Result<()> {
    let begun = Instant::now();
    let spec = arguments.spec.as_deref().map(SpringSpec::read).transpose()?;
    let spring = spec.as_ref().map(|spec| &spec.spring);
    let coil = arguments.spec_out.as_ref().map(|_| coil(arguments, spring)).transpose()?;
    if arguments.end_mass.is_some() && !matches!(arguments.end2, None | Some(End2::Mass)) {
        anyhow::bail!("--end-mass goes with --end2 mass only");
    }
    let settings = settings(arguments, spring);
    let mut output = arguments.out.as_deref().map(Output::begin).transpose()?;
    let identified = Identified::of(arguments.log.recording()?, &settings)?;
    if let Some(output) = &mut output {
        let date = date::or_today(arguments.date.as_ref());
        add_identification(&identified, &date, output)?;
    }
    let text = match arguments.json {
        true => identification_json(&identified, arguments.date.as_deref())?,
        false => identification_text(&identified),
    };
    let spec_text = coil.map(|coil| spec_file(&identified, &coil)).transpose();
    let mut out = anstream::stdout().lock();
    // A reader that closes the pipe early has all it wants.
    let _ = write!(out, "{text}");
    if let (Some(spec_text), Some(path)) = (spec_text?, &arguments.spec_out) {
        write_one(path, |file| file.write_all(spec_text.as_bytes()))?;
        if !arguments.json {
            let _ = writeln!(out, "\n{}; next: coilsense analyze {} --out DIR", path.display(), path.display());
        }
    }
    let files = output.map(Output::commit).transpose()?;
    if let (Some(files), Some(folder), false) = (files, &arguments.out, arguments.json) {
        let seconds = begun.elapsed().as_secs_f64();
        let page = folder.join("report.html");
        let _ = writeln!(out, "\n{files} files in {} in {seconds:.2} s; open {}", folder.display(), page.display());
    }
    Ok(())
}

fn settings(arguments: &Arguments, spring: Option<&Spring>) -> Settings {
    let predicted = spring.and_then(|spring| ChainModes::of(spring).frequencies().first().copied());
    let end_mass = arguments.end_mass.map(FarEnd::Mass);
    Settings {
        windings: spring.map(|spring| spring.whole_windings() as f64).or(arguments.windings),
        mass: arguments.mass,
        predicted: predicted.map(|angular| angular / std::f64::consts::TAU),
        prediction_tolerance: arguments.prediction_tolerance,
        far_end: match arguments.end2 {
            Some(End2::Held) => Some(FarEnd::Position),
            Some(End2::Free) => Some(FarEnd::Force),
            Some(End2::Mass) | None => end_mass,
        },
        tolerance: arguments.tolerance,
        accuracy_force: arguments.accuracy_force,
        accuracy_position: arguments.accuracy_position,
    }
}

/// What no record tells, from a spec or the options.
fn coil(arguments: &Arguments, spring: Option<&Spring>) -> anyhow::Result<Coil> {
    if let Some(spring) = spring {
        let (coil_radius, wire_radius) = (spring.coil_radius(), spring.wire_radius());
        return Ok(Coil { windings: spring.windings(), coil_radius, wire_radius });
    }
    let needed =
        "--spec-out needs --windings, --radius and --wire, or --spec: no log of forces and positions tells them";
    let windings = arguments.windings.context(needed)?;
    let (radius, wire) = (arguments.radius.context(needed)?, arguments.wire.context(needed)?);
    Ok(Coil { windings, coil_radius: radius, wire_radius: 0.5 * wire })
}

/// A quantity above zero.
fn quantity(dimension: Dimension, text: &str) -> Result<f64, String> {
    let value = dimension.parse(text).ok_or_else(|| dimension.refusal(text))?;
    if value > 0.0 && value.is_finite() { Ok(value) } else { Err("must be above zero and finite".to_owned()) }
}

fn mass(text: &str) -> Result<f64, String> {
    quantity(Dimension::Mass, text)
}

fn length(text: &str) -> Result<f64, String> {
    quantity(Dimension::Length, text)
}

fn share(text: &str) -> Result<f64, String> {
    let value = Dimension::Share.parse(text).ok_or_else(|| Dimension::Share.refusal(text))?;
    if (0.0..1.0).contains(&value) { Ok(value) } else { Err("must be from 0 % to below 100 %".to_owned()) }
}

fn open_share(text: &str) -> Result<f64, String> {
    let value = share(text)?;
    if value > 0.0 { Ok(value) } else { Err("must be above 0 %".to_owned()) }
}
