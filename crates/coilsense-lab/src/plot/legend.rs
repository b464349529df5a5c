//! One legend for the whole figure, above its panels, in as many rows as it takes.
//!
//! Where the panels go is `layout`'s matter.

use super::drawing::{Anchor, Pen, Shape, Text};
use super::lettering::width;
use super::{Colour, Figure, Stroke, Theme};

/// Height of one row \[px\].
const ROW: f64 = 18.0;
/// Length of the sample line: two periods of a dash-dot of 1.5 px \[px\].
const SAMPLE: f64 = 36.0;
/// From sample to label \[px\].
const GAP: f64 = 6.0;
/// From entry to entry \[px\].
const SPACE: f64 = 22.0;
/// Letter size \[px\].
const LETTERS: f64 = 12.0;

/// The entries of a figure, row by row.
pub(super) struct Legend<'a> {
    rows: Vec<Vec<(&'a str, Stroke)>>,
}

impl<'a> Legend<'a> {
    /// Collects each label and stroke once, in order, into rows of at most `room` \[px\].
    pub fn new(figure: &'a Figure, room: f64) -> Self {
        let mut entries: Vec<(&str, Stroke)> = Vec::new();
        for curve in figure.panels.iter().flat_map(|panel| &panel.curves) {
            let entry = (curve.label.as_str(), curve.stroke);
            if !entry.0.is_empty() && !entries.contains(&entry) {
                entries.push(entry);
            }
        }
        let mut rows: Vec<Vec<(&str, Stroke)>> = Vec::new();
        for entry in entries {
            match rows.last_mut() {
                Some(row) if length(row) + SPACE + length(&[entry]) <= room => row.push(entry),
                _ => rows.push(vec![entry]),
            }
        }
        Self { rows }
    }

    /// Height of all rows with the space below \[px\].
    pub fn height(&self) -> f64 {
        if self.rows.is_empty() { 0.0 } else { ROW * self.rows.len() as f64 + 8.0 }
    }

    /// Length of the longest row \[px\].
    pub fn width(&self) -> f64 {
        self.rows.iter().map(|row| length(row)).fold(0.0, f64::max)
    }

    /// The rows, each centred about `middle` \[px\], from the top of the figure.
    pub fn shapes(&self, middle: f64, theme: Theme) -> Vec<Shape> {
        let mut shapes = Vec::new();
        for (index, row) in self.rows.iter().enumerate() {
            let y = 6.0 + ROW * (index as f64 + 0.5);
            let mut x = middle - 0.5 * length(row);
            for entry in row {
                shapes.extend(sample(entry, [x, y], theme));
                x += length(&[*entry]) + SPACE;
            }
        }
        shapes
    }
}

/// Length of entries side by side \[px\].
fn length(entries: &[(&str, Stroke)]) -> f64 {
    let sum: f64 = entries.iter().map(|(label, _)| SAMPLE + GAP + width(label, LETTERS) + SPACE).sum();
    sum - SPACE
}

fn sample((label, stroke): &(&str, Stroke), [x, y]: [f64; 2], theme: Theme) -> [Shape; 2] {
    let line = vec![[x, y], [x + SAMPLE, y]];
    let pen = Pen { ink: theme.shade(stroke.colour), width: stroke.width, dashes: stroke.dash.lengths(stroke.width) };
    let text = Text {
        markup: (*label).to_owned(),
        at: [x + SAMPLE + GAP, y + 0.36 * LETTERS],
        size: LETTERS,
        ink: theme.shade(Colour::Ink),
        anchor: Anchor::Start,
        upwards: false,
    };
    [Shape::Lines { runs: vec![line], pen }, Shape::Text(text)]
}
