//! A figure written: as SVG or as PNG, both from the same drawing.
//!
//! Next door: what the drawing holds (`layout`), the two writers (`svg`, `raster`).

use crate::{Figure, PlotError, Theme, layout, raster, svg, words};

impl Figure {
    /// Draws the figure as an SVG element, which may stand alone or inside HTML.
    ///
    /// It scales with its container, carries its own description for screen readers, and holds
    /// no ids, so that many can share one page.
    ///
    /// # Errors
    /// [`PlotError`] when the figure is empty or too small, a part's series differ in length, a
    /// line has no width, bars are not alone, or an axis range or a picture cannot be drawn.
    pub fn to_svg(&self, theme: Theme) -> Result<String, PlotError> {
        let drawing = layout::draw(self, theme)?;
        svg::write(&drawing, &words::of(self))
    }

    /// Draws the figure as a PNG with [`PNG_SCALE`](crate::PNG_SCALE) dots per pixel, lettered in DejaVu Sans
    /// Condensed from within the program, on white (or the dark theme's ground).
    ///
    /// # Errors
    /// As [`Figure::to_svg`], and [`PlotError::Png`] when the image cannot be made.
    pub fn to_png(&self, theme: Theme) -> Result<Vec<u8>, PlotError> {
        raster::write(&layout::draw(self, theme)?)
    }
}
