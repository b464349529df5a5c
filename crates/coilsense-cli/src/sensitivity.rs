//! `coilsense sensitivity`.

use coilsense_lab::output::Output;
use coilsense_lab::report::verbs::{DATASET, DRAWS_SEED, OF, RESAMPLES};
use coilsense_lab::report::{add_sensitivity, sensitivity_json, sensitivity_text};
use coilsense_lab::request::{Given, JSON, OUT};
use coilsense_lab::sensitivity::{Resampling, Study};
use coilsense_lab::sweep::Dataset;

use crate::{date, files, terminal};

/// Runs the command.
pub fn run(given: &Given) -> anyhow::Result<()> {
    let dataset = Dataset::open(given.needed(&DATASET)?)?;
    let mut output = files::asked(given)?;
    let usual = Resampling::default();
    let resampling = Resampling {
        resamples: given.count(&RESAMPLES).map_or(usual.resamples, |count| count as usize),
        seed: given.count(&DRAWS_SEED).unwrap_or(usual.seed),
        ..usual
    };
    let study = Study::of(&dataset, &given.texts(&OF), resampling)?;
    let mut text = if given.holds(&JSON) { sensitivity_json(&study)? } else { sensitivity_text(&study) };
    if let Some(output) = &mut output {
        let date = date::or_today(given);
        add_sensitivity(&study, &dataset, &date, output)?;
    }
    let files = output.map(Output::commit).transpose()?;
    if let (Some(files), Some(folder)) = (files, given.file(&OUT)) {
        text.push_str(&terminal::where_to_look(given, files, folder, None));
    }
    Ok(terminal::answer(given, &text)?)
}
