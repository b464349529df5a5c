//! An uncertainty budget in the terms of the GUM, and a Monte Carlo run of the same model to check it by.
//!
//! It knows nothing of springs: a model is a function of input quantities. Next door: which inputs a force sensor has (the caller's),
//! how far off a force is over time (`measures`).

mod agreement;
mod budget;
mod distribution;
mod input;
mod monte_carlo;
mod student;

pub use agreement::Agreement;
pub use budget::{Budget, Contribution};
pub use distribution::Distribution;
pub use input::Input;
pub use monte_carlo::MonteCarlo;
pub use student::coverage_factor;

use crate::error::{Error, called, check};

/// Lets through a coverage probability.
fn probability(coverage: f64) -> Result<f64, Error> {
    check(
        coverage > 0.0 && coverage < 1.0,
        called("coverage", "coverage probability"),
        coverage,
        "",
        "above 0 and below 1",
    )
}

/// What the model makes of `values`, where that is a number.
fn evaluate(model: &impl Fn(&[f64]) -> f64, values: &[f64]) -> Result<f64, Error> {
    let output = model(values);
    check(output.is_finite(), "output of the model", output, "", "finite at and around the inputs' estimates")
}
