//! The static force of a helix over a range of lengths, at the price of a polynomial.
//!
//! Next door: the force at one length (`state`), the straight line that a motion follows about its length (`surge`).

use std::f64::consts::PI;

use super::rod::Rod;
use super::state::{Helix, Turning};
use crate::error::{Error, check};

/// Force of a helix against the span of its active windings: a Chebyshev series between two spans.
///
/// F(l) = Σ_j a_j T_j(x), x = (2l − l_1 − l_2)/(l_2 − l_1)
///
/// Source:   Chebyshev's series of values at his nodes; the values are [`Helix::force`]'s.
/// Valid:    between the two spans; the force is smooth wherever the helix is one.
/// Accuracy: 1e-10 of the force where the longer span is at most twice the shorter and a third of the wire (`tests/helix`).
#[derive(Debug, Clone, PartialEq)]
pub struct StaticCurve {
    between: (f64, f64),
    coefficients: Vec<f64>,
}

/// Terms of the series.
const TERMS: usize = 17;

impl StaticCurve {
    /// Of a wire between two spans.
    ///
    /// - `between`: l_1 and l_2 \[m\]
    ///
    /// # Errors
    /// [`Error::Value`] for a second span that is not above the first, and as [`Helix::new`].
    pub fn new(rod: &Rod, turning: Turning, between: (f64, f64)) -> Result<Self, Error> {
        let (low, high) = between;
        check(high > low, "span", high, "m", format!("above the first, {low} m"))?;
        let angle = |node: usize| PI * (node as f64 + 0.5) / TERMS as f64;
        let force = |node: usize| {
            let span = 0.5 * (low + high) + 0.5 * (high - low) * angle(node).cos();
            Ok(Helix::new(rod, span, turning)?.force())
        };
        let forces: Vec<f64> = (0..TERMS).map(force).collect::<Result<_, Error>>()?;
        let coefficient = |term: usize| {
            let each = forces.iter().enumerate().map(|(node, force)| force * (term as f64 * angle(node)).cos());
            each.sum::<f64>() * if term == 0 { 1.0 } else { 2.0 } / TERMS as f64
        };
        Ok(Self { between, coefficients: (0..TERMS).map(coefficient).collect() })
    }

    /// F at a span \[N\], tension positive; beyond the two the series goes on as a polynomial and is not to be trusted.
    pub fn force(&self, span: f64) -> f64 {
        let (low, high) = self.between;
        let x = (2.0 * span - low - high) / (high - low);
        // Clenshaw's sum.
        let (mut last, mut before) = (0.0, 0.0);
        for coefficient in self.coefficients.iter().skip(1).rev() {
            (last, before) = (coefficient + 2.0 * x * last - before, last);
        }
        self.coefficients[0] + x * last - before
    }
}
