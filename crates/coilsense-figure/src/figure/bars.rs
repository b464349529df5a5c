//! Horizontal bars with names.
//!
//! Next door: the room that they need (`crate::bars`), how they are drawn (`crate::bar_shapes`).

use crate::Colour;

/// Bars in rows from the top, their names at the left.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Bars {
    /// The bars, at least 1.
    pub bars: Vec<Bar>,
    /// What the second bars say, in the legend; an empty label makes no entry.
    pub second: String,
}

/// One bar, from zero (on a logarithmic axis, from its lower end) to its value.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Bar {
    /// Its name, wrapped where it is long.
    pub name: String,
    /// Where it ends, in the unit of the x axis; without a finite value there is no bar.
    pub value: f64,
    /// End of a thinner grey bar below it, such as the value with another setting.
    pub second: Option<f64>,
    /// Ends of a whisker, such as a coverage interval.
    pub interval: Option<(f64, f64)>,
    /// Written at its end, such as the value in digits; may be empty.
    pub text: String,
    /// What bars of its colour have in common, in the legend; an empty label makes no entry.
    pub group: String,
    /// Colour by name.
    pub colour: Colour,
}
