//! What the coil's inductance would be at the points for one permeability of its wire after the other: for people who look for theirs.
//!
//! Next door: the fit that finds it (`taken`), the coil (`steel`).

use super::{Outcome, steel};

/// Inductances of the coil for a row of permeabilities, without a constant.
#[derive(Debug, Clone, PartialEq)]
pub struct ByPermeability {
    /// μ_r, from 1 in equal steps.
    pub permeabilities: Vec<f64>,
    /// L \[H\] of each at every length that was asked for, shape `permeabilities` × `lengths`; NaN outside of the points' lengths.
    pub inductances: Vec<Vec<f64>>,
}

/// From 1 to 4 in tenths: a straight line between two is 6e-5 of L off (test); three measured springs were at 2.1, 2.7 and 3.0.
const STEPS: usize = 31;
const STEP: f64 = 0.1;

impl ByPermeability {
    /// Of the coil that a calibration knows, at lengths \[m\]; nothing without a coil, and where its turns come too near to one another at a point.
    pub fn of(outcome: &Outcome, lengths: &[f64]) -> Option<Self> {
        let coil = outcome.plan.coil.as_ref()?;
        let coil = steel::coil(&outcome.measured, coil, &outcome.plan.steel).ok()?;
        let permeabilities: Vec<f64> = (0..STEPS).map(|step| 1.0 + STEP * step as f64).collect();
        let of = |&permeability: &f64| {
            let curve = coil.of(permeability).ok()?;
            Some(lengths.iter().map(|&length| curve.inductance(length)).collect())
        };
        let inductances = permeabilities.iter().map(of).collect::<Option<_>>()?;
        Some(Self { permeabilities, inductances })
    }
}
