//! `coilsense rig`.

use std::io::Write;
use std::time::Instant;

use coilsense_lab::analysis::AnalysisError;
use coilsense_lab::output::Output;
use coilsense_lab::report::verbs::SEED;
use coilsense_lab::report::{RigOutcome, to_json};
use coilsense_lab::request::{Given, JSON, OUT, SPEC};
use coilsense_lab::rig::{Rig, RigError};
use coilsense_lab::spec::Spec;

use crate::progress::Watch;

/// Runs the command.
pub fn run(given: &Given) -> anyhow::Result<()> {
    let begun = Instant::now();
    let (spec, out) = (Spec::read(given.needed(&SPEC)?)?, given.needed(&OUT)?);
    let seed = given.count(&SEED).unwrap_or(spec.uncertainty.seed);
    let rig = Rig::new(&spec, seed)?;
    // Before anything is on disk, so that nothing is left there.
    let watch = Watch::begin("running the rig")?;
    let mut output = Output::begin(out)?;
    let rows = rig.write(&mut output, &|done, of| watch.tell(done, of)).map_err(|error| match error {
        RigError::Interrupted => AnalysisError::Interrupted.into(),
        other => anyhow::Error::from(other),
    })?;
    watch.end();
    if watch.is_stopped() {
        return Err(AnalysisError::Interrupted.into());
    }
    let files = output.commit()?;
    if given.holds(&JSON) {
        let (runs, warnings) = (rig.runs().len(), rig.warnings().iter().map(ToString::to_string).collect());
        let text = to_json(RigOutcome { folder: out, files, runs, rows: rows as u64, seed, warnings })?;
        let _ = write!(anstream::stdout().lock(), "{text}");
        return Ok(());
    }
    for warning in rig.warnings() {
        anstream::eprintln!("warning: {warning}");
    }
    let folder = out.display();
    // A reader that closes the pipe early has all it wants: the files are written.
    let _ = writeln!(
        anstream::stdout().lock(),
        "wrote {files} files to {folder}: {} runs, {rows} rows, simulated with seed {seed}, in {:.2} s; next: coilsense experiment {folder}",
        rig.runs().len(),
        begun.elapsed().as_secs_f64()
    );
    Ok(())
}
