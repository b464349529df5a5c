//! Inductance over length of a log, as `coilsense calibrate` does, beside the theories of a known coil.
//!
//! Next door: the pairs and the fits (`coilsense_lab::calibration`), what was asked (`asked`).

use coilsense::Channel;
use coilsense::inductance::theories::{Coil, Theory};
use coilsense_lab::calibration::request::{LENGTH_AT_ZERO, OPTIONS};
use coilsense_lab::calibration::{ByPermeability, ForceLaw, Measured, Outcome, Plan, lab_data_of};
use coilsense_lab::recording::Points;
use coilsense_lab::recording::request::{LAYOUT, is_lab_data};
use coilsense_lab::report::calibration_json;
use serde_json::{Value, json};

use super::{LogFile, Request, thinned};
use crate::answer::Answer;

/// Lengths at which fit and theories are drawn: a helix takes a millisecond for each.
const DRAWN: usize = 81;

/// The curve of inductance over length, as `coilsense calibrate --json` prints it, and the curves that are drawn; nothing where the log's positions
/// never change, as in a simulated impact: L then belongs to one length, and nothing is wrong.
///
/// # Errors
/// One line, with the name of the log or the option.
pub fn calibrate(log: LogFile, asked: &Request) -> Result<Answer, String> {
    let spec = asked.spring()?;
    let given = asked.given(OPTIONS.iter().chain(&LAYOUT))?;
    let zero_length = given.number(&LENGTH_AT_ZERO);
    let mut plan = Plan::of(&given, None).map_err(|wrong| wrong.to_string())?;
    if let Some(spec) = &spec {
        plan = plan.of_spring(&spec.spring, Some(ForceLaw::of(spec))).map_err(|error| error.to_string())?;
    } else {
        let coil = asked.coil(None)?.map(|coil| Coil::new(coil.windings, coil.coil_radius, coil.wire_radius));
        plan.coil = coil.transpose().map_err(|error| error.to_string())?;
    }
    let measured = match (is_lab_data(&given), zero_length) {
        (true, Some(zero)) => lab_data_of(log.handed(), zero),
        (true, None) => {
            let needed = "is needed: the file holds displacements, the curve is one of lengths";
            return Err(LENGTH_AT_ZERO.wrong(needed).to_string());
        }
        (false, _) => {
            let points = Points::of_handed(log.handed(), &asked.mapping()?, &asked.cleaning()?);
            let points = points.map_err(|error| asked.told(error))?;
            if stand_still(&points) {
                return Ok(Answer::new(&json!({ "json": Value::Null }), Vec::new()));
            }
            Measured::of_log(&points, zero_length)
        }
    };
    let outcome =
        Outcome::new(measured.map_err(|error| asked.told(error))?, plan).map_err(|error| asked.told(error))?;
    let told = calibration_json(&outcome, None).map_err(|error| error.to_string())?;
    let lengths = thinned(outcome.measured.points.lengths());
    let wire = ByPermeability::of(&outcome, &lengths);
    let permeabilities = wire.as_ref().map(|wire| &wire.permeabilities);
    let facts = json!({ "json": told, "permeabilities": permeabilities });
    let of_wire = wire.iter().flat_map(|wire| wire.inductances.iter().enumerate());
    let of_wire: Vec<_> = of_wire.map(|(number, values)| (format!("permeable {number}"), values.clone())).collect();
    Ok(Answer::new(&facts, curves(&outcome).into_iter().chain(of_wire).collect()))
}

/// Whether every position in a log is the same in all rows.
fn stand_still(points: &Points) -> bool {
    let positions = [Channel::U1, Channel::U2].into_iter().filter_map(|channel| points.channel(channel).ok());
    let still = |values: &[f64]| values.iter().all(|value| values.first() == Some(value));
    points.lines().len() > 1 && positions.clone().count() > 0 && positions.into_iter().all(still)
}

/// `length` and `inductance` of the points; `fit at points`, by eq. (13); `drawn length`, and over it `fit` and `theory 0` …
fn curves(outcome: &Outcome) -> Vec<(String, Vec<f64>)> {
    let points = &outcome.measured.points;
    let ends = points.lengths().iter().fold([f64::INFINITY, 0.0], |[a, b]: [f64; 2], l| [a.min(*l), b.max(*l)]);
    let lengths: Vec<f64> =
        (0..DRAWN).map(|step| ends[0] + (ends[1] - ends[0]) * step as f64 / (DRAWN - 1) as f64).collect();
    let along = |relation: &dyn Fn(f64) -> f64| lengths.iter().map(|length| relation(*length)).collect::<Vec<f64>>();
    let mut series = vec![
        ("length".to_owned(), thinned(points.lengths())),
        ("inductance".to_owned(), thinned(points.inductances())),
        (
            "fit at points".to_owned(),
            thinned(points.lengths())
                .iter()
                .map(|&length| outcome.inverse_length.calibration().inductance(length))
                .collect(),
        ),
        ("fit".to_owned(), along(&|length| outcome.taken.curve.inductance(length))),
    ];
    let theories = outcome.plan.coil.iter().flat_map(|coil| Theory::ALL.map(|theory| (coil, theory)));
    for (number, (coil, theory)) in theories.enumerate() {
        series.push((format!("theory {number}"), along(&|length| theory.inductance(coil, length))));
    }
    series.push(("drawn length".to_owned(), lengths));
    series
}
