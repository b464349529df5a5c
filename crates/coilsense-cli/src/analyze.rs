//! `coilsense analyze`.

use std::io::Write;
use std::path::PathBuf;
use std::time::Instant;

use coilsense_lab::analysis::{Analysis, AnalysisError};
use coilsense_lab::output::Output;
use coilsense_lab::report::{add_analysis, analysis_json, analysis_text};
use coilsense_lab::spec::Spec;

use crate::date;
use crate::progress::Watch;

/// Options of `coilsense analyze`.
#[derive(clap::Args)]
pub struct Arguments {
    /// The spec
    #[arg(value_name = "SPEC")]
    spec: PathBuf,
    /// Folder for report.html, results.json and signals.parquet; its other files are left alone
    #[arg(long, value_name = "DIR", default_value = "out/analysis")]
    out: PathBuf,
    /// Print JSON, as it stands in results.json
    #[arg(long)]
    json: bool,
    /// Date that the report carries, such as 2026-11-21; without it, today's
    #[arg(long, value_name = "DATE", value_parser = date::parse)]
    date: Option<String>,
}

/// Runs the command.
pub fn run(arguments: &Arguments) -> anyhow::Result<()> {
    let begun = Instant::now();
    let spec = Spec::read(&arguments.spec)?;
    // Before anything is on disk, so that nothing is left there.
    let watch = Watch::begin("simulating")?;
    let mut output = Output::begin(&arguments.out)?;
    let analysis = Analysis::run(spec, &|done, of| watch.tell(done, of))?;
    let date = date::or_today(arguments.date.as_ref());
    add_analysis(&analysis, &date, &mut output)?;
    watch.end();
    if watch.is_stopped() {
        return Err(AnalysisError::Interrupted.into());
    }
    let text = if arguments.json { analysis_json(&analysis, &date)? } else { analysis_text(&analysis) };
    let files = output.commit()?;
    let mut out = anstream::stdout().lock();
    // A reader that closes the pipe early has all it wants: the files are written.
    let _ = write!(out, "{text}");
    if arguments.json {
        return Ok(());
    }
    let _ = writeln!(
        out,
        "\n{files} files in {} in {:.2} s; open {}",
        arguments.out.display(),
        begun.elapsed().as_secs_f64(),
        arguments.out.join("report.html").display()
    );
    Ok(())
}
