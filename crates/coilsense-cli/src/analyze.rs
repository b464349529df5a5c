//! `coilsense analyze`.

use std::time::Instant;

use coilsense_lab::analysis::{Analysis, AnalysisError, Check};
use coilsense_lab::report::{add_analysis, analysis_json, analysis_text, analysis_warnings};
use coilsense_lab::request::{CHECK, Given, JSON, OUT, SPEC};
use coilsense_lab::spec::Spec;

use crate::progress::Watch;
use crate::unmet::Unmet;
use crate::{date, files, terminal};

/// Runs the command.
pub fn run(given: &Given) -> anyhow::Result<()> {
    let begun = Instant::now();
    let (spec, folder) = (Spec::read(given.needed(&SPEC)?)?, given.needed(&OUT)?);
    // Before anything is on disk, so that nothing is left there.
    let watch = Watch::begin("simulating")?;
    let mut output = files::folder(given, folder)?;
    let analysis = Analysis::run(spec, &|done, of| watch.tell(done, of))?;
    let date = date::or_today(given);
    add_analysis(&analysis, &date, &mut output)?;
    watch.end();
    if watch.is_stopped() {
        return Err(AnalysisError::Interrupted.into());
    }
    let text = if given.holds(&JSON) { analysis_json(&analysis, &date)? } else { analysis_text(&analysis) };
    let files = output.commit()?;
    let text = text + &terminal::where_to_look(given, files, folder, Some(begun.elapsed()));
    terminal::answer(given, &text)?;
    if !given.holds(&JSON) {
        analysis_warnings(&analysis).iter().for_each(terminal::warn);
    }
    match Check::of(&analysis) {
        Check::Missed(why) | Check::Undecided(why) if given.holds(&CHECK) => Err(Unmet(why).into()),
        _ => Ok(()),
    }
}
