//! Quantities over a range: polynomials through their values at a few places.
//!
//! Next door: coils over length (`coil`), turns that move (`moving`), the points themselves (`super::super::chebyshev`).

use crate::inductance::chebyshev::Interpolation;

/// Places between which a quantity is a polynomial.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Grid {
    middle: f64,
    half: f64,
    interpolation: Interpolation,
}

/// Such a quantity, lowest power first; zero without coefficients.
#[derive(Debug, Clone, PartialEq, Default)]
pub(super) struct Polynomial {
    middle: f64,
    half: f64,
    coefficients: Vec<f64>,
}

impl Grid {
    /// Over a range, which may be a single place: then there is one node, whatever the count.
    pub fn new([first, last]: [f64; 2], count: usize) -> Self {
        let (middle, half) = (0.5 * (first + last), 0.5 * (last - first));
        Self { middle, half, interpolation: Interpolation::new(if half == 0.0 { 1 } else { count }) }
    }

    pub fn places(&self) -> Vec<f64> {
        self.interpolation.nodes().iter().map(|place| self.middle + self.half * place).collect()
    }

    /// Through values at the places.
    pub fn through(&self, values: &[f64]) -> Polynomial {
        let mut coefficients = vec![0.0; values.len()];
        self.interpolation.coefficients(values, &mut coefficients);
        Polynomial { middle: self.middle, half: self.half, coefficients }
    }

    /// By how much of each value the polynomial is at a place.
    pub fn weights(&self, x: f64) -> Vec<f64> {
        let (nodes, place) = (self.interpolation.nodes(), within(x, self.middle, self.half));
        let others = |own: usize| nodes.iter().enumerate().filter(move |(other, _)| *other != own);
        let weight = |own: usize| others(own).map(|(_, other)| (place - other) / (nodes[own] - other)).product();
        (0..nodes.len()).map(weight).collect()
    }

    /// What the polynomial through values may be off by: its coefficients of the highest degrees. Nothing of a single place.
    pub fn unsettled(&self, values: &[f64]) -> f64 {
        if values.len() < 2 { 0.0 } else { self.interpolation.highest(values) }
    }
}

impl Polynomial {
    pub fn at(&self, x: f64) -> f64 {
        let place = within(x, self.middle, self.half);
        self.coefficients.iter().rev().fold(0.0, |sum, coefficient| sum * place + coefficient)
    }
}

/// From −1 to 1.
fn within(x: f64, middle: f64, half: f64) -> f64 {
    if half == 0.0 { 0.0 } else { (x - middle) / half }
}
