//! `coilsense experiment`.

use std::io::Write;
use std::path::PathBuf;
use std::time::Instant;

use coilsense_lab::experiment::{Experiment, Findings};
use coilsense_lab::output::Output;
use coilsense_lab::report::{add_experiment, experiment_json, experiment_text};

use crate::date;
use crate::repairs::RepairArguments;

/// Options of `coilsense experiment`.
#[derive(clap::Args)]
pub struct Arguments {
    /// Folder with experiment.toml, which lists the logs: see book/src/guide/experiment.md
    #[arg(value_name = "DIR")]
    folder: PathBuf,
    #[command(flatten)]
    repairs: RepairArguments,
    /// Print JSON
    #[arg(long)]
    json: bool,
    /// Folder for report.html, results.json and figures; its other files are left alone
    #[arg(long, value_name = "DIR", default_value = "out/experiment")]
    out: PathBuf,
    /// Date that the report carries, such as 2026-11-21; without it, today's
    #[arg(long, value_name = "DATE", value_parser = date::parse)]
    date: Option<String>,
}

/// Runs the command.
pub fn run(arguments: &Arguments) -> anyhow::Result<()> {
    let begun = Instant::now();
    let experiment = Experiment::read(&arguments.folder, &arguments.repairs.repairs())?;
    let findings = Findings::of(&experiment);
    let mut output = Output::begin(&arguments.out)?;
    let date = date::or_today(arguments.date.as_ref());
    add_experiment(&experiment, &findings, &date, &mut output)?;
    let text = match arguments.json {
        true => experiment_json(&experiment, &findings, arguments.date.as_deref())?,
        false => experiment_text(&experiment, &findings),
    };
    let files = output.commit()?;
    let mut out = anstream::stdout().lock();
    // A reader that closes the pipe early has all it wants: the files are written.
    let _ = write!(out, "{text}");
    if !arguments.json {
        let (folder, seconds) = (&arguments.out, begun.elapsed().as_secs_f64());
        let page = folder.join("report.html");
        let _ = writeln!(out, "\n{files} files in {} in {seconds:.2} s; open {}", folder.display(), page.display());
    }
    Ok(())
}
