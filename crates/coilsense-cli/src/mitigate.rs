//! `coilsense mitigate`.

use std::io::Write;
use std::path::PathBuf;
use std::time::Instant;

use anyhow::{Context, anyhow};
use coilsense_lab::mitigation::export::Precision;
use coilsense_lab::mitigation::{Asked, OPTIONS, Study};
use coilsense_lab::output::Output;
use coilsense_lab::recording::{Mapping, Recording, Repairs};
use coilsense_lab::report::{add_mitigation, mitigation_json, mitigation_text};
use coilsense_lab::spec::Spec;

use crate::{date, options};

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
    #[command(flatten)]
    options: Options,
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

/// The options of the verb's table.
struct Options([Option<f64>; OPTIONS.len()]);

impl clap::Args for Options {
    fn augment_args(command: clap::Command) -> clap::Command {
        options::added(command, &OPTIONS)
    }

    fn augment_args_for_update(command: clap::Command) -> clap::Command {
        options::added(command, &OPTIONS)
    }
}

impl clap::FromArgMatches for Options {
    fn from_arg_matches(matches: &clap::ArgMatches) -> Result<Self, clap::Error> {
        Ok(Self(options::values(&OPTIONS, matches)))
    }

    fn update_from_arg_matches(&mut self, matches: &clap::ArgMatches) -> Result<(), clap::Error> {
        *self = Self::from_arg_matches(matches)?;
        Ok(())
    }
}

/// Runs the command.
pub fn run(arguments: &Arguments) -> anyhow::Result<()> {
    let spec = Spec::read(&arguments.spec)?;
    let mut output = arguments.out.as_deref().map(Output::begin).transpose()?;
    let file = spec.file.clone();
    let study = if arguments.stated {
        Study::stated(&spec.spring.spring)?
    } else {
        let asked = Asked::of_values(arguments.options.0).map_err(|wrong| anyhow!("--{wrong}"))?;
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
