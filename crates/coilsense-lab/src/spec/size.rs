//! How much a `[[condition]]` may ask for: its samples, all conditions' samples, and the window that is judged.
//!
//! Next door: what is done to the spring (`condition`).

use super::SpecError;
use super::section::Section;
use super::setting::Setting;
use crate::quantity::Dimension;

/// Fewest samples of a condition and of its window: what a spectrum needs.
const FEWEST_SAMPLES: f64 = 8.0;
/// Most samples, winding positions and pairs of turns of one condition, and samples of all under every damping: what fits into memory and
/// into a minute.
const MOST_SAMPLES: f64 = 5e6;
const MOST_POSITIONS: f64 = 2e8;
const MOST_PAIRS: f64 = 1e10;
const MOST_IN_ALL: f64 = 2e7;

/// The part that is judged \[s\].
pub(super) fn window(section: &Section<'_>, duration: f64, sample_rate: f64) -> Result<(f64, f64), SpecError> {
    let Some([(_, from), (_, to)]) = section.optional_pair("window", &[Dimension::Time])? else {
        return Ok((0.0, duration));
    };
    let holds = from >= 0.0 && to > from && to <= duration;
    section.check(
        "window",
        holds,
        from,
        &format!("from 0 s up, not empty, and end within the duration of {duration} s"),
    )?;
    let samples = (to - from) * sample_rate;
    section.check("window", samples >= FEWEST_SAMPLES, samples, &format!("at least {FEWEST_SAMPLES} samples long"))?;
    Ok((from, to))
}

/// A condition has no more samples, winding positions and pairs of turns than can be processed.
pub(super) fn check(section: &Section<'_>, setting: &Setting<'_>, samples: f64) -> Result<(), SpecError> {
    let masses = setting.spring.chain_masses() as f64;
    let turns = setting.spring.inductance_windings().round();
    let pairs = (0.5 * turns * (turns - 1.0)).max(1.0);
    let most = MOST_SAMPLES.min(MOST_POSITIONS / masses).min(MOST_PAIRS / pairs).floor();
    if (FEWEST_SAMPLES..=most).contains(&samples) {
        return Ok(());
    }
    let of = format!("{} windings", setting.spring.inductance_windings().max(setting.spring.windings()));
    let text = match most < FEWEST_SAMPLES {
        true => {
            format!(
                "{of} are too many to simulate over time; up to {} are taken",
                (2.0 * MOST_PAIRS / FEWEST_SAMPLES).sqrt()
            )
        }
        false => format!(
            "duration × sample_rate is {samples:.0} samples; from {FEWEST_SAMPLES} to {most} are taken with {of}"
        ),
    };
    Err(section.refuse(size_key(section), text))
}

/// All conditions so far, with so many samples under each damping, have no more than can be kept.
pub(super) fn check_total(section: &Section<'_>, setting: &Setting<'_>, samples: f64) -> Result<(), SpecError> {
    let dampings = setting.mount.cases.len();
    let total = dampings as f64 * samples;
    if total <= MOST_IN_ALL {
        return Ok(());
    }
    let under = if dampings == 1 { String::new() } else { format!(" under {dampings} dampings") };
    let text =
        format!("up to this condition there are {total:.0} samples{under}; at most {MOST_IN_ALL} are taken in all");
    Err(section.refuse(size_key(section), text))
}

/// The key that says how many samples there are.
fn size_key(section: &Section<'_>) -> &'static str {
    section.first_of(&["sample_rate", "duration", "file"]).unwrap_or("duration")
}
