//! `coilsense identify`.

use std::io::Write;
use std::time::Instant;

use anyhow::Context;
use coilsense_lab::identification::request::{SPEC, SPEC_OUT, coil, settings};
use coilsense_lab::identification::{Identified, spec_file};
use coilsense_lab::output::Output;
use coilsense_lab::report::{add_identification, identification_json, identification_text};
use coilsense_lab::request::{DATE, Given, JSON, OUT};
use coilsense_lab::spec::SpringSpec;

use crate::init::write_one;
use crate::{date, log, options};

/// Runs the command.
pub fn run(given: &Given) -> anyhow::Result<()> {
    let begun = Instant::now();
    let spec = given.file(&SPEC).map(SpringSpec::read).transpose()?;
    let spring = spec.as_ref().map(|spec| &spec.spring);
    let spec_out = given.file(&SPEC_OUT);
    let needed =
        "--spec-out needs --windings, --radius and --wire, or --spec: no log of forces and positions tells them";
    let coil = spec_out.map(|_| coil(given, spring).context(needed)).transpose()?;
    let settings = settings(given, spring).map_err(options::wrong)?;
    let mut output = given.file(&OUT).map(Output::begin).transpose()?;
    let identified = Identified::of(log::recording(given)?, &settings)?;
    if let Some(output) = &mut output {
        let date = date::or_today(given);
        add_identification(&identified, &date, output)?;
    }
    let text = match given.holds(&JSON) {
        true => identification_json(&identified, given.text(&DATE).as_deref())?,
        false => identification_text(&identified),
    };
    let spec_text = coil.map(|coil| spec_file(&identified, &coil)).transpose();
    let mut out = anstream::stdout().lock();
    // A reader that closes the pipe early has all it wants.
    let _ = write!(out, "{text}");
    if let (Some(spec_text), Some(path)) = (spec_text?, spec_out) {
        write_one(path, |file| file.write_all(spec_text.as_bytes()))?;
        if !given.holds(&JSON) {
            let _ = writeln!(out, "\n{}; next: coilsense analyze {} --out DIR", path.display(), path.display());
        }
    }
    let files = output.map(Output::commit).transpose()?;
    if let (Some(files), Some(folder), false) = (files, given.file(&OUT), given.holds(&JSON)) {
        let seconds = begun.elapsed().as_secs_f64();
        let page = folder.join("report.html");
        let _ = writeln!(out, "\n{files} files in {} in {seconds:.2} s; open {}", folder.display(), page.display());
    }
    Ok(())
}
