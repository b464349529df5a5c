//! `coilsense rig`.

use std::time::Instant;

use coilsense_lab::analysis::AnalysisError;
use coilsense_lab::report::verbs::SEED;
use coilsense_lab::report::{RigOutcome, to_json};
use coilsense_lab::request::{Given, JSON, OUT, SPEC};
use coilsense_lab::rig::{Rig, RigError};
use coilsense_lab::spec::Spec;

use crate::progress::Watch;
use crate::{files, terminal};

/// Runs the command.
pub fn run(given: &Given) -> anyhow::Result<()> {
    let begun = Instant::now();
    let (spec, out) = (Spec::read(given.needed(&SPEC)?)?, given.needed(&OUT)?);
    let seed = given.count(&SEED).unwrap_or(spec.uncertainty.seed);
    let rig = Rig::new(&spec, seed)?;
    // Before anything is on disk, so that nothing is left there.
    let watch = Watch::begin("running the rig")?;
    let mut output = files::folder(given, out)?;
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
        return Ok(terminal::answer(given, &text)?);
    }
    for warning in rig.warnings() {
        terminal::warn(warning);
    }
    let folder = out.display();
    let text = format!(
        "wrote {files} files to {folder}: {} runs, {rows} rows, simulated with seed {seed}, in {:.2} s; next: coilsense experiment {folder}\n",
        rig.runs().len(),
        begun.elapsed().as_secs_f64()
    );
    Ok(terminal::say(&text)?)
}
