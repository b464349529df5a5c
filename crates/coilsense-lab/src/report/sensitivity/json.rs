//! Indices for machines.
//!
//! Next door: the same for people (`text`, `html`).

use serde_json::{Value, json};

use crate::sensitivity::{Estimate, Study, answer};

/// The indices as JSON; `null` stands for what could not be estimated.
///
/// # Errors
/// What the JSON writer says.
pub fn sensitivity_json(study: &Study) -> Result<String, serde_json::Error> {
    let columns = study.columns.iter().map(|column| match &column.found {
        Err(error) => json!({ "column": column.title, "error": error.to_string() }),
        Ok(found) => {
            let each = study.variables.iter().zip(&found.variables).map(
                |(key, index)| json!({ "key": key, "first_order": value(&index.first), "total": value(&index.total) }),
            );
            json!({
                "column": column.title,
                "mean": found.mean,
                "variance": found.variance,
                "base_rows": found.base_rows,
                "base_rows_left_out": found.left_out,
                "variables": each.collect::<Value>(),
            })
        }
    });
    let counts = &study.evaluations;
    let object = json!({
        "schema": "coilsense/sensitivity/1",
        "version": env!("CARGO_PKG_VERSION"),
        "answer": answer(study),
        "rows": {
            "planned": counts.planned, "there": counts.rows, "clash": counts.clash, "refused": counts.refused,
        },
        "level": study.resampling.level,
        "resamples": study.resampling.resamples,
        "seed": study.resampling.seed,
        "columns": columns.collect::<Value>(),
    });
    Ok(format!("{}\n", serde_json::to_string_pretty(&object)?))
}

fn value(estimate: &Estimate) -> Value {
    let finite = |value: f64| value.is_finite().then_some(value);
    json!({ "value": finite(estimate.value), "lower": finite(estimate.lower), "upper": finite(estimate.upper) })
}
