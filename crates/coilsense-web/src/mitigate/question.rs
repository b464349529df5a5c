//! What may be asked of a study: the options of `coilsense mitigate`, under the same names, in the same units, with the same defaults.
//!
//! Next door: what comes of it (`mitigate`), how the page sends it (`log::Request`).

use coilsense_lab::mitigation::{OPTIONS, Request as Options, Study};
use coilsense_lab::quantity::plainly;
use coilsense_lab::request::{IfAbsent, Row};
use coilsense_lab::spec::Spec;
use serde_json::{Map, Value, json};

use crate::answer::Answer;
use crate::log::Request;

/// The study of the conditions, or of the stated scenario where `"on": "stated"` is asked for.
///
/// # Errors
/// One line, which begins with the option's name and a colon where it is about one.
pub fn study(spec: &Spec, given: &Request) -> Result<Study, String> {
    match given.text("on") {
        Some("stated") => Study::stated(&spec.spring.spring).map_err(|error| error.to_string()),
        _ => Study::of(spec, &asked(given)?).map_err(|error| error.to_string()),
    }
}

/// The options.
///
/// # Errors
/// One line, which begins with the option's name and a colon.
pub fn asked(given: &Request) -> Result<Options, String> {
    Options::of(&given.given(&OPTIONS)?).map_err(|wrong| wrong.to_string())
}

/// What the options are where nothing is said (`usual`), and what is wrong with those that are given (`wrong`), by their names.
///
/// # Errors
/// What the science says of the spec itself.
pub fn usual(spec: &Spec, given: &Request) -> Result<Answer, String> {
    let plain = Study::of(spec, &asked(&Request::default())?).map_err(|error| error.to_string())?;
    let found = |row: &Row| match (row.if_absent, row.name) {
        (IfAbsent::Value(text), _) => text.to_owned(),
        (_, "noise") => format!("{} N", plainly(plain.noise)),
        (_, "bandwidth") => format!("{} Hz", plainly(plain.bandwidth)),
        (_, "rate") => format!("{} Hz", (1e6 * plain.rate).round() / 1e6),
        (_, "stiffness_tolerance") => format!("{} %", plainly(100.0 * plain.tolerances.stiffness())),
        (_, "mass_tolerance") => format!("{} %", plainly(100.0 * plain.tolerances.mass())),
        (IfAbsent::Found(words), _) => words.to_owned(),
        (IfAbsent::Nothing | IfAbsent::Refused | IfAbsent::RefusedWithout(_), _) => String::new(),
    };
    let usual: Map<String, Value> = OPTIONS.iter().map(|row| (row.flag(), json!(found(row)))).collect();
    let refused = |row: &Row| row.value(given.text(&row.flag())?).err().map(|wrong| wrong.to_string());
    let mut wrong: Vec<String> = OPTIONS.iter().filter_map(refused).collect();
    if wrong.is_empty() {
        let whole = asked(given).and_then(|options| {
            let study = Study::of(spec, &options).map_err(|error| error.to_string())?;
            study.check().map_err(|refused| refused.placed())
        });
        wrong.extend(whole.err());
    }
    Ok(Answer::new(&json!({ "usual": usual, "wrong": wrong }), Vec::new()))
}

#[cfg(test)]
mod tests {
    use super::*;

    const ANKLE: &str = include_str!("../../../../examples/sea-ankle.toml");

    fn found(given: &str) -> Value {
        let spec = Spec::parse("spec", ANKLE, &|_| Err("no files".to_owned())).unwrap();
        serde_json::from_str(&usual(&spec, &Request::parse(given).unwrap()).unwrap().meta()).unwrap()
    }

    #[test]
    fn what_is_usual_is_the_command_s() {
        let found = found("{}");
        assert_eq!(found["wrong"], json!([]));
        // 0.02 % of the load cell of 150 N at end 1, the rate of [control], f1/20 of 54.07 Hz; m has no tolerance in the spec.
        let usual = |name: &str| found["usual"][name].as_str().unwrap().to_owned();
        assert_eq!(["noise", "rate", "bandwidth"].map(usual), ["0.03 N", "2000 Hz", "2.7 Hz"]);
        assert_eq!(["stiffness-tolerance", "mass-tolerance"].map(usual), ["0.5 %", "10 %"]);
    }

    #[test]
    fn what_is_wrong_is_said_of_the_option_with_its_value() {
        for (given, reason) in [
            (r#"{"rate": "fast"}"#, r#"rate: must be a frequency with its unit (Hz, kHz, MHz, rpm), got "fast""#),
            (r#"{"rate": "100 Hz"}"#, "rate: sampling rate must be above twice the first surge frequency"),
            (r#"{"noise": "-1 N"}"#, r#"noise: must be above zero, got "-1 N""#),
            (r#"{"bandwidth": "60 Hz"}"#, "bandwidth: bandwidth must be above zero and below"),
            (r#"{"mass-tolerance": "100 %"}"#, r#"mass-tolerance: must be from 0 % to below 100 %, got "100 %""#),
            (r#"{"rate": "1000 MHz"}"#, "rate: sampling rate must be at most "),
            (
                r#"{"stiffness-tolerance": "0 %", "mass-tolerance": "0 %"}"#,
                "stiffness-tolerance: must be above zero where the mass has no tolerance either: the box is empty",
            ),
            (r#"{"most-lag": "30"}"#, r#"most-lag: must be an angle with its unit (rad, deg), got "30""#),
            (r#"{"seeds": "0"}"#, r#"seeds: must be from 1 to 1000, got "0""#),
            (r#"{"seeds": "2.5"}"#, r#"seeds: must be a whole number from 1 to 1000, got "2.5""#),
        ] {
            let text = found(given)["wrong"][0].as_str().unwrap().to_owned();
            assert!(text.starts_with(reason), "{text}");
        }
    }
}
