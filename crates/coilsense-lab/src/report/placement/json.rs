//! A placement for machines: SI, one key per number.
//!
//! Next door: the same for people (`text`, `html`).

use serde_json::{Value, json};

use crate::placement::{Judged, MOST_PEAK, Placement, answer};
use crate::spec::DampingCase;

/// The placement as JSON; `null` stands for what is without bound.
///
/// # Errors
/// What the JSON writer says.
pub fn placement_json(placement: &Placement) -> Result<String, serde_json::Error> {
    let candidates = placement.candidates.iter().map(|candidate| {
        let judged = candidate.judged.iter().zip(&placement.dampings).map(|(judged, damping)| value(judged, damping));
        json!({
            "force": candidate.channel.name(),
            "stable_crossover_hz": finite(candidate.stable_crossover()),
            "robust_crossover_hz": finite(candidate.robust_crossover()),
            "calm_crossover_hz": candidate.calm_crossover,
            "stable_as_set": candidate.is_stable(),
            "dampings": judged.collect::<Value>(),
        })
    });
    let object = json!({
        "schema": "coilsense/placement/1",
        "version": env!("CARGO_PKG_VERSION"),
        "answer": answer(placement),
        "feed_back": placement.candidates[placement.best].channel.name(),
        "crossover_hz": placement.crossover,
        "most_peak": MOST_PEAK,
        "proportional_gain": placement.gain,
        "command_unit": placement.control.drive.command_unit(),
        "limit_confirmed_over_time": placement.confirmed,
        "estimates": placement.estimates.iter().map(|estimate| json!({
            "name": estimate.name,
            "stable_crossover_hz": finite(estimate.stable_crossover),
            "robust_crossover_hz": finite(estimate.robust_crossover),
        })).collect::<Value>(),
        "candidates": candidates.collect::<Value>(),
    });
    Ok(format!("{}\n", serde_json::to_string_pretty(&object)?))
}

fn value(judged: &Judged, damping: &DampingCase) -> Value {
    let margins = &judged.margins;
    let [drive, load] = [0, 1].map(|end| judged.peaks.map(|peaks| peaks[end]));
    json!({
        "damping": damping.label,
        "gain_limit": finite(judged.limit),
        "stable_crossover_hz": finite(judged.stable_crossover),
        "robust_crossover_hz": finite(judged.robust_crossover),
        "oscillates_at_hz": judged.oscillates_at,
        "as_set": {
            "stable": margins.stable,
            "gain_margin": finite(margins.gain_limit),
            "phase_margin_rad": finite(margins.phase),
            "delay_margin_s": finite(margins.delay),
            "modulus_margin": margins.modulus,
            "drive_peak": drive.map(|peak| peak.size),
            "drive_peak_hz": drive.map(|peak| peak.at),
            "load_peak": load.map(|peak| peak.size),
            "load_peak_hz": load.map(|peak| peak.at),
            "active_bands_hz": judged.passivity.as_ref().map(|passivity| passivity.active.clone()),
        },
    })
}

fn finite(value: f64) -> Option<f64> {
    value.is_finite().then_some(value)
}
