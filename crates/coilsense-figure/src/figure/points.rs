//! Points that are not joined, with error bars.
//!
//! What joins up is a `Curve`; what is seen from afar a `Band`. Next door: how they are drawn (`crate::points`).

use crate::Colour;

/// Points that are not joined.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Points {
    /// Their name in the legend; an empty label makes no entry.
    pub label: String,
    /// Abscissae, in the unit of the x axis.
    pub x: Vec<f64>,
    /// Ordinates, as many as `x`; what is not finite or out of range is not drawn.
    pub y: Vec<f64>,
    /// Half the length of each error bar, in the unit of the y axis; none, or as many as `x`.
    pub errors: Vec<f64>,
    /// What stands beside each point; none, or as many as `x`. A name that has no room on any side is left out, the first ones first served.
    pub names: Vec<String>,
    /// Colour by name.
    pub colour: Colour,
    /// What stands at each point.
    pub marker: Marker,
}

/// The shape of a point, for those who do not tell colours apart.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Marker {
    /// A disc.
    #[default]
    Disc,
    /// A square on its side.
    Square,
    /// A square on its corner.
    Diamond,
    /// A pale dot, one of thousands.
    Dot,
}

impl Points {
    /// The ends of its error bars, or the ordinates themselves.
    pub(crate) fn reach(&self) -> impl Iterator<Item = f64> + '_ {
        let error = |index: usize| self.errors.get(index).copied().filter(|error| error.is_finite()).unwrap_or(0.0);
        self.y.iter().enumerate().flat_map(move |(index, y)| [y - error(index), y + error(index)])
    }
}
