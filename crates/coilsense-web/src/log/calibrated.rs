//! Inductance over length of a log, as `coilsense calibrate` does, beside the theories of a known coil.
//!
//! Next door: the pairs and the fits (`coilsense_lab::calibration`), what was asked (`asked`).

use coilsense::calibrate::Inversion;
use coilsense::inductance::theories::{Coil, Theory};
use coilsense_lab::calibration::{ForceLaw, Measured, Method, Outcome, Plan, Preload, lab_data_of_text};
use coilsense_lab::quantity::Dimension;
use coilsense_lab::recording::Points;
use coilsense_lab::report::calibration_json;
use serde_json::json;

use super::{Asked, Named, thinned};
use crate::answer::Answer;

/// Lengths at which fit and theories are drawn: a helix takes a millisecond for each.
const DRAWN: usize = 81;

/// The curve of inductance over length, as `coilsense calibrate --json` prints it, and the curves that are drawn.
///
/// # Errors
/// One line, with the name of the log or the option.
pub fn calibrate((name, text): Named, asked: &Asked) -> Result<Answer, String> {
    let spec = asked.spring()?;
    let zero_length = asked.above_zero("length-at-zero", Dimension::Length)?;
    let mut plan = plan(asked, zero_length)?;
    let known = asked.coil(spec.as_ref().map(|spec| &spec.spring))?;
    let coil = known.map(|coil| Coil::new(coil.windings, coil.coil_radius, coil.wire_radius));
    plan.coil = coil.transpose().map_err(|error| error.to_string())?;
    plan.force = spec.as_ref().map(ForceLaw::of);
    let measured = match (asked.is_lab_data(), zero_length) {
        (true, Some(zero)) => lab_data_of_text(&name, text, zero),
        (true, None) => return Err(needed("the file holds displacements, the curve is one of lengths")),
        (false, _) => {
            let points = Points::of_text(&name, text, &asked.mapping()?, &asked.repairs()?);
            Measured::of_log(&points.map_err(|error| asked.said(error))?, zero_length)
        }
    };
    let outcome =
        Outcome::new(measured.map_err(|error| asked.said(error))?, plan).map_err(|error| asked.said(error))?;
    let told = calibration_json(&outcome, None).map_err(|error| error.to_string())?;
    Ok(Answer::new(&json!({ "json": told }), curves(&outcome)))
}

fn needed(why: &str) -> String {
    format!("length-at-zero: must be given: {why}")
}

/// As the command's options are read; the measured runs are processed as their authors do unless told otherwise.
fn plan(asked: &Asked, zero_length: Option<f64>) -> Result<Plan, String> {
    let preload = asked.text("preload").map(preload).transpose()?;
    let method = match asked.word("method", &Method::ALL)? {
        Some(method) => method,
        None if preload.is_some() => Method::ThroughPreload,
        None if asked.is_lab_data() => Method::TwoPoint,
        None => Method::All,
    };
    if preload.is_some() && method != Method::ThroughPreload {
        return Err("preload: goes with the method through-preload only".to_owned());
    }
    let coarse = asked.word("inversion", &[("exact", false), ("25-lengths", true)])?;
    let inversion = match (coarse.unwrap_or(asked.is_lab_data()), zero_length) {
        (false, _) => Inversion::Exact,
        (true, Some(zero_length)) => Inversion::TwentyFiveLengths { zero_length },
        (true, None) => return Err(needed("the 25 lengths start from it")),
    };
    Ok(Plan { method, preload, inversion, coil: None, force: None })
}

/// `141.8 mm`, or with its inductance `141.8 mm, 3.35 uH`.
fn preload(text: &str) -> Result<Preload, String> {
    let above_zero = |dimension: Dimension, part: &str| {
        let value = dimension.parse(part).filter(|value| value.is_finite() && *value > 0.0);
        value.ok_or_else(|| format!("preload: must be {} above zero, got {part:?}", dimension.expectation()))
    };
    let (length, inductance) = text.split_once(',').map_or((text, None), |(at, henry)| (at, Some(henry)));
    let inductance = inductance.map(|henry| above_zero(Dimension::Inductance, henry)).transpose()?;
    Ok(Preload { length: above_zero(Dimension::Length, length)?, inductance })
}

/// `length` and `inductance` of the points; `drawn length`, and over it `fit` and `theory 0` …
fn curves(outcome: &Outcome) -> Vec<(String, Vec<f64>)> {
    let points = &outcome.measured.points;
    let ends = points.lengths().iter().fold([f64::INFINITY, 0.0], |[a, b]: [f64; 2], l| [a.min(*l), b.max(*l)]);
    let lengths: Vec<f64> =
        (0..DRAWN).map(|step| ends[0] + (ends[1] - ends[0]) * step as f64 / (DRAWN - 1) as f64).collect();
    let fit = outcome.inverse_length.calibration();
    let along = |relation: &dyn Fn(f64) -> f64| lengths.iter().map(|length| relation(*length)).collect::<Vec<f64>>();
    let mut series = vec![
        ("length".to_owned(), thinned(points.lengths())),
        ("inductance".to_owned(), thinned(points.inductances())),
        ("fit".to_owned(), along(&|length| fit.inductance(length))),
    ];
    let theories = outcome.plan.coil.iter().flat_map(|coil| Theory::ALL.map(|theory| (coil, theory)));
    for (number, (coil, theory)) in theories.enumerate() {
        series.push((format!("theory {number}"), along(&|length| theory.inductance(coil, length))));
    }
    series.push(("drawn length".to_owned(), lengths));
    series
}
