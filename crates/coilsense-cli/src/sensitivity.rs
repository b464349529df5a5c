//! `coilsense sensitivity`.

use std::io::Write;
use std::path::PathBuf;

use coilsense_lab::output::Output;
use coilsense_lab::report::{add_sensitivity, sensitivity_json, sensitivity_text};
use coilsense_lab::sensitivity::{Resampling, Study};
use coilsense_lab::sweep::Dataset;

use crate::date;

/// Options of `coilsense sensitivity`.
#[derive(clap::Args)]
pub struct Arguments {
    /// Folder of a sweep that was made with --sampling saltelli
    #[arg(value_name = "DIR")]
    sweep: PathBuf,
    /// Column to ask for, such as F_o.rmsd; may be given several times; without it all that hold numbers
    #[arg(long, value_name = "COLUMN")]
    of: Vec<String>,
    /// How often base rows are drawn anew for the intervals
    #[arg(long, value_name = "COUNT", default_value_t = Resampling::default().resamples)]
    resamples: usize,
    /// Folder for report.html and results.json; its other files are left alone
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Print JSON
    #[arg(long)]
    json: bool,
    /// Date that the report carries, such as 2026-11-21; without it, today's
    #[arg(long, value_name = "DATE", requires = "out", value_parser = date::parse)]
    date: Option<String>,
}

/// Runs the command.
pub fn run(arguments: &Arguments) -> anyhow::Result<()> {
    let dataset = Dataset::open(&arguments.sweep)?;
    let mut output = arguments.out.as_deref().map(Output::begin).transpose()?;
    let resampling = Resampling { resamples: arguments.resamples, ..Resampling::default() };
    let study = Study::of(&dataset, &arguments.of, resampling)?;
    let text = if arguments.json { sensitivity_json(&study)? } else { sensitivity_text(&study) };
    if let Some(output) = &mut output {
        let date = date::or_today(arguments.date.as_ref());
        add_sensitivity(&study, &dataset, &date, output)?;
    }
    let files = output.map(Output::commit).transpose()?;
    let mut out = anstream::stdout().lock();
    // A reader that closes the pipe early has all it wants.
    let _ = write!(out, "{text}");
    if let (Some(files), Some(folder), false) = (files, &arguments.out, arguments.json) {
        let _ = writeln!(out, "\n{files} files in {}; open {}", folder.display(), folder.join("report.html").display());
    }
    Ok(())
}
