//! `coilsense identify`.

use std::time::Instant;

use anyhow::Context;
use coilsense::identify::Answer;
use coilsense_lab::identification::request::{SPEC, SPEC_OUT, coil, settings};
use coilsense_lab::identification::{Expected, Identified, spec_file};
use coilsense_lab::output::Output;
use coilsense_lab::report::{add_identification, identification_json, identification_text};
use coilsense_lab::request::{CHECK, DATE, Given, JSON, OUT};
use coilsense_lab::spec::SpringSpec;

use crate::unmet::Unmet;
use crate::{date, files, log, options, terminal};

/// Runs the command.
pub fn run(given: &Given) -> anyhow::Result<()> {
    let begun = Instant::now();
    let spec = given.file(&SPEC).map(SpringSpec::read).transpose()?;
    let spring = spec.as_ref().map(|spec| &spec.spring);
    let spec_out = given.file(&SPEC_OUT);
    let needed =
        "--spec-out needs --windings, --radius and --wire, or --spec: no log of forces and positions tells them";
    let coil = spec_out.map(|_| coil(given, spring).context(needed)).transpose()?;
    let settings = settings(given, spec.as_ref().map(Expected::of_spec)).map_err(options::wrong)?;
    let mut output = files::asked(given)?;
    // Refused before the work where it must not be written.
    let spec_output = spec_out.map(|path| files::one(given, path)).transpose()?;
    let identified = Identified::of(log::recording(given)?, &settings)?;
    if let Some(output) = &mut output {
        let date = date::or_today(given);
        add_identification(&identified, &date, output)?;
    }
    let mut text = match given.holds(&JSON) {
        true => identification_json(&identified, given.text(&DATE).as_deref())?,
        false => identification_text(&identified),
    };
    let spec_text = match coil.map(|coil| spec_file(&identified, &coil)).transpose() {
        Ok(spec_text) => spec_text,
        // What was found is told all the same.
        Err(error) => return Err(terminal::answer(given, &text).map_or_else(Into::into, |()| error.into())),
    };
    if let (Some(spec_text), Some(path), Some((mut output, name))) = (spec_text, spec_out, spec_output) {
        output.add(&name, spec_text.as_bytes())?;
        output.commit()?;
        if !given.holds(&JSON) {
            text.push_str(&format!("\n{0}; next: coilsense analyze {0} --out DIR\n", path.display()));
        }
    }
    let files = output.map(Output::commit).transpose()?;
    if let (Some(files), Some(folder)) = (files, given.file(&OUT)) {
        text.push_str(&terminal::where_to_look(given, files, folder, Some(begun.elapsed())));
    }
    terminal::answer(given, &text)?;
    match identified.found.verdict.answer {
        Answer::Spring => Ok(()),
        other if given.holds(&CHECK) => Err(Unmet(other.name().to_owned()).into()),
        _ => Ok(()),
    }
}
