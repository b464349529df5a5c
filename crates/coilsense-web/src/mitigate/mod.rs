//! What to do about ringing, for the page's tab: every candidate judged, one run over time, settings to paste.
//!
//! Next door: what may be asked (`question`), how it is judged (`coilsense_lab::mitigation`).

mod question;

use coilsense_lab::mitigation::export::{Export, Precision};
use coilsense_lab::mitigation::{Candidate, Study, Truth};
use coilsense_lab::recording::{Cleaning, Recording};
use coilsense_lab::report::mitigation_json;
use coilsense_lab::spec::Spec;
use serde_json::{Value, json};

pub use question::{asked, usual};

use crate::answer::Answer;
use crate::log::{LogFile, Request};

/// As `coilsense mitigate --json` with the same options prints it; `told` hears how many candidates are judged, and of how many.
///
/// Series: `time`, `measured`, and for candidate n `out n` and `true n`.
///
/// # Errors
/// One line, which begins with the option's name and a colon where it is about one.
pub fn run(spec: &Spec, given: &Request, told: &(dyn Fn(usize, usize) + Sync)) -> Result<Answer, String> {
    answer(question::study(spec, given)?, told)
}

/// The same as with `--log`.
///
/// # Errors
/// As [`run`]; for the log with its name, and where it can be said line and column.
pub fn run_on(
    spec: &Spec,
    given: &Request,
    log: LogFile,
    told: &(dyn Fn(usize, usize) + Sync),
) -> Result<Answer, String> {
    let log = Recording::of_handed(log.handed(), &given.mapping()?, &Cleaning::default());
    let log = log.map_err(|error| given.told(error))?;
    answer(Study::on(spec, &asked(given)?, &log).map_err(|error| given.told(error))?, told)
}

fn answer(study: Study, told: &(dyn Fn(usize, usize) + Sync)) -> Result<Answer, String> {
    let rate = study.rate;
    let answer = study.run_watched(told).map_err(|refused| refused.placed())?;
    let exports = answer.judged.iter().map(|(candidate, _)| exports(candidate, rate));
    let exports: Vec<Value> = exports.collect::<Result<_, _>>()?;
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
        "best": best,
        "run": answer.shown.as_ref().map(|shown| &shown.label),
        "exports": exports,
    });
    Ok(Answer::new(&meta, series))
}

/// The settings in either precision, under the command's names; null for what is measured as it is.
fn exports(candidate: &Candidate, rate: f64) -> Result<Value, String> {
    let Some(settings) = candidate.settings() else { return Ok(Value::Null) };
    let name = match candidate.truth {
        Truth::Static => "force_filter",
        Truth::Output => "force_estimator",
    };
    let export = |precision| -> Result<Value, String> {
        let export = Export::new(name, rate, precision, settings).map_err(|error| error.to_string())?;
        let header = export.c().map_err(|error| error.to_string())?;
        let numbers = serde_json::to_string_pretty(&export.json()).map_err(|error| error.to_string())?;
        Ok(json!({ "name": name, "h": header, "rs": export.rust(), "json": numbers + "\n" }))
    };
    Ok(json!({ "single": export(Precision::Single)?, "double": export(Precision::Double)? }))
}
