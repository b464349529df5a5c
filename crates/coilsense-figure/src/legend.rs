//! One legend for the whole figure, above its panels, in as many rows as it takes.
//!
//! Where the panels go is `layout`'s matter.

use crate::band;
use crate::drawing::{Anchor, Frame, Pen, Shape, Text};
use crate::lettering::width;
use crate::{Colour, Figure, Marker, Panel, Stroke, Theme};

/// Height of one row \[px\].
const ROW: f64 = 18.0;
/// Length of the sample line: two periods of a dash-dot of 1.5 px \[px\].
const SAMPLE: f64 = 36.0;
/// Side of a sample block \[px\].
const BLOCK: f64 = 12.0;
/// From sample to label \[px\].
const GAP: f64 = 6.0;
/// From entry to entry \[px\].
const SPACE: f64 = 22.0;
/// Letter size \[px\].
const LETTERS: f64 = 12.0;

/// What stands before a label.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Sample {
    Line(Stroke),
    Band(Colour),
    Marker(Colour, Marker),
    Block(Colour),
    /// The grey of second bars.
    Second,
}

type Entry<'a> = (&'a str, Sample);

/// The entries of a figure, row by row.
pub(crate) struct Legend<'a> {
    rows: Vec<Vec<Entry<'a>>>,
}

impl<'a> Legend<'a> {
    /// Collects each label and sample once, in order, into rows of at most `room` \[px\].
    pub fn new(figure: &'a Figure, room: f64) -> Self {
        let mut entries: Vec<Entry> = Vec::new();
        for entry in figure.panels.iter().flat_map(named) {
            if !entry.0.is_empty() && !entries.contains(&entry) {
                entries.push(entry);
            }
        }
        let mut rows: Vec<Vec<Entry>> = Vec::new();
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
fn length(entries: &[Entry]) -> f64 {
    let sum: f64 = entries.iter().map(|(label, sample)| sample.width() + GAP + width(label, LETTERS) + SPACE).sum();
    sum - SPACE
}

/// All parts of a panel that may carry a name.
fn named(panel: &Panel) -> impl Iterator<Item = Entry<'_>> {
    let curves = panel.curves.iter().map(|curve| (curve.label.as_str(), Sample::Line(curve.stroke)));
    let bands = panel.bands.iter().map(|band| (band.label.as_str(), Sample::Band(band.colour)));
    let points = panel.points.iter();
    let points = points.map(|points| (points.label.as_str(), Sample::Marker(points.colour, points.marker)));
    let marked = panel.heat.iter().filter_map(|heat| heat.marked.as_ref());
    let marked = marked.map(|marked| (marked.label.as_str(), Sample::Block(Colour::Ink)));
    let bars = panel.bars.iter().flat_map(|bars| &bars.bars);
    let bars = bars.map(|bar| (bar.group.as_str(), Sample::Block(bar.colour)));
    let second = panel.bars.iter().map(|bars| (bars.second.as_str(), Sample::Second));
    curves.chain(bands).chain(points).chain(marked).chain(bars).chain(second)
}

impl Sample {
    fn width(self) -> f64 {
        match self {
            Self::Line(_) | Self::Band(_) => SAMPLE,
            Self::Block(_) | Self::Second | Self::Marker(..) => BLOCK,
        }
    }

    /// The sample, from `x` on, about a height of `y` \[px\].
    fn shape(self, [x, y]: [f64; 2], theme: Theme) -> Shape {
        let (ink, opacity) = match self {
            Self::Line(Stroke { colour, dash, width }) => {
                let pen = Pen { ink: theme.shade(colour), width, dashes: dash.lengths(width) };
                return Shape::Lines { runs: vec![vec![[x, y], [x + SAMPLE, y]]], pen };
            }
            Self::Marker(colour, marker) => {
                let outlines = vec![marker.outline([x + 0.5 * BLOCK, y])];
                return Shape::Area { outlines, ink: theme.shade(colour), opacity: marker.opacity() };
            }
            Self::Band(colour) => (theme.shade(colour), band::opacity(theme)),
            Self::Block(colour) => (theme.shade(colour), 1.0),
            Self::Second => (theme.mark(), 1.0),
        };
        let frame = Frame { left: x, top: y - 0.5 * BLOCK, width: self.width(), height: BLOCK };
        Shape::Area { outlines: vec![frame.corners()], ink, opacity }
    }
}

fn sample((label, sample): &Entry, [x, y]: [f64; 2], theme: Theme) -> [Shape; 2] {
    let text = Text {
        markup: (*label).to_owned(),
        at: [x + sample.width() + GAP, y + 0.36 * LETTERS],
        size: LETTERS,
        ink: theme.shade(Colour::Ink),
        anchor: Anchor::Start,
        upwards: false,
    };
    [sample.shape([x, y], theme), Shape::Text(text)]
}
