//! What each kind of settings consists of: its name, its type, its numbers.
//!
//! Next door: filters and shapers (`filters`), what takes more than a force (`observers`), the files made of them (`export`).

mod filters;
mod observers;

use std::fmt::Debug;

use coilsense_rt::Delay;
use serde_json::{Value, json};

use super::Precision;

/// Settings of `coilsense-rt` that can be written down.
pub trait Settings: Send + Sync {
    /// In words.
    fn kind(&self) -> &'static str;
    /// The type in Rust, over the number type `scalar`.
    fn rust_type(&self, scalar: &str) -> String;
    /// The value in Rust.
    fn rust_value(&self, precision: Precision) -> String;
    /// Every number by its name.
    fn numbers(&self) -> Value;
    /// How many samples the state's ring holds, where it has one.
    fn ring(&self) -> Option<usize>;
    /// The steps in C.
    fn c_template(&self) -> &'static str;
}

/// `Debug` of plain structs and arrays of numbers is how Rust writes them.
fn written(single: &impl Debug, double: &impl Debug, precision: Precision) -> String {
    match precision {
        Precision::Single => format!("{single:#?}"),
        Precision::Double => format!("{double:#?}"),
    }
}

fn single(value: f64) -> f32 {
    value as f32
}

fn delay(delay: &Delay<f64>) -> Value {
    json!({ "whole": delay.whole, "fraction": delay.fraction })
}
