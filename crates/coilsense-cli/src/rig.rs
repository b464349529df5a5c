//! `coilsense rig`.

use std::io::Write;
use std::path::PathBuf;
use std::time::Instant;

use coilsense_lab::analysis::AnalysisError;
use coilsense_lab::output::Output;
use coilsense_lab::report::{RigOutcome, to_json};
use coilsense_lab::rig::{Rig, RigError};
use coilsense_lab::spec::Spec;

use crate::progress::Watch;

/// Options of `coilsense rig`.
#[derive(clap::Args)]
pub struct Arguments {
    /// The spec: its spring, one damping in [mount], and what differs from the paper's rig in [rig]
    #[arg(value_name = "SPEC")]
    spec: PathBuf,
    /// Folder for experiment.toml and two CSV files per run; its other files are left alone
    #[arg(long, value_name = "DIR", default_value = "out/rig")]
    out: PathBuf,
    /// Seed of noise, of each instrument's own errors and of hits; without it, that of [uncertainty]
    #[arg(long, value_name = "N")]
    seed: Option<u64>,
    /// Print JSON
    #[arg(long)]
    json: bool,
}

/// Runs the command.
pub fn run(arguments: &Arguments) -> anyhow::Result<()> {
    let begun = Instant::now();
    let spec = Spec::read(&arguments.spec)?;
    let seed = arguments.seed.unwrap_or(spec.uncertainty.seed);
    let rig = Rig::new(&spec, seed)?;
    // Before anything is on disk, so that nothing is left there.
    let watch = Watch::begin("running the rig")?;
    let mut output = Output::begin(&arguments.out)?;
    let rows = rig.write(&mut output, &|done, of| watch.tell(done, of)).map_err(|error| match error {
        RigError::Interrupted => AnalysisError::Interrupted.into(),
        other => anyhow::Error::from(other),
    })?;
    watch.end();
    if watch.is_stopped() {
        return Err(AnalysisError::Interrupted.into());
    }
    let files = output.commit()?;
    if arguments.json {
        let (runs, warnings) = (rig.runs().len(), rig.warnings().iter().map(ToString::to_string).collect());
        let text = to_json(RigOutcome { folder: &arguments.out, files, runs, rows: rows as u64, seed, warnings })?;
        let _ = write!(anstream::stdout().lock(), "{text}");
        return Ok(());
    }
    for warning in rig.warnings() {
        anstream::eprintln!("warning: {warning}");
    }
    let folder = arguments.out.display();
    // A reader that closes the pipe early has all it wants: the files are written.
    let _ = writeln!(
        anstream::stdout().lock(),
        "wrote {files} files to {folder}: {} runs, {rows} rows, simulated with seed {seed}, in {:.2} s; next: coilsense experiment {folder}",
        rig.runs().len(),
        begun.elapsed().as_secs_f64()
    );
    Ok(())
}
