//! A matrix in colour.
//!
//! Next door: how it is drawn (`crate::heat`).

/// A matrix of values, each a cell of colour, with a colour bar beside it.
///
/// Values of both signs are coloured from blue over the ground's shade, at zero, to orange;
/// others from little to much. Where several cells share a dot, the one farthest from zero is
/// shown. What is not finite is grey.
#[derive(Debug, Clone, PartialEq)]
pub struct HeatMap {
    /// Quantity and unit, written at the colour bar.
    pub label: String,
    /// Number of rows, at least 1.
    pub rows: usize,
    /// Values, `rows × columns`, row by row, the lowest row on the y axis first.
    pub values: Vec<f64>,
    /// Outer edges of the first and the last column, in the unit of the x axis.
    pub x: (f64, f64),
    /// Outer edges of the first and the last row, in the unit of the y axis.
    pub y: (f64, f64),
    /// Values at the ends of the colour bar; without it they fit the data. Where they differ in
    /// sign, zero is put in the middle.
    pub range: Option<(f64, f64)>,
    /// Whether colours run from cell to cell instead of changing at their edges.
    pub smooth: bool,
    /// Cells to be marked, over their colour.
    pub marked: Option<MarkedCells>,
}

/// Cells drawn in black (on dark ground white), such as those where windings touch.
#[derive(Debug, Clone, PartialEq)]
pub struct MarkedCells {
    /// Its name in the legend; an empty label makes no entry.
    pub label: String,
    /// For each value whether it is marked.
    pub cells: Vec<bool>,
}
