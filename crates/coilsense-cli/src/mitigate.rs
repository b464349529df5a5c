//! `coilsense mitigate`.

use std::io::Write;
use std::path::PathBuf;
use std::time::Instant;

use anyhow::Context;
use coilsense::mitigation::ToleranceBox;
use coilsense_lab::mitigation::export::Precision;
use coilsense_lab::mitigation::{Asked, Study};
use coilsense_lab::output::Output;
use coilsense_lab::quantity::Dimension;
use coilsense_lab::recording::{Mapping, Recording, Repairs};
use coilsense_lab::report::{add_mitigation, mitigation_json, mitigation_text};
use coilsense_lab::spec::Spec;

use crate::date;

/// Options of `coilsense mitigate`.
#[derive(clap::Args)]
pub struct Arguments {
    /// The spec
    #[arg(value_name = "SPEC")]
    spec: PathBuf,
    /// Judge on the stated scenario in place of the spec's conditions: an impact while end 1 moves, 2.5 kHz, 0.24 N of noise, 50 seeds
    #[arg(long, conflicts_with_all = ["rate", "noise", "bandwidth", "stiffness_tolerance", "mass_tolerance", "most_lag", "seeds"])]
    stated: bool,
    /// Judge on a log in place of the spec's conditions: F_i, u1, u2 and, for estimators, F_o, as `coilsense import` writes them
    #[arg(long, value_name = "LOG", conflicts_with_all = ["stated", "rate", "seeds"])]
    log: Option<PathBuf>,
    /// How often the controller samples
    #[arg(long, value_name = "FREQUENCY", default_value = "2.5 kHz", value_parser = frequency, allow_hyphen_values = true)]
    rate: f64,
    /// White noise of the force at end 1, rms per sample; without it, 0.2 % of the nominal force
    #[arg(long, value_name = "FORCE", value_parser = force, allow_hyphen_values = true)]
    noise: Option<f64>,
    /// Up to which frequency the force moves by itself; without it, the goal's bandwidth, or f1/20
    #[arg(long, value_name = "FREQUENCY", value_parser = frequency, allow_hyphen_values = true)]
    bandwidth: Option<f64>,
    /// By how much the stiffness may be off, either way
    #[arg(long, value_name = "SHARE", default_value = "10 %", value_parser = share, allow_hyphen_values = true)]
    stiffness_tolerance: f64,
    /// By how much the mass may be off, either way
    #[arg(long, value_name = "SHARE", default_value = "10 %", value_parser = share, allow_hyphen_values = true)]
    mass_tolerance: f64,
    /// Most lag at the bandwidth that what is advised may have
    #[arg(long, value_name = "ANGLE", default_value = "30 deg", value_parser = angle, allow_hyphen_values = true)]
    most_lag: f64,
    /// Series of noise, 1 to 1000
    #[arg(long, value_name = "COUNT", default_value_t = 5, value_parser = clap::value_parser!(u64).range(1..=1000))]
    seeds: u64,
    /// Folder for report.html, results.json, the trade-off as a figure, and settings as JSON, C header and Rust constant; its other files are left alone
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Date that the report carries, such as 2026-11-21; without it, today's
    #[arg(long, value_name = "DATE", requires = "out", value_parser = date::parse)]
    date: Option<String>,
    /// Numbers of the exported settings
    #[arg(long, value_enum, default_value = "single")]
    precision: Numbers,
    /// Print JSON
    #[arg(long)]
    json: bool,
}

/// In which numbers the target computes.
#[derive(Clone, Copy, clap::ValueEnum)]
enum Numbers {
    /// f32, float
    Single,
    /// f64, double
    Double,
}

fn quantity(text: &str, dimension: Dimension) -> Result<f64, String> {
    dimension.parse(text).ok_or_else(|| dimension.refusal(text))
}

fn frequency(text: &str) -> Result<f64, String> {
    quantity(text, Dimension::Frequency)
}

fn force(text: &str) -> Result<f64, String> {
    quantity(text, Dimension::Force)
}

fn angle(text: &str) -> Result<f64, String> {
    quantity(text, Dimension::Angle)
}

fn share(text: &str) -> Result<f64, String> {
    quantity(text, Dimension::Share)
}

/// Runs the command.
pub fn run(arguments: &Arguments) -> anyhow::Result<()> {
    let spec = Spec::read(&arguments.spec)?;
    let mut output = arguments.out.as_deref().map(Output::begin).transpose()?;
    let file = spec.file.clone();
    let study = if arguments.stated {
        Study::stated(&spec.spring.spring)?
    } else {
        let asked = Asked {
            rate: arguments.rate,
            noise: arguments.noise,
            bandwidth: arguments.bandwidth,
            tolerances: ToleranceBox::new(arguments.stiffness_tolerance, arguments.mass_tolerance)?,
            most_lag: arguments.most_lag.to_degrees(),
            seeds: arguments.seeds,
        };
        match &arguments.log {
            Some(log) => Study::on(&spec, &asked, &Recording::read(log, &Mapping::default(), &Repairs::default())?)?,
            None => Study::of(&spec, &asked)?,
        }
    };
    let begun = Instant::now();
    let answer = study.run().context(file)?;
    let seconds = begun.elapsed().as_secs_f64();
    let text = if arguments.json { mitigation_json(&answer)? } else { mitigation_text(&answer) };
    if let Some(output) = &mut output {
        let precision = match arguments.precision {
            Numbers::Single => Precision::Single,
            Numbers::Double => Precision::Double,
        };
        let date = date::or_today(arguments.date.as_ref());
        add_mitigation(&answer, &spec, &date, precision, output)?;
    }
    let files = output.map(Output::commit).transpose()?;
    let mut out = anstream::stdout().lock();
    // A reader that closes the pipe early has all it wants.
    let _ = write!(out, "{text}");
    if let (Some(files), Some(folder), false) = (files, &arguments.out, arguments.json) {
        let _ = writeln!(
            out,
            "\n{files} files in {} in {:.2} s; open {}",
            folder.display(),
            seconds,
            folder.join("report.html").display()
        );
    }
    Ok(())
}
