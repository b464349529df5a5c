//! A front for machines: SI, one key per number.
//!
//! Next door: the same for people (`text`, `html`), all columns of all designs (`csv`).

use serde_json::{Map, Value, json};

use crate::pareto::{Aim, Study, answer};
use crate::sweep::Data;

/// The front as JSON; `null` stands for what is not there.
///
/// # Errors
/// What the JSON writer says.
pub fn pareto_json(study: &Study) -> Result<String, serde_json::Error> {
    let counts = &study.counts;
    let objectives = study.question.objectives.iter().zip(&study.extremes).map(|(objective, best)| {
        json!({
            "column": objective.title,
            "aim": match objective.aim { Aim::Minimize => "minimize", Aim::Maximize => "maximize" },
            "best_row": study.rows[*best],
        })
    });
    let spans =
        study.spans.iter().map(|span| json!({ "column": span.title, "compared": span.all, "front": span.front }));
    let object = json!({
        "schema": "coilsense/pareto/1",
        "version": env!("CARGO_PKG_VERSION"),
        "answer": answer(study),
        "objectives": objectives.collect::<Value>(),
        "conditions": study.question.conditions(),
        "rows": {
            "planned": counts.planned,
            "there": counts.rows,
            "clash": counts.clash,
            "refused": counts.refused,
            "fail_a_condition": counts.excluded,
            "without_a_number": counts.without_number,
            "compared": counts.compared,
        },
        "knee_row": study.rows[study.knee],
        "variables": spans.collect::<Value>(),
        "front": (0..study.rows.len()).map(|place| design(study, place)).collect::<Value>(),
    });
    Ok(format!("{}\n", serde_json::to_string_pretty(&object)?))
}

fn design(study: &Study, place: usize) -> Value {
    let value = |data: &Data| match data {
        Data::Whole(values) => json!(values.get(place)),
        Data::Numbers(values) => json!(values.get(place).filter(|value| value.is_finite())),
        Data::Texts(values) => json!(values.get(place)),
        Data::Flags(values) => json!(values.get(place).copied().flatten()),
    };
    study.front.columns.iter().map(|(title, data)| (title.clone(), value(data))).collect::<Map<_, _>>().into()
}
