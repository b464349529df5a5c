//! `coilsense init`.

use std::io::Write;

use anyhow::bail;
use coilsense_lab::report::verbs::{FROM, SENSORS};
use coilsense_lab::report::{InitOutcome, to_json};
use coilsense_lab::request::{Given, JSON, OUT, OVERWRITE};
use coilsense_lab::spec;

use crate::{files, terminal};

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
        // The spec is the product, also for who wants to hear nothing: `coilsense init -q > my.toml`.
        return Ok(terminal::product(given, &told(None)?)?);
    };
    if path.exists() && !given.holds(&OVERWRITE) {
        bail!("{}: is there already; name a file that is not, or replace it with --overwrite", path.display());
    }
    files::write_one(given, path, |file| file.write_all(text.as_bytes()))?;
    let said = match given.holds(&JSON) {
        true => told(Some(path))?,
        false => format!("{0}; next: coilsense analyze {0} --out DIR\n", path.display()),
    };
    Ok(terminal::answer(given, &said)?)
}
