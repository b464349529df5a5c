//! Why a figure could not be drawn.
//!
//! Holds [`PlotError`] alone; the checks themselves sit where the values are first used.

use thiserror::Error;

/// A figure that cannot be drawn.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum PlotError {
    /// There is nothing to draw, or no place to put it.
    #[error("a figure needs at least one panel and one column, got {panels} panels in {columns} columns")]
    Empty {
        /// Number of panels.
        panels: usize,
        /// Number of columns.
        columns: usize,
    },
    /// A curve's abscissae and ordinates do not pair up.
    #[error("curve `{label}` needs as many x as y values, got {x} and {y}")]
    Lengths {
        /// Label of the curve.
        label: String,
        /// Number of abscissae.
        x: usize,
        /// Number of ordinates.
        y: usize,
    },
    /// A band's series do not go together.
    #[error("band `{label}` needs as many x as lower and upper values, got {x}, {lower} and {upper}")]
    BandLengths {
        /// Label of the band.
        label: String,
        /// Number of abscissae.
        x: usize,
        /// Number of lower ends.
        lower: usize,
        /// Number of upper ends.
        upper: usize,
    },
    /// Points' series do not go together.
    #[error("points `{label}` need as many x as y values and no error bars or as many, got {x}, {y} and {errors}")]
    PointLengths {
        /// Label of the points.
        label: String,
        /// Number of abscissae.
        x: usize,
        /// Number of ordinates.
        y: usize,
        /// Number of error bars.
        errors: usize,
    },
    /// A colour map's values do not fill its rows, or there are none.
    #[error("colour map `{label}` needs values that fill its rows evenly, got {values} in {rows} rows")]
    Cells {
        /// Label of the colour map.
        label: String,
        /// Number of rows.
        rows: usize,
        /// Number of values.
        values: usize,
    },
    /// A colour map's marked cells are not those of its values.
    #[error("marked cells `{label}` must be as many as the values, {values}, got {cells}")]
    MarkedCells {
        /// Label of the marked cells.
        label: String,
        /// Number of values.
        values: usize,
        /// Number of marks.
        cells: usize,
    },
    /// A panel is to hold bars and there are none.
    #[error("bars of `{label}` must be at least one, got none")]
    NoBars {
        /// Label of the value axis.
        label: String,
    },
    /// Bars share a panel with what needs a y axis of numbers.
    #[error("bars of `{label}` leave no y axis for curves, bands, horizontal marks or a colour map")]
    BarsNotAlone {
        /// Label of the value axis.
        label: String,
    },
    /// Bars and their names would run into each other.
    #[error("bars of `{label}` need axes {needed:.0} px high, got {height:.0} px")]
    BarRoom {
        /// Label of the value axis.
        label: String,
        /// Height that they need \[px\].
        needed: f64,
        /// Height left for the axes \[px\].
        height: f64,
    },
    /// Points have names, but not one each.
    #[error("points `{label}` need no names or one each, got {names} for {x} points")]
    PointNames {
        /// Label of the points.
        label: String,
        /// How many points there are.
        x: usize,
        /// How many names.
        names: usize,
    },
    /// A line has no width.
    #[error("line width of curve `{label}` must be above zero, got {width} px")]
    Width {
        /// Label of the curve.
        label: String,
        /// Width asked for \[px\].
        width: f64,
    },
    /// An axis range is not finite, or does not rise by more than rounding.
    #[error("range of axis `{label}` must be finite and rise by more than rounding, got {lower} to {upper}")]
    Range {
        /// Label of the axis.
        label: String,
        /// Lower end.
        lower: f64,
        /// Upper end.
        upper: f64,
    },
    /// A logarithmic axis reaches zero or below.
    #[error("range of logarithmic axis `{label}` must be above zero, got {lower} to {upper}")]
    LogRange {
        /// Label of the axis.
        label: String,
        /// Lower end.
        lower: f64,
        /// Upper end.
        upper: f64,
    },
    /// An axis has neither a range nor a value to fit.
    #[error("axis `{label}` has no range and no finite value to fit (above zero, if logarithmic)")]
    NoData {
        /// Label of the axis.
        label: String,
    },
    /// The panels leave no room for the axes, or exceed what can be painted.
    #[error("axes must be 40 to 20000 px wide and high, got {width:.0} px by {height:.0} px")]
    Size {
        /// Width left for the axes \[px\].
        width: f64,
        /// Height left for the axes \[px\].
        height: f64,
    },
    /// The image could not be painted or encoded.
    #[error("the PNG could not be made: {0}")]
    Png(String),
}
