//! Indices for machines.
//!
//! Next door: the same for people (`text`, `html`).

use serde::Serialize;

use crate::report::outcome::{Outcome, to_json};
use crate::sensitivity::{Estimate, Evaluations, OfColumn, Study, answer};

/// Which variable matters for which column of a sweep; null stands for what could not be estimated.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "reference", derive(schemars::JsonSchema))]
pub struct SensitivityOutcome<'a> {
    /// The answer, a sentence each.
    answer: Vec<String>,
    rows: RowsPart,
    /// Share of the resamples between an interval's ends.
    level: f64,
    resamples: usize,
    seed: u64,
    columns: Vec<ColumnRow<'a>>,
}

impl Outcome for SensitivityOutcome<'_> {
    const SCHEMA: &'static str = "coilsense/sensitivity/1";
}

/// Designs that were planned, are there, clash, and were refused.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "reference", derive(schemars::JsonSchema))]
struct RowsPart {
    planned: u64,
    there: u64,
    clash: u64,
    refused: u64,
}

/// A column, with why it has no indices or with them.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "reference", derive(schemars::JsonSchema))]
struct ColumnRow<'a> {
    column: &'a str,
    #[serde(skip_serializing_if = "Option::is_none")]
    error: Option<String>,
    #[serde(flatten)]
    found: Option<FoundPart<'a>>,
}

#[derive(Debug, Serialize)]
#[cfg_attr(feature = "reference", derive(schemars::JsonSchema))]
struct FoundPart<'a> {
    mean: f64,
    variance: f64,
    base_rows: usize,
    base_rows_left_out: usize,
    variables: Vec<VariableRow<'a>>,
}

/// Shares of the column's variance.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "reference", derive(schemars::JsonSchema))]
struct VariableRow<'a> {
    key: &'a str,
    /// What would go, on average, were this one alone known.
    first_order: EstimatePart,
    /// What would stay, on average, were all others known.
    total: EstimatePart,
}

#[derive(Debug, Serialize)]
#[cfg_attr(feature = "reference", derive(schemars::JsonSchema))]
struct EstimatePart {
    value: Option<f64>,
    lower: Option<f64>,
    upper: Option<f64>,
}

impl<'a> SensitivityOutcome<'a> {
    /// Of a study that was made.
    pub fn of(study: &'a Study) -> Self {
        Self {
            answer: answer(study),
            rows: RowsPart::of(&study.evaluations),
            level: study.resampling.level,
            resamples: study.resampling.resamples,
            seed: study.resampling.seed,
            columns: study.columns.iter().map(|column| ColumnRow::of(column, &study.variables)).collect(),
        }
    }
}

impl RowsPart {
    fn of(counts: &Evaluations) -> Self {
        Self { planned: counts.planned, there: counts.rows, clash: counts.clash, refused: counts.refused }
    }
}

impl<'a> ColumnRow<'a> {
    fn of(column: &'a OfColumn, variables: &'a [String]) -> Self {
        let found = column.found.as_ref().ok().map(|found| FoundPart {
            mean: found.mean,
            variance: found.variance,
            base_rows: found.base_rows,
            base_rows_left_out: found.left_out,
            variables: variables
                .iter()
                .zip(&found.variables)
                .map(|(key, index)| VariableRow {
                    key,
                    first_order: EstimatePart::of(&index.first),
                    total: EstimatePart::of(&index.total),
                })
                .collect(),
        });
        Self { column: &column.title, error: column.found.as_ref().err().map(ToString::to_string), found }
    }
}

impl EstimatePart {
    fn of(estimate: &Estimate) -> Self {
        let finite = |value: f64| value.is_finite().then_some(value);
        Self { value: finite(estimate.value), lower: finite(estimate.lower), upper: finite(estimate.upper) }
    }
}

/// The indices as JSON.
///
/// # Errors
/// What the JSON writer says.
pub fn sensitivity_json(study: &Study) -> Result<String, serde_json::Error> {
    to_json(SensitivityOutcome::of(study))
}
