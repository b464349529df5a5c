//! What to do about the ringing of a spec's conditions, for the page's tab: every candidate judged, one run over time, settings to paste.
//!
//! Next door: how it is judged (`coilsense_lab::mitigation`).

use coilsense::mitigation::ToleranceBox;
use coilsense_lab::mitigation::export::{Export, Precision};
use coilsense_lab::mitigation::{Asked, Candidate, Study, Truth};
use coilsense_lab::report::mitigation_json;
use coilsense_lab::spec::Spec;
use serde_json::{Value, json};

use crate::answer::Answer;

/// As the command does where nothing else is asked \[Hz\], and how much of k and m may be off.
const RATE: f64 = 2500.0;
const OFF: f64 = 0.1;

/// As `coilsense mitigate --json` with so many series of noise and such a lag \[degrees\] prints it; `told` hears how many candidates are judged.
///
/// Series: `time`, `measured`, and for candidate n `out n` and `true n`.
///
/// # Errors
/// One line: what the science says.
pub fn run(spec: &Spec, seeds: u64, most_lag: f64, told: &(dyn Fn(usize, usize) + Sync)) -> Result<Answer, String> {
    let tolerances = ToleranceBox::new(OFF, OFF).map_err(|error| error.to_string())?;
    let asked = Asked { rate: RATE, noise: None, bandwidth: None, tolerances, most_lag, seeds };
    let study = Study::of(spec, &asked).map_err(|error| error.to_string())?;
    let answer = study.run_watched(told).map_err(|error| error.to_string())?;
    let exports: Vec<Value> = answer.judged.iter().map(|(candidate, _)| export(candidate)).collect::<Result<_, _>>()?;
    let best = [Truth::Static, Truth::Output].map(|truth| answer.place_of_best(truth));
    let mut series = Vec::new();
    if let Some(shown) = &answer.shown {
        series.push(("time".to_owned(), shown.time.clone()));
        series.push(("measured".to_owned(), shown.measured.clone()));
        for (number, made) in shown.made.iter().enumerate() {
            series.push((format!("out {number}"), made.out.clone()));
            series.push((format!("true {number}"), made.truly.clone()));
        }
    }
    let meta = json!({
        "json": mitigation_json(&answer).map_err(|error| error.to_string())?,
        "mostLag": most_lag,
        "best": best,
        "run": answer.shown.as_ref().map(|shown| &shown.label),
        "exports": exports,
    });
    Ok(Answer::new(&meta, series))
}

/// The settings as a C header in single precision and as JSON, under the command's names; null for what is measured as it is.
fn export(candidate: &Candidate) -> Result<Value, String> {
    let Some(settings) = candidate.settings() else { return Ok(Value::Null) };
    let name = match candidate.truth {
        Truth::Static => "force_filter",
        Truth::Output => "force_estimator",
    };
    let export = Export::new(name, RATE, Precision::Single, settings).map_err(|error| error.to_string())?;
    let header = export.c().map_err(|error| error.to_string())?;
    let numbers = serde_json::to_string_pretty(&export.json()).map_err(|error| error.to_string())?;
    Ok(json!({ "name": name, "header": header, "json": numbers + "\n" }))
}
