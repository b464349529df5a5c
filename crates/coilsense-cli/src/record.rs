//! `coilsense record`.

use std::path::Path;

use anyhow::bail;
use coilsense_lab::output::Output;
use coilsense_lab::record::{FILE, Record, TEMPLATE};
use coilsense_lab::report::verbs::{BEGIN, RECORD_FOLDER};
use coilsense_lab::report::{record_json, record_text};
use coilsense_lab::request::{CHECK, Given, JSON, OUT};

use crate::unmet::Unmet;
use crate::{files, terminal};

/// Runs the command.
pub fn run(given: &Given) -> anyhow::Result<()> {
    let folder = given.needed(&RECORD_FOLDER)?;
    if given.holds(&BEGIN) {
        return begin(folder);
    }
    // Refused before the work where it must not be written.
    let asked = given.file(&OUT);
    if let Some(path) = asked.filter(|path| path.extension().is_none_or(|ending| ending != "zip")) {
        bail!("{}: must end in .zip", path.display());
    }
    let output = asked.map(|path| files::one(given, path)).transpose()?;
    let record = Record::read(folder)?;
    let is_whole = record.is_whole();
    let written = asked.filter(|_| is_whole);
    let json = record_json(&record, folder, written)?;
    let mut text = if given.holds(&JSON) { json.clone() } else { record_text(&record) };
    if let (true, Some((mut output, name)), Some(path)) = (is_whole, output, asked) {
        pack(&record, &json, &mut output, &name)?;
        output.commit()?;
        if !given.holds(&JSON) {
            text += &format!(
                "\nwrote {}; send it with an issue of the form \"A measured record of a real spring\"\n",
                path.display()
            );
        }
    }
    terminal::answer(given, &text)?;
    match asked {
        Some(path) if !is_whole => bail!("{} was not written: the record is not whole", path.display()),
        _ if given.holds(&CHECK) && !record.is_clean() => Err(Unmet("the record is not whole".to_owned()).into()),
        _ => Ok(()),
    }
}

/// Writes a `record.toml` to fill in, beside whatever is there.
fn begin(folder: &Path) -> anyhow::Result<()> {
    let path = folder.join(FILE);
    // What somebody has filled in is theirs, also where this command wrote it.
    if path.exists() {
        bail!("{} is there already; coilsense record {} says what is missing in it", path.display(), folder.display());
    }
    let mut output = Output::begin(folder)?;
    output.add(FILE, TEMPLATE.as_bytes())?;
    output.commit()?;
    Ok(terminal::say(&format!("wrote {}; fill it in, then: coilsense record {}\n", path.display(), folder.display()))?)
}

#[cfg(feature = "files")]
fn pack(record: &Record, json: &str, output: &mut Output, name: &str) -> anyhow::Result<()> {
    Ok(output.write(name, |file| record.pack(json, file))?)
}

#[cfg(not(feature = "files"))]
fn pack(_: &Record, _: &str, _: &mut Output, _: &str) -> anyhow::Result<()> {
    bail!("a record is packed as a ZIP archive, and {}", crate::left_out::WHOLE_BUILD)
}
