//! The letters of a text as one path for the painter.
//!
//! The outlines come from `lettering`; `raster` paints them.

use tiny_skia::{Path, PathBuilder};
use ttf_parser::OutlineBuilder;

use crate::lettering::outline;

/// The outlines of a text of letter size 1, y upwards.
pub(crate) fn glyphs(markup: &str) -> Option<Path> {
    let mut pen = GlyphPen { path: PathBuilder::new(), at: [0.0; 2], unit: 1.0 };
    outline(markup, &mut pen, |pen, at, unit| {
        (pen.at, pen.unit) = (at.map(|v| v as f32), unit as f32);
    });
    pen.path.finish()
}

/// Carries a font's outlines over to the painter's path.
struct GlyphPen {
    path: PathBuilder,
    at: [f32; 2],
    unit: f32,
}

impl GlyphPen {
    fn x(&self, x: f32) -> f32 {
        self.at[0] + self.unit * x
    }

    fn y(&self, y: f32) -> f32 {
        self.at[1] + self.unit * y
    }
}

impl OutlineBuilder for GlyphPen {
    fn move_to(&mut self, x: f32, y: f32) {
        self.path.move_to(self.x(x), self.y(y));
    }

    fn line_to(&mut self, x: f32, y: f32) {
        self.path.line_to(self.x(x), self.y(y));
    }

    fn quad_to(&mut self, x1: f32, y1: f32, x: f32, y: f32) {
        self.path.quad_to(self.x(x1), self.y(y1), self.x(x), self.y(y));
    }

    fn curve_to(&mut self, x1: f32, y1: f32, x2: f32, y2: f32, x: f32, y: f32) {
        let (x1, y1, x2, y2) = (self.x(x1), self.y(y1), self.x(x2), self.y(y2));
        self.path.cubic_to(x1, y1, x2, y2, self.x(x), self.y(y));
    }

    fn close(&mut self) {
        self.path.close();
    }
}
