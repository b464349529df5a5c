//! Sizes of letters and the room around them, the same all over a sheet.
//!
//! Next door: what goes where (`layout`, `grid`).

/// Letter size of tick labels and marks: 8.25 pt \[px\].
pub(crate) const SMALL: f64 = 11.0;
/// Letter size of axis labels and titles: 9 pt \[px\].
pub(crate) const LETTERS: f64 = 12.0;
/// Height of a line of text \[px\].
pub(crate) const LINE: f64 = 16.0;
/// From the frame to the tick labels, past the ticks \[px\].
pub(crate) const TICK_ROOM: f64 = 8.0;
/// Above titles, and below the lowest label \[px\].
pub(crate) const EDGE: f64 = 8.0;
