//! A calibration for machines, all in SI units but for shares in percent, as their names say.
//!
//! Next door: the same for people (`text`, `html`).

use coilsense::calibrate::{Inversion, Misfit};
use serde_json::{Map, Value, json};

use crate::calibration::{Judged, Outcome, answer};

/// The whole calibration; what was not computed is null.
///
/// # Errors
/// [`serde_json::Error`] where it cannot be written.
pub fn calibration_json(outcome: &Outcome, date: Option<&str>) -> Result<String, serde_json::Error> {
    let (inverse, direct, measured) = (&outcome.inverse_length, &outcome.inductance, &outcome.measured);
    let inverse_length = json!({
        "alpha_per_h_m": inverse.alpha,
        "alpha_per_h_m_se": inverse.alpha_se,
        "beta_per_m": inverse.beta,
        "beta_per_m_se": inverse.beta_se,
        "degrees_of_freedom": inverse.degrees_of_freedom,
    });
    let inductance = json!({
        "alpha_h_m": direct.alpha,
        "alpha_h_m_se": direct.alpha_se,
        "beta_h": direct.beta,
        "beta_h_se": direct.beta_se,
        "degrees_of_freedom": direct.degrees_of_freedom,
    });
    let value = json!({
        "schema": "coilsense/calibration/1",
        "version": env!("CARGO_PKG_VERSION"),
        "date": date,
        "file": measured.file,
        "simulated": measured.simulated,
        "answer": answer(outcome),
        "method": outcome.plan.method.name(),
        "inversion": match outcome.plan.inversion { Inversion::Exact => "exact", Inversion::TwentyFiveLengths { .. } => "25-lengths" },
        "length_at_zero_m": measured.zero_length,
        "range_m": measured.points.range(),
        "inverse_length": with_misfit(inverse_length, &inverse.misfit),
        "inductance": with_misfit(inductance, &direct.misfit),
        "theories": outcome.theories.iter().map(theory).collect::<Vec<_>>(),
        "coil": outcome.plan.coil.map(|coil| json!({
            "windings": coil.windings(), "coil_radius_m": coil.coil_radius(), "wire_radius_m": coil.wire_radius(),
        })),
        "force": outcome.plan.force.map(|law| json!({
            "stiffness_n_per_m": law.stiffness,
            "stiffness_n_per_m_u": law.stiffness_u,
            "length_at_zero_force_m": law.rest_length,
            "length_at_zero_force_m_u": law.rest_length_u,
        })),
        "points": points(outcome),
        "account": measured.account,
    });
    serde_json::to_string_pretty(&value).map(|text| text + "\n")
}

fn with_misfit(value: Value, misfit: &Misfit) -> Value {
    let mut fields = match value {
        Value::Object(fields) => fields,
        _ => Map::new(),
    };
    let worst = misfit.residuals.iter().fold(0.0, |worst: f64, residual| worst.max(residual.abs()));
    for (name, number) in [
        ("r2", misfit.r2),
        ("rmse_m", misfit.rmse),
        ("rmse_percent_of_range", 100.0 * misfit.rmse_share_of_range),
        ("largest_residual_m", worst),
    ] {
        fields.insert(name.to_owned(), number.into());
    }
    Value::Object(fields)
}

fn theory(judged: &Judged) -> Value {
    let head = json!({
        "name": judged.theory.name(),
        "fractional_windings": judged.theory.fractions(),
        "refused": judged.misfit.as_ref().err(),
    });
    match &judged.misfit {
        Ok(misfit) => with_misfit(head, misfit),
        Err(_) => head,
    }
}

fn points(outcome: &Outcome) -> Vec<Value> {
    let measured = &outcome.measured;
    let forces = outcome.forces();
    let one = |(index, place): (usize, f64)| {
        let henry = measured.points.inductances()[index];
        let force = forces.as_ref().map(|forces| forces[index]);
        json!({
            "row": measured.rows[index],
            measured.place_name().to_owned() + "_m": place,
            "inductance_h": henry,
            "inductance_h_se": measured.standard_errors.get(index),
            "length_read_m": outcome.inverse_length.calibration().length(henry),
            "length_read_m_u": outcome.reading.map(|reading| reading.length(henry)),
            "residual_m": outcome.inverse_length.misfit.residuals[index],
            "force_n": force.map(|(force, _)| force),
            "force_n_u": force.and_then(|(_, uncertainty)| uncertainty),
        })
    };
    measured.places().into_iter().enumerate().map(one).collect()
}
