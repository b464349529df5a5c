//! What one panel is drawn from: the panel, its place and its rulers.
//!
//! Next door: who fills it in (`layout`), who draws it (`panel`, `head`, `beside`).

use crate::drawing::{Anchor, Frame, Point, Text};
use crate::ruler::Ruler;
use crate::{Colour, Panel, Theme};

/// A panel with all that `layout` settled for it.
pub(crate) struct Scene<'a> {
    pub panel: &'a Panel,
    /// Width of the panel with its margins \[px\].
    pub panel_width: f64,
    pub frame: Frame,
    /// Of x and y.
    pub rulers: [Ruler; 2],
    /// The most labels on the y axis.
    pub y_ticks: usize,
    pub x_label: bool,
    pub y_label: bool,
    /// Room left of the frame \[px\].
    pub y_room: f64,
    /// Room right of the frame \[px\].
    pub right_room: f64,
    pub theme: Theme,
}

impl Scene<'_> {
    /// A line of text in the theme's ink.
    pub fn text(&self, markup: &str, at: Point, size: f64, anchor: Anchor) -> Text {
        let ink = self.theme.shade(Colour::Ink);
        Text { markup: markup.to_owned(), at, size, ink, anchor, upwards: false }
    }
}
