//! A front for machines: SI, one key per number.
//!
//! Next door: the same for people (`text`, `html`), all columns of all designs (`csv`).

use serde::Serialize;
use serde_json::{Map, Value, json};

use crate::pareto::{Aim, Counts, Objective, Span, Study, answer};
use crate::report::outcome::{Outcome, to_json};
use crate::sweep::Data;

/// The designs that none other beats in every objective; null stands for what is not there.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "reference", derive(schemars::JsonSchema))]
pub struct ParetoOutcome<'a> {
    /// The answer, a sentence each.
    answer: Vec<String>,
    objectives: Vec<ObjectiveRow<'a>>,
    conditions: Vec<String>,
    rows: RowsPart,
    /// The design of the front nearest to the best of all objectives at once.
    knee_row: u64,
    variables: Vec<VariableRow<'a>>,
    /// Every column of each design of the front, under the column's title.
    front: Vec<Map<String, Value>>,
}

impl Outcome for ParetoOutcome<'_> {
    const SCHEMA: &'static str = "coilsense/pareto/1";
}

#[derive(Debug, Serialize)]
#[cfg_attr(feature = "reference", derive(schemars::JsonSchema))]
struct ObjectiveRow<'a> {
    column: &'a str,
    /// "minimize" or "maximize".
    aim: &'static str,
    best_row: u64,
}

/// What became of the sweep's designs.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "reference", derive(schemars::JsonSchema))]
struct RowsPart {
    planned: u64,
    there: u64,
    clash: u64,
    refused: u64,
    fail_a_condition: u64,
    without_a_number: u64,
    compared: u64,
}

/// From where to where a variable goes among all designs that were compared, and on the front.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "reference", derive(schemars::JsonSchema))]
struct VariableRow<'a> {
    column: &'a str,
    compared: [f64; 2],
    front: [f64; 2],
}

impl<'a> ParetoOutcome<'a> {
    /// Of a front that was found.
    pub fn of(study: &'a Study) -> Self {
        let objectives = study.question.objectives.iter().zip(&study.extremes);
        Self {
            answer: answer(study),
            objectives: objectives.map(|(objective, &best)| ObjectiveRow::of(objective, study.rows[best])).collect(),
            conditions: study.question.conditions(),
            rows: RowsPart::of(&study.counts),
            knee_row: study.rows[study.knee],
            variables: study.spans.iter().map(VariableRow::of).collect(),
            front: (0..study.rows.len()).map(|place| design(study, place)).collect(),
        }
    }
}

impl<'a> ObjectiveRow<'a> {
    fn of(objective: &'a Objective, best_row: u64) -> Self {
        let aim = match objective.aim {
            Aim::Minimize => "minimize",
            Aim::Maximize => "maximize",
        };
        Self { column: &objective.title, aim, best_row }
    }
}

impl RowsPart {
    fn of(counts: &Counts) -> Self {
        Self {
            planned: counts.planned,
            there: counts.rows,
            clash: counts.clash,
            refused: counts.refused,
            fail_a_condition: counts.excluded,
            without_a_number: counts.without_number,
            compared: counts.compared,
        }
    }
}

impl<'a> VariableRow<'a> {
    fn of(span: &'a Span) -> Self {
        Self { column: &span.title, compared: span.all, front: span.front }
    }
}

fn design(study: &Study, place: usize) -> Map<String, Value> {
    let value = |data: &Data| match data {
        Data::Whole(values) => json!(values.get(place)),
        Data::Numbers(values) => json!(values.get(place).filter(|value| value.is_finite())),
        Data::Texts(values) => json!(values.get(place)),
        Data::Flags(values) => json!(values.get(place).copied().flatten()),
    };
    study.front.columns.iter().map(|(title, data)| (title.clone(), value(data))).collect()
}

/// The front as JSON.
///
/// # Errors
/// What the JSON writer says.
pub fn pareto_json(study: &Study) -> Result<String, serde_json::Error> {
    to_json(ParetoOutcome::of(study))
}
