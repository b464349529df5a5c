//! What may be asked of a study: the options of `coilsense mitigate`, under the same names, in the same units, with the same defaults.
//!
//! Next door: what comes of it (`mitigate`), how the page sends it (`log::Asked`).

use coilsense::Error;
use coilsense::mitigation::ToleranceBox;
use coilsense_lab::mitigation::{Asked as Options, Study};
use coilsense_lab::quantity::{Dimension, plainly};
use coilsense_lab::spec::Spec;
use serde_json::{Map, Value, json};

use crate::answer::Answer;
use crate::log::Asked;

/// Most series of noise.
const MOST_SEEDS: u64 = 1000;

/// The name of an option, its dimension and what it is where nothing is said; nothing where that hangs on the spec.
const OPTIONS: [(&str, Dimension, Option<&str>); 6] = [
    ("rate", Dimension::Frequency, Some("2.5 kHz")),
    ("noise", Dimension::Force, None),
    ("bandwidth", Dimension::Frequency, None),
    ("stiffness-tolerance", Dimension::Share, Some("10 %")),
    ("mass-tolerance", Dimension::Share, Some("10 %")),
    ("most-lag", Dimension::Angle, Some("30 deg")),
];

/// The study of the conditions, or of the stated scenario where `"on": "stated"` is asked for.
///
/// # Errors
/// One line, which begins with the option's name and a colon where it is about one.
pub fn study(spec: &Spec, given: &Asked) -> Result<Study, String> {
    match given.text("on") {
        Some("stated") => Study::stated(&spec.spring.spring).map_err(|error| placed(&error)),
        _ => Study::of(spec, &asked(given)?).map_err(|error| error.to_string()),
    }
}

/// The options.
///
/// # Errors
/// One line, which begins with the option's name and a colon.
pub fn asked(given: &Asked) -> Result<Options, String> {
    let mut values = [None; OPTIONS.len()];
    for (value, (name, dimension, usual)) in values.iter_mut().zip(OPTIONS) {
        *value = given.quantity(name, dimension)?.or_else(|| usual.and_then(|usual| dimension.parse(usual)));
    }
    let [rate, noise, bandwidth, stiffness, mass, lag] = values;
    let [rate, stiffness, mass, lag] = [rate, stiffness, mass, lag].map(Option::unwrap_or_default);
    let tolerances = ToleranceBox::new(stiffness, mass).map_err(|error| placed(&error))?;
    Ok(Options { rate, noise, bandwidth, tolerances, most_lag: lag.to_degrees(), seeds: seeds(given)? })
}

fn seeds(given: &Asked) -> Result<u64, String> {
    let Some(text) = given.text("seeds") else { return Ok(5) };
    let count = text.parse().ok().filter(|count| (1..=MOST_SEEDS).contains(count));
    count.ok_or_else(|| format!("seeds: must be a whole number from 1 to {MOST_SEEDS}, got {text:?}"))
}

/// What the options are where nothing is said (`usual`), and what is wrong with those that are given (`wrong`), by their names.
///
/// # Errors
/// What the science says of the spec itself.
pub fn usual(spec: &Spec, given: &Asked) -> Result<Answer, String> {
    let mut usual: Map<String, Value> =
        OPTIONS.iter().filter_map(|(name, _, usual)| Some(((*name).to_owned(), json!(usual.as_ref()?)))).collect();
    let plain = Study::of(spec, &asked(&Asked::default())?).map_err(|error| error.to_string())?;
    usual.insert("noise".into(), json!(format!("{} N", plainly(plain.noise))));
    usual.insert("bandwidth".into(), json!(format!("{} Hz", plainly(plain.bandwidth))));
    usual.insert("seeds".into(), json!("5"));
    let each = OPTIONS.iter().map(|(name, dimension, _)| given.quantity(name, *dimension).err());
    let mut wrong: Vec<String> = each.chain([seeds(given).err()]).flatten().collect();
    if wrong.is_empty() {
        let whole = asked(given).and_then(|options| {
            let study = Study::of(spec, &options).map_err(|error| error.to_string())?;
            study.check().map_err(|error| placed(&error))
        });
        wrong.extend(whole.err());
    }
    Ok(Answer::new(&json!({ "usual": usual, "wrong": wrong }), Vec::new()))
}

/// An error of the science, behind the name of the option that it is about.
pub fn placed(error: &Error) -> String {
    let Error::Value { quantity, .. } = error else { return error.to_string() };
    let option = match quantity.as_ref() {
        "sampling rate" => "rate",
        "noise of the force" => "noise",
        "bandwidth" => "bandwidth",
        "mass tolerance" => "mass-tolerance",
        quantity if quantity.starts_with("stiffness tolerance") => "stiffness-tolerance",
        _ => return error.to_string(),
    };
    format!("{option}: {error}")
}

#[cfg(test)]
mod tests {
    use super::*;

    const ANKLE: &str = include_str!("../../../../examples/sea-ankle.toml");

    fn found(given: &str) -> Value {
        let spec = Spec::parse("spec", ANKLE, &|_| Err("no files".to_owned())).unwrap();
        serde_json::from_str(&usual(&spec, &Asked::parse(given).unwrap()).unwrap().meta()).unwrap()
    }

    #[test]
    fn what_is_usual_is_the_command_s() {
        let found = found("{}");
        assert_eq!(found["wrong"], json!([]));
        // 0.2 % of 121.6 N; f1/20 of 54.07 Hz.
        assert_eq!((&found["usual"]["noise"], &found["usual"]["bandwidth"]), (&json!("0.243 N"), &json!("2.7 Hz")));
    }

    #[test]
    fn what_is_wrong_is_said_of_the_option_with_its_value() {
        for (given, reason) in [
            (r#"{"rate": "fast"}"#, r#"rate: must be a frequency with its unit (Hz, kHz, MHz), got "fast""#),
            (r#"{"rate": "100 Hz"}"#, "rate: sampling rate must be above twice the first surge frequency"),
            (r#"{"noise": "-1 N"}"#, "noise: noise of the force must be above zero and finite, got -1 N"),
            (r#"{"bandwidth": "60 Hz"}"#, "bandwidth: bandwidth must be above zero and below"),
            (r#"{"mass-tolerance": "100 %"}"#, "mass-tolerance: mass tolerance must be from 0 to below 1, got 1"),
            (r#"{"most-lag": "30"}"#, r#"most-lag: must be an angle with its unit (rad, deg), got "30""#),
            (r#"{"seeds": "0"}"#, r#"seeds: must be a whole number from 1 to 1000, got "0""#),
        ] {
            let text = found(given)["wrong"][0].as_str().unwrap().to_owned();
            assert!(text.starts_with(reason), "{text}");
        }
    }
}
