//! What a log says, as `coilsense identify` does, the curves that show it, and the spec of what was identified.
//!
//! Next door: what was asked (`asked`), the channels themselves (`recorded`).

use coilsense::identify::{Identification, Part, Settings, Welch};
use coilsense_lab::identification::{Coil, Identified, spec_file};
use coilsense_lab::recording::{Cleaning, Recording};
use coilsense_lab::report::identification_json;
use serde_json::{Value, json};

use super::{LogFile, MOST, Request, recorded, thinned};
use crate::answer::Answer;

/// What the log says, as `coilsense identify --json` prints it, and the curves that show it. A log that can be read but says nothing comes with
/// its channels and `refusal`, the reason.
///
/// # Errors
/// One line, with the name of the log or the option and where it can be said line and column.
pub fn identify(log: LogFile, second: Option<LogFile>, asked: &Request) -> Result<Answer, String> {
    let spec = asked.spring()?;
    let spring = spec.as_ref().map(|spec| &spec.spring);
    let (settings, coil) = (asked.settings(spec.as_ref())?, asked.coil(spring)?);
    let recording = recording(log, second, asked)?;
    let (mut series, group) = recorded::curves(recording.signals());
    let mut facts = json!({ "group": group, "clock": clock(&recording), "simulated": recording.simulated() });
    let found = said(recording, &settings, coil, asked, &mut series);
    let found = found.unwrap_or_else(|refusal| json!({ "refusal": refusal }));
    for (name, value) in found.as_object().into_iter().flatten() {
        facts[name] = value.clone();
    }
    Ok(Answer::new(&facts, series))
}

fn recording(log: LogFile, second: Option<LogFile>, asked: &Request) -> Result<Recording, String> {
    let (mapping, cleaning) = (asked.mapping()?, asked.cleaning()?);
    let read = |log: LogFile, mapping, cleaning| {
        Recording::of_handed(log.handed(), mapping, cleaning).map_err(|error| asked.told(error))
    };
    let recording = read(log, &mapping, &cleaning)?;
    let Some(second) = second else { return Ok(recording) };
    // The window is one of the first device's clock.
    let cleaning = Cleaning { from: None, to: None, ..cleaning };
    let clock = asked.clock()?;
    let other = read(second, &asked.second_mapping()?, &cleaning)?;
    recording.joined(&other, clock).map_err(|error| asked.told(error))
}

/// What was added to the second device's times, and how that is known.
fn clock(recording: &Recording) -> Value {
    recording.account().joined.as_ref().map_or(Value::Null, |joined| {
        let found = joined.found.as_ref().map(|(channels, found)| {
            let span = joined.account.span.unwrap_or_default();
            let widest = span.map(|time| found.half_width_at(time)).into_iter().fold(found.half_width, f64::max);
            let drift = found.drift.map(|drift| [1e6 * drift.rate, 1e6 * drift.half_width]);
            json!({ "channels": channels, "halfWidth": widest, "drift": drift, "correlation": found.correlation })
        });
        json!({ "file": joined.account.file, "offset": joined.offset, "found": found })
    })
}

fn said(
    recording: Recording,
    settings: &Settings,
    coil: Option<Coil>,
    asked: &Request,
    series: &mut Vec<(String, Vec<f64>)>,
) -> Result<Value, String> {
    let identified = Identified::of(recording, settings).map_err(|error| asked.told(error))?;
    let told = identification_json(&identified, None).map_err(|error| error.to_string())?;
    let needed = "tell windings, radius and wire, or that it is the spring of the tab Spring: no log of forces and positions tells them";
    let spec =
        coil.map_or(Err(needed.to_owned()), |coil| spec_file(&identified, &coil).map_err(|error| error.to_string()));
    let spectra = curves(&identified.found, series);
    Ok(json!({
        "json": told,
        "spectra": spectra,
        "hits": identified.found.hits.iter().map(|hit| hit.time).collect::<Vec<_>>(),
        "spec": spec.as_ref().ok(),
        "noSpecBecause": spec.as_ref().err(),
    }))
}

/// Adds the curves; the names of the spectra.
fn curves(found: &Identification, series: &mut Vec<(String, Vec<f64>)>) -> Vec<String> {
    let mut spectra = Vec::new();
    for (number, (part, welch)) in found.spectra.iter().enumerate() {
        let (frequency, density) = amplitudes(welch);
        spectra.push(part_label(*part));
        series.push((format!("spectrum {number} frequency"), frequency));
        series.push((format!("spectrum {number}"), density));
    }
    if let Some(ring_down) = &found.ring_down {
        series.push(("ring time".to_owned(), thinned(&ring_down.time)));
        series.push(("ring measured".to_owned(), thinned(&ring_down.measured)));
        series.push(("ring fitted".to_owned(), thinned(&ring_down.fitted)));
    }
    if let Ok(line) = &found.stiffness {
        series.push(("length".to_owned(), thinned(&line.lengths)));
        series.push(("force".to_owned(), thinned(&line.forces)));
    }
    spectra
}

fn part_label(part: Part) -> String {
    match part {
        Part::Difference => "½(F_o − F_i)".into(),
        Part::Sum => "½(F_o + F_i)".into(),
        Part::Single(channel) => channel.name().into(),
    }
}

/// Frequencies \[Hz\] and square root of the density \[N/√Hz\], the first line left out; where there are many, the largest of each group.
fn amplitudes(welch: &Welch) -> (Vec<f64>, Vec<f64>) {
    let shown = welch.density.get(1..).unwrap_or(&[]);
    let group = shown.len().div_ceil(MOST).max(1);
    let each = shown.chunks(group).enumerate().map(|(index, chunk)| {
        let largest = chunk.iter().copied().fold(0.0, f64::max);
        ((1.0 + (index * group) as f64) * welch.spacing, largest.sqrt())
    });
    each.unzip()
}
