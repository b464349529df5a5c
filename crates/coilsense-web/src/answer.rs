//! What goes back to the page: one JSON text for what is read by name, and arrays of doubles for what is drawn.
//!
//! Next door: what is in it (`preview`, `exact`, `paper`).

use serde_json::Value;
use wasm_bindgen::prelude::wasm_bindgen;

use crate::json;

/// One answer to the page.
#[wasm_bindgen]
#[derive(Debug, Clone)]
pub struct Answer {
    meta: String,
    series: Vec<(String, Vec<f64>)>,
    positions: Vec<f32>,
}

impl Answer {
    /// An answer of named series, each of which has its own length.
    pub fn new(meta: &Value, series: Vec<(String, Vec<f64>)>) -> Self {
        Self { meta: json::text(meta), series, positions: Vec::new() }
    }

    /// The same with positions of windings \[m\], shape `frames × (N + 2)`, row-major: single precision, since they are only drawn.
    pub fn with_positions(self, positions: Vec<f32>) -> Self {
        Self { positions, ..self }
    }

    /// A series by its name, where there is one.
    pub fn find(&self, name: &str) -> Option<&[f64]> {
        self.series.iter().find(|(other, _)| other == name).map(|(_, values)| values.as_slice())
    }
}

#[wasm_bindgen]
impl Answer {
    /// Everything that is no series, as JSON.
    pub fn meta(&self) -> String {
        self.meta.clone()
    }

    /// Names of the series, in order.
    pub fn names(&self) -> Vec<String> {
        self.series.iter().map(|(name, _)| name.clone()).collect()
    }

    /// Takes the values of the series of this number out; empty where there is none.
    pub fn take(&mut self, number: usize) -> Vec<f64> {
        self.series.get_mut(number).map(|(_, values)| std::mem::take(values)).unwrap_or_default()
    }

    /// Takes the positions out.
    pub fn take_positions(&mut self) -> Vec<f32> {
        std::mem::take(&mut self.positions)
    }
}
