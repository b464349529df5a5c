//! A plant as it is written: code, or matrices in JSON.
//!
//! Next door: the plant and its code (`crate::plant`), the matrices (`coilsense::plant::StateSpace`), the form of all JSON (`outcome`).

use std::path::Path;

use coilsense_rt::FarEnd;
use serde::Serialize;

use super::ReportError;
use super::outcome::{Outcome, to_json};
use crate::output::Output;
use crate::plant::{Form, Made, Plant, PlantError};

/// The file that was asked for; `name` is what C, Rust and an FMU call it.
///
/// # Errors
/// As [`Plant::header`], and [`PlantError`] for a step that is too long for the fastest mode.
pub fn export_file(made: &Plant, name: &str) -> Result<Made, PlantError> {
    let text = match made.form {
        Form::C { precision, step } => made.header(name, precision, step)?,
        Form::Rust { precision, step } => made.constant(name, precision, step)?,
        Form::StateSpace { step } => matrices(made, step)?,
        Form::Fmu { version, step } => return made.fmu(name, version, step),
    };
    Ok(Made { bytes: text.into_bytes(), left_out: None })
}

/// Writes that file, named as it is, over one that is not our own only where that is asked for; tells what is not in it, though it could be.
///
/// # Errors
/// As [`export_file`], and where nothing can be written.
pub fn write_export(made: &Plant, file: &Path, overwrites: bool) -> Result<Option<String>, ReportError> {
    let (output, name) = Output::of_file(file)?;
    let mut output = output.overwriting(overwrites);
    output.check(&name)?;
    let stem = file.file_stem().and_then(std::ffi::OsStr::to_str).unwrap_or_default();
    let written = export_file(made, stem)?;
    output.add(&name, &written.bytes)?;
    output.commit()?;
    Ok(written.left_out)
}

/// A spring as matrices: `x' = A x + B u`, `y = C x + D u + D_v u'`, about its mean.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "reference", derive(schemars::JsonSchema))]
pub struct StateSpaceFile<'a> {
    /// The spec.
    pub spec_file: &'a str,
    /// Its spring.
    pub spring: &'a str,
    /// What damps it.
    pub damping: &'a str,
    /// What inputs, outputs and states are, in that order, each with its unit.
    pub inputs: Vec<Signal>,
    /// See `inputs`.
    pub outputs: Vec<Signal>,
    /// F_i = F_o = F_x at the mean, to which outputs come; F_L, too, as its meter reads zero there.
    pub mean_force_n: f64,
    /// The length about which inputs count.
    pub mean_length_m: f64,
    /// How many of the spring's modes there are …
    pub kept_modes: usize,
    /// … of how many; where these are more, the last two of `modes` stand for all others.
    pub available_modes: usize,
    /// What is missed of F_i, F_o, F_x and F_L up to a bandwidth; null where none was asked for, or where modes in it are left out.
    pub error: Option<f64>,
    /// Up to there; null where none was asked for.
    pub bandwidth_hz: Option<f64>,
    /// The modes of which the matrices are made.
    pub modes: Vec<Mode>,
    /// Continuous.
    pub continuous: Continuous,
    /// For a step, exact for inputs that move straight between samples; null where no step was asked for.
    pub sampled: Option<Discrete>,
}

/// A signal.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "reference", derive(schemars::JsonSchema))]
pub struct Signal {
    /// As the rest of coilsense calls it.
    name: &'static str,
    /// Its unit.
    unit: &'static str,
}

/// `q'' + 2 ζ ω q' + ω² q = −Σ c_i w_i''`; forces gain `p (q + β q')`.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "reference", derive(schemars::JsonSchema))]
pub struct Mode {
    /// ω.
    frequency_rad_per_s: f64,
    /// ζ.
    damping_ratio: f64,
    /// c of each input.
    participations: [f64; 2],
    /// p of F_i and F_o.
    weights_n_per_m: [f64; 2],
    /// u2 per q.
    end: f64,
}

/// `x' = A x + B u`, `y = C x + D u + D_v u'`.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "reference", derive(schemars::JsonSchema))]
pub struct Continuous {
    /// Rows.
    a: Vec<Vec<f64>>,
    /// Rows.
    b: Vec<[f64; 2]>,
    /// Rows.
    c: Vec<Vec<f64>>,
    /// Rows.
    d: Vec<[f64; 2]>,
    /// Of the inputs' rates: dashpots at the ends; null of all other damping.
    d_rate: Option<Vec<[f64; 2]>>,
}

/// `x⁺ = A x + B u`, `y = C x + D u`.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "reference", derive(schemars::JsonSchema))]
pub struct Discrete {
    /// The step.
    step_s: f64,
    /// Rows.
    a: Vec<Vec<f64>>,
    /// Rows.
    b: Vec<[f64; 2]>,
    /// Rows.
    c: Vec<Vec<f64>>,
    /// Rows.
    d: Vec<[f64; 2]>,
}

impl Outcome for StateSpaceFile<'_> {
    const SCHEMA: &'static str = "coilsense/state-space/1";
}

/// Everything of a plant as matrices.
fn matrices(made: &Plant, step: Option<f64>) -> Result<String, PlantError> {
    let plant = &made.plant;
    made.needs_no_readings("state-space")?;
    if made.windings.is_some() {
        let told = "closest_pitch is no straight line of the inputs: a state space has none; C, Rust and an FMU have";
        return Err(PlantError::Spec(format!("{}: {told}", made.spec_file)));
    }
    let coil = made.coil.as_ref();
    let sampled =
        step.map(|step| plant.sampled(step, coil)).transpose().map_err(PlantError::science(&made.spec_file))?;
    let continuous = plant.state_space(coil);
    let (second, unit) = if plant.far_end() == FarEnd::Position { ("u2", "m") } else { ("force_at_end_2", "N") };
    let modes = plant.modes().iter().zip(plant.ratios()).map(|(mode, damping_ratio)| Mode {
        frequency_rad_per_s: mode.frequency,
        damping_ratio,
        participations: mode.participations,
        weights_n_per_m: mode.weights,
        end: mode.end,
    });
    let has_dashpots = plant.dashpot_time() > 0.0;
    let file = StateSpaceFile {
        spec_file: &made.spec_file,
        spring: &made.spring,
        damping: &made.damping,
        inputs: vec![Signal { name: "u1", unit: "m" }, Signal { name: second, unit }],
        outputs: [("F_i", "N"), ("F_o", "N"), ("F_x", "N"), ("u2", "m")]
            .into_iter()
            .chain(coil.map(|_| ("F_L", "N")))
            .map(|(name, unit)| Signal { name, unit })
            .collect(),
        mean_force_n: plant.mean_force(),
        mean_length_m: plant.mean_length(),
        kept_modes: plant.kept(),
        available_modes: plant.available(),
        error: made.error.map(|(_, error)| error).filter(|error| error.is_finite()),
        bandwidth_hz: made.error.map(|(bandwidth, _)| bandwidth),
        modes: modes.collect(),
        continuous: Continuous {
            a: continuous.a,
            b: continuous.b,
            c: continuous.c,
            d: continuous.d,
            d_rate: has_dashpots.then_some(continuous.d_rate),
        },
        sampled: sampled.map(|of| Discrete { step_s: of.step, a: of.a, b: of.b, c: of.c, d: of.d }),
    };
    to_json(file).map_err(|error| PlantError::Spec(format!("{}: {error}", made.spec_file)))
}
