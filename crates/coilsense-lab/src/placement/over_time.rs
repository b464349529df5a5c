//! The sampled loop over time: a step to show, and the run that confirms its limit.
//!
//! Next door: the limit (`judged`).

use coilsense::Error;
use coilsense::control::{Run, simulate};

use super::Candidate;
use super::loops::UnitLoops;
use crate::spec::DampingCase;

/// Samples of the run that is shown, and of those that confirm a limit.
const SHOWN: f64 = 1.0;
const CONFIRMED_PERIODS: f64 = 1500.0;

/// The best force's loop over time at the least damping, and whether its limit holds; neither where the engine cannot run it.
pub(super) fn runs(
    unit: &UnitLoops<'_>,
    dampings: &[DampingCase],
    best: &Candidate,
    gain: f64,
) -> Result<(Option<Run>, Option<bool>), Error> {
    let Some(step) = unit.control.sample_time else { return Ok((None, None)) };
    let limits = best.judged.iter().map(|judged| judged.limit).enumerate();
    let weakest = limits.min_by(|a, b| a.1.total_cmp(&b.1)).map_or(0, |(index, _)| index);
    let Some(sampled) = unit.sampled(&unit.force_loop(&dampings[weakest], best.channel, gain)?)? else {
        return Ok((None, None));
    };
    let reference = 0.01 * unit.spec.spring.spring.nominal_force();
    let samples = (SHOWN / step).min(1e5) as usize;
    let Ok(run) = simulate(&sampled, 1.0, reference, samples) else { return Ok((None, None)) };
    let limit = best.judged[weakest].margins.gain_limit;
    if !limit.is_finite() || limit == 0.0 {
        return Ok((Some(run), None));
    }
    let long = (CONFIRMED_PERIODS / unit.surge() / step).min(2e5) as usize;
    let grows = |factor: f64| Ok::<bool, Error>(grows(&simulate(&sampled, factor * limit, reference, long)?, long));
    let confirmed = !grows(0.98)? && grows(1.02)?;
    Ok((Some(run), Some(confirmed)))
}

/// Whether what rings at the end of a run rings more than half way through it.
fn grows(run: &Run, samples: usize) -> bool {
    let swing = |part: &[f64]| {
        let mean = part.iter().sum::<f64>() / part.len().max(1) as f64;
        part.iter().map(|value| (value - mean).abs()).fold(0.0, f64::max)
    };
    let eighth = samples / 8;
    run.output.len() < samples
        || swing(&run.output[samples - eighth..]) > swing(&run.output[samples / 2..samples / 2 + eighth])
}
