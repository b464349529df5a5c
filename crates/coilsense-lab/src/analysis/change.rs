//! Something to change in a sensor or a spec, to be tried and, where the sensor then meets the goal, to be named.
//!
//! Next door: which changes there are (`fix`, `tighter`), the verdict that they belong to (`verdict`).

use crate::quantity::Dimension;
use crate::spec::{SensorSpec, Spec};

/// A change with which a sensor meets the goal.
#[derive(Debug, Clone, PartialEq, serde::Serialize)]
#[cfg_attr(feature = "reference", derive(schemars::JsonSchema))]
pub struct Fix {
    /// What is changed, as a noun.
    pub change: String,
    /// The largest combined uncertainty with it \[N\].
    #[serde(rename = "combined_n")]
    pub combined: f64,
    /// How much later the force then comes \[s\].
    #[serde(rename = "lag_s")]
    pub lag: f64,
}

/// Something to try: a sensor, and where the change is not the sensor's, what the spec then says.
pub(super) struct Change {
    pub words: String,
    pub sensor: SensorSpec,
    pub spec: Option<Spec>,
}

/// `text` as a spec may hold it, and the value that it then has: what is named is what is tried.
pub(super) fn written(dimension: Dimension, text: String) -> Option<(f64, String)> {
    dimension.parse(&text).map(|value| (value, text))
}
