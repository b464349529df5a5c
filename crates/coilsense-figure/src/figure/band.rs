//! An area between two curves.
//!
//! Next door: how it is drawn (`crate::band`).

use crate::Colour;

/// A filled area between a lower and an upper curve.
#[derive(Debug, Clone, PartialEq)]
pub struct Band {
    /// Its name in the legend; an empty label makes no entry.
    pub label: String,
    /// Abscissae, in the unit of the x axis.
    pub x: Vec<f64>,
    /// One edge, as many values as `x`; a value that is not finite breaks the band. On a
    /// logarithmic axis, what is zero or below reaches the foot of the axes.
    pub lower: Vec<f64>,
    /// The other edge, likewise.
    pub upper: Vec<f64>,
    /// Colour by name, drawn translucent.
    pub colour: Colour,
}
