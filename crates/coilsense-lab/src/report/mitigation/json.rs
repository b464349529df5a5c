//! What to do about ringing as `results.json`.
//!
//! Next door: the same as text (`text`).

use serde_json::{Value, json};

use super::shaping::shaping_advice;
use super::text::advice;
use crate::mitigation::{Answer, Shaping};
use crate::report::ReportError;

/// Everything as JSON; errors in N.
///
/// # Errors
/// [`ReportError::Json`].
pub fn mitigation_json(answer: &Answer) -> Result<String, ReportError> {
    let candidates: Vec<Value> = answer
        .judged
        .iter()
        .map(|(candidate, judgement)| {
            json!({
                "name": candidate.name,
                "origin": candidate.origin.name(),
                "against": candidate.truth.name(),
                "rms error [N]": judgement.nominal,
                "worst rms error [N]": judgement.worst,
                "worst run": judgement.worst_run,
                "aligned rms error [N]": judgement.aligned,
                "delay of best fit [s]": judgement.delay,
                "lag at bandwidth [deg]": judgement.lag,
                "noise gain": judgement.noise_gain,
                "settling after an impact [s]": judgement.settling,
                "settings": candidate.settings().map(|settings| settings.numbers()),
            })
        })
        .collect();
    let left_out = answer.left_out.iter().map(|it| json!({ "name": it.name, "reason": it.reason }));
    let study = &answer.study;
    let whole = json!({
        "advice": advice(answer).lines().collect::<Vec<_>>(),
        "F_nom [N]": study.spring.nominal_force(),
        "sampling rate [Hz]": study.rate,
        "noise [N rms]": study.noise,
        "bandwidth [Hz]": study.bandwidth,
        "log": study.recorded.as_ref().map(|recorded| recorded.name.as_str()),
        "seeds": study.seeds,
        "first seed": study.seed,
        "stiffness tolerance": study.tolerances.stiffness(),
        "mass tolerance": study.tolerances.mass(),
        "candidates": candidates,
        "left out": left_out.collect::<Vec<_>>(),
        "command shaping": answer.shaping.as_ref().map(shaping),
    });
    Ok(serde_json::to_string_pretty(&whole)? + "\n")
}

/// What is left of ringing by shaped commands; shares of what the plain command leaves.
fn shaping(shaping: &Shaping) -> Value {
    let shapers = shaping.shapers.iter().map(|shaped| {
        json!({
            "name": shaped.name,
            "mode 1 left": shaped.first,
            "mode 1 left, worst": shaped.first_worst,
            "worst case": shaped.worst_case,
            "modes 2 to 5 left, worst": shaped.higher_worst,
            "mean delay [s]": shaped.delay,
            "length [s]": shaped.length,
            "settings": shaped.settings().map(|settings| settings.numbers()),
        })
    });
    let left_out = shaping.left_out.iter().map(|it| json!({ "name": it.name, "reason": it.reason }));
    json!({
        "conditions that move u1": shaping.conditions,
        "advice": shaping_advice(shaping),
        "shapers": shapers.collect::<Vec<_>>(),
        "left out": left_out.collect::<Vec<_>>(),
    })
}
