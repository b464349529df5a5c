//! Figures for reports and papers: curves, bands, points, bars and colour maps, drawn as SVG or PNG.
//!
//! A [`Figure`] is data: panels, axes, and what is drawn on them, each a struct with named fields. It is laid out once as lines and
//! letters, and two small writers draw that, with letters that are compiled in: a machine without fonts makes the same picture.
//! No spring is known here, nor any quantity or unit: labels are the caller's.
//!
//! One pixel is 1/96 inch: 672 px fill a page of 7 inch, 336 px one column of a journal, and the
//! smallest letters then print at 8 pt (sub- and superscripts apart).
//!
//! Labels take `_` and `^` as in TeX (`F_o`, `10^{-3}`); `\_` is a plain underscore.
//!
//! ```
//! use coilsense_figure::{Axis, Colour, Curve, Dash, Figure, Panel, Stroke, Theme};
//!
//! let t: Vec<f64> = (0..500).map(|sample| 1e-4 * f64::from(sample)).collect();
//! let force = t.iter().map(|t| 96.0 + 2.0 * (340.0 * t).sin()).collect();
//! let panel = Panel {
//!     x: Axis { label: "Time [s]".into(), ..Axis::default() },
//!     y: Axis { label: "Force [N]".into(), ..Axis::default() },
//!     curves: vec![Curve {
//!         label: "F_o".into(),
//!         x: t,
//!         y: force,
//!         stroke: Stroke { colour: Colour::Red, dash: Dash::Solid, width: 1.4 },
//!     }],
//!     ..Panel::default()
//! };
//! let figure = Figure { panels: vec![panel], columns: 1, panel_width: 672.0, panel_height: 184.0 };
//! assert!(figure.to_svg(Theme::Light)?.starts_with("<svg"));
//! # Ok::<(), coilsense_figure::PlotError>(())
//! ```

// What a user can send must not end in a panic, and a library does not print.
#![cfg_attr(
    not(test),
    warn(clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::print_stdout, clippy::print_stderr)
)]

/// Colours, dashes and themes.
mod stroke;

/// The figure: panels, axes, curves, and what else fills a panel.
mod figure;

/// What must hold before it is drawn.
mod check;

/// A value to its share of an axis.
mod ruler;

/// An axis to its ticks and what stands there.
mod ticks;

/// Markup to letters, their width and their outlines.
mod lettering;

/// Sizes of letters, and the room around them.
mod sheet;

/// Dots of few colours to a picture file.
mod picture;

/// What both writers draw: lines, areas, pictures and letters.
mod drawing;

/// A panel with its place and its rulers.
mod scene;

/// Samples to short polylines.
mod trace;

/// Values to colours.
mod colour_map;

/// Cells of a matrix to dots of a picture.
mod resample;

/// Two curves to the area between them.
mod band;

/// Points and error bars to markers and lines.
mod points;

/// A matrix to its picture.
mod heat;

/// Labels of all panels to one legend.
mod legend;

/// What stands above a frame.
mod head;

/// What stands right of a frame.
mod beside;

/// Names and values to the room of bars.
mod bars;

/// Rulers and labels to the places of the frames.
mod grid;

/// Bars to shapes.
mod bar_shapes;

/// A scene to shapes.
mod panel;

/// A figure to its drawing.
mod layout;

/// A figure to a sentence, for those who do not see it.
mod words;

/// A polyline to an SVG path.
mod svg_path;

/// A drawing to SVG.
mod svg;

/// Letters to the painter's paths.
mod glyphs;

/// A drawing to PNG.
mod raster;

/// A figure to SVG or PNG: the way out.
mod write;

/// Why a figure could not be drawn.
mod error;

#[cfg(test)]
mod tests;

pub use error::PlotError;
pub use figure::{
    Axis, Band, Bar, Bars, Curve, Figure, HeatMap, HorizontalMark, Mark, MarkedCells, Marker, Panel, Points, Scale,
};
pub use raster::PNG_SCALE;
pub use stroke::{Colour, Dash, Stroke, Theme};
