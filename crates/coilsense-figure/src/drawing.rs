//! A figure reduced to what both writers draw: lines, areas, pictures and letters, in pixels.
//!
//! `layout` fills a [`Drawing`](crate::drawing::Drawing); `svg` and `raster` write it.

use crate::Theme;
use crate::picture::Picture;
use crate::stroke::Rgb;

/// A point \[px\], y counted downwards from the top left corner.
pub(crate) type Point = [f64; 2];

/// Everything on one sheet, in the order it is drawn.
pub(crate) struct Drawing {
    pub width: f64,
    pub height: f64,
    pub paper: Rgb,
    pub shapes: Vec<Shape>,
}

/// One thing to draw.
pub(crate) enum Shape {
    /// Polylines of one pen; each inner list is one unbroken run.
    Lines { runs: Vec<Vec<Point>>, pen: Pen },
    /// Closed outlines, filled; what lies beneath shows through an opacity below 1.
    Area { outlines: Vec<Vec<Point>>, ink: Rgb, opacity: f64 },
    /// A picture, stretched over a frame.
    Picture { picture: Picture, frame: Frame },
    /// One line of text.
    Text(Text),
}

/// How lines are drawn.
pub(crate) struct Pen {
    pub ink: Rgb,
    pub width: f64,
    /// Lengths of line and gap in turn \[px\]; empty for a solid line.
    pub dashes: Vec<f64>,
}

impl Pen {
    /// The pen of reference lines, thinner than any curve.
    pub fn reference(theme: Theme) -> Self {
        Self { ink: theme.mark(), width: 0.9, dashes: vec![2.5, 2.5] }
    }
}

/// A line of text, with its markup.
pub(crate) struct Text {
    pub markup: String,
    /// Where the baseline meets the anchor.
    pub at: Point,
    /// Letter size \[px\].
    pub size: f64,
    pub ink: Rgb,
    pub anchor: Anchor,
    /// Whether it reads from bottom to top.
    pub upwards: bool,
}

/// Which part of a text stands at its point.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Anchor {
    Start,
    Middle,
    End,
}

/// A rectangle \[px\].
#[derive(Debug, Clone, Copy)]
pub(crate) struct Frame {
    pub left: f64,
    pub top: f64,
    pub width: f64,
    pub height: f64,
}

impl Frame {
    pub fn right(&self) -> f64 {
        self.left + self.width
    }

    pub fn bottom(&self) -> f64 {
        self.top + self.height
    }

    /// Its corners, in a round.
    pub fn corners(&self) -> Vec<Point> {
        [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]].map(|[across, up]| self.at(across, up)).to_vec()
    }

    /// The point at a share (0 to 1) of the width from the left and of the height from below.
    pub fn at(&self, across: f64, up: f64) -> Point {
        [self.left + across * self.width, self.bottom() - up * self.height]
    }
}
