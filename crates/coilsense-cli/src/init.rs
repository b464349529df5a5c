//! `coilsense init`.

use std::io::Write;
use std::path::Path;

use anyhow::bail;
use coilsense_lab::output::Output;
use coilsense_lab::report::verbs::{FROM, SENSORS};
use coilsense_lab::report::{InitOutcome, to_json};
use coilsense_lab::request::{Given, JSON, OUT};
use coilsense_lab::spec;

/// Runs the command.
pub fn run(given: &Given) -> anyhow::Result<()> {
    let text = if given.holds(&SENSORS) {
        spec::classes()?
    } else {
        spec::template(given.text(&FROM).as_deref()).map_err(|error| anyhow::anyhow!("--from {error}"))?
    };
    let told = |file| match given.holds(&JSON) {
        true => to_json(InitOutcome { file, text: &text }),
        false => Ok(text.clone()),
    };
    let Some(path) = given.file(&OUT) else {
        // A reader that closes the pipe early has all it wants.
        let _ = write!(anstream::stdout().lock(), "{}", told(None)?);
        return Ok(());
    };
    if path.exists() {
        bail!("{}: is there already; name a file that is not, or remove it", path.display());
    }
    write_one(path, |file| file.write_all(text.as_bytes()))?;
    if given.holds(&JSON) {
        let _ = write!(anstream::stdout().lock(), "{}", told(Some(path))?);
        return Ok(());
    }
    let _ =
        writeln!(anstream::stdout().lock(), "{}; next: coilsense analyze {} --out DIR", path.display(), path.display());
    Ok(())
}

/// Writes one file, whole or not at all.
pub fn write_one(
    path: &Path,
    write: impl FnOnce(&mut std::io::BufWriter<std::fs::File>) -> std::io::Result<()>,
) -> anyhow::Result<()> {
    let (mut output, name) = Output::of_file(path)?;
    output.write(&name, write)?;
    output.commit()?;
    Ok(())
}
