//! An identification for machines, in SI units, as their names say.
//!
//! Next door: the same for people (`text`, `html`).

use coilsense::identify::{Estimate, Ladder, Line, Meaning};
use serde_json::{Value, json};

use crate::identification::{Identified, answer, part_name};

/// The whole identification; what was not found is null.
///
/// # Errors
/// [`serde_json::Error`] where it cannot be written.
pub fn identification_json(identified: &Identified, date: Option<&str>) -> Result<String, serde_json::Error> {
    let found = &identified.found;
    let line = found.stiffness.as_ref().ok();
    let value = json!({
        "schema": "coilsense/identification/1",
        "version": env!("CARGO_PKG_VERSION"),
        "date": date,
        "file": identified.file,
        "simulated": identified.simulated,
        "verdict": found.verdict.answer.name(),
        "evidence": found.verdict.evidence,
        "record_next": found.verdict.next,
        "answer": answer(identified),
        "samples": found.sampling.samples,
        "sample_rate_hz": found.sampling.rate,
        "taps_s": found.taps.iter().map(|tap| tap.time).collect::<Vec<_>>(),
        "first_frequency_hz": found.first_frequency.as_ref().map(estimate),
        "damping_ratio": found.ratio.as_ref().map(estimate),
        "stiffness_n_per_m": line.map(|line| estimate(&line.stiffness)),
        "length_at_zero_force_m": line.map(|line| estimate(&line.length_at_zero)),
        "length_is_of_both_ends": line.map(|line| line.both_positions),
        "length_range_m": line.map(|line| [line.range.0, line.range.1]),
        "no_stiffness_because": found.stiffness.as_ref().err(),
        "mass_kg": found.mass.as_ref().map(estimate),
        "transit_time_s": found.transit_time.as_ref().map(estimate),
        "mount": found.ladder.map(|ladder| ladder.name()),
        "mass_ratio": match found.ladder { Some(Ladder::EndMass { mass_ratio }) => Some(mass_ratio), _ => None },
        "end_mass_kg": found.end_mass,
        "windings_fitted": found.fitted_windings,
        "foretold_first_frequency_hz": found.foretold,
        "trust": found.trust.map(|trust| json!({
            "tolerance": trust.tolerance,
            "output_for_input_hz": trust.output_for_input,
            "deflection_for_input_hz": trust.deflection_for_input,
            "deflection_for_output_hz": trust.deflection_for_output,
        })),
        "lines": found.lines.iter().map(one_line).collect::<Vec<_>>(),
        "account": identified.account,
    });
    serde_json::to_string_pretty(&value).map(|text| text + "\n")
}

fn estimate(estimate: &Estimate) -> Value {
    json!({
        "value": estimate.value,
        "standard_uncertainty": estimate.standard,
        "low": estimate.value - estimate.expanded,
        "high": estimate.value + estimate.expanded,
    })
}

fn one_line(line: &Line) -> Value {
    let (kind, mode, true_frequency) = match line.meaning {
        Meaning::Mode(mode) => ("mode", Some(mode), None),
        Meaning::Alias { mode, frequency } => ("alias", Some(mode), Some(frequency)),
        Meaning::Mains { multiple, .. } => ("mains", Some(multiple), None),
        Meaning::Follows => ("follows the ends", None, None),
        Meaning::Unknown => ("unknown", None, None),
    };
    json!({
        "frequency_hz": estimate(&line.frequency),
        "damping_ratio": line.ratio.as_ref().filter(|_| line.decays).map(estimate),
        "damping_ratio_half_power": line.half_power.as_ref().ok().map(estimate),
        "no_half_power_because": line.half_power.as_ref().err(),
        "dies_out": line.decays,
        "amplitude_n": line.amplitude,
        "ends_pull": part_name(line.part),
        "taps": line.taps,
        "kind": kind,
        "number": mode,
        "unfolded_hz": true_frequency,
        "reason": line.reason,
    })
}
