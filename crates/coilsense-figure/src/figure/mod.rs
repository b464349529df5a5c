//! What every figure is made of: [`Figure`], [`Panel`], [`Axis`], [`Curve`], [`Mark`], [`HorizontalMark`], and what else fills a panel.
//!
//! All of it is data. Next door: how lines look (`stroke`), what can be wrong with a figure (`check`, `error`), how it is drawn (`write`
//! and all that stands before it).

mod band;
mod bars;
mod heat;
mod points;

pub use band::Band;
pub use bars::{Bar, Bars};
pub use heat::{HeatMap, MarkedCells};
pub use points::{Marker, Points};

use crate::Stroke;

/// A figure: panels in rows of `columns`, and one legend above them all.
#[derive(Debug, Clone, PartialEq)]
pub struct Figure {
    /// The panels, row by row.
    pub panels: Vec<Panel>,
    /// Panels side by side, at least 1.
    pub columns: usize,
    /// Width of one panel with its labels \[px\]; the figure is `columns` times as wide.
    pub panel_width: f64,
    /// Height of one panel with its labels \[px\]; the legend comes on top.
    pub panel_height: f64,
}

/// One pair of axes and what is drawn on them; what a panel lacks is left at its default.
///
/// An axis label is drawn once where neighbours (left, or below) carry the same one.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Panel {
    /// Printed above the axes; may be empty.
    pub title: String,
    /// The horizontal axis.
    pub x: Axis,
    /// The vertical axis.
    pub y: Axis,
    /// Whether a unit is as long on the one axis as on the other, so that circles are round; both are linear then, and the one that has more
    /// room shows more than its range, equally much at both ends.
    pub equal_units: bool,
    /// The curves, the last one on top.
    pub curves: Vec<Curve>,
    /// Points that are not joined, with error bars, over all curves.
    pub points: Vec<Points>,
    /// Areas between two curves, behind all curves.
    pub bands: Vec<Band>,
    /// Vertical reference lines.
    pub marks: Vec<Mark>,
    /// Horizontal reference lines.
    pub limits: Vec<HorizontalMark>,
    /// A matrix in colour, behind everything else.
    pub heat: Option<HeatMap>,
    /// Bars along the x axis; the y axis then lists their names, and only marks go with them.
    pub bars: Option<Bars>,
}

/// What an axis measures, and how much of it is shown.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Axis {
    /// Quantity and unit, such as `Time [s]`.
    pub label: String,
    /// Lower and upper end; without it the axis fits what is drawn.
    pub range: Option<(f64, f64)>,
    /// Even in the value or in its logarithm.
    pub scale: Scale,
}

/// How values spread along an axis.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Scale {
    /// Equal steps are equally long.
    #[default]
    Linear,
    /// Equal ratios are equally long; values of zero or below break the curve.
    Log10,
}

/// One line of a panel.
#[derive(Debug, Clone, PartialEq)]
pub struct Curve {
    /// Its name in the legend; the same label and stroke in several panels make one entry,
    /// an empty label makes none.
    pub label: String,
    /// Abscissae, in the unit of the x axis.
    pub x: Vec<f64>,
    /// Ordinates, as many as `x`; a value that is not finite breaks the line.
    pub y: Vec<f64>,
    /// How the line looks.
    pub stroke: Stroke,
}

/// A thin vertical line with a label above the axes; not drawn where it lies out of range.
///
/// Crowded labels stand in up to three rows; what has no room even there keeps its line only.
#[derive(Debug, Clone, PartialEq)]
pub struct Mark {
    /// Where it stands, in the unit of the x axis.
    pub x: f64,
    /// What it says; may be empty.
    pub label: String,
}

/// A thin horizontal line with a label right of the axes, such as a limit to be kept.
///
/// A y axis that fits itself takes it in; out of a given range it is not drawn.
#[derive(Debug, Clone, PartialEq)]
pub struct HorizontalMark {
    /// Where it lies, in the unit of the y axis.
    pub y: f64,
    /// What it says; may be empty.
    pub label: String,
}
