//! The room of horizontal bars with names, such as an uncertainty budget or a ranking of sensors.
//!
//! Bars stand on the panel's x axis and take the place of its y axis: this file says how much
//! room they need, `bar_shapes` how they are drawn.

use crate::beside::RIGHT;
use crate::lettering::{width, wrapped};
use crate::ruler::Ruler;
use crate::sheet::{EDGE, LINE, SMALL};
use crate::{Axis, Bar, Bars, Figure, Panel, PlotError, Scale};

/// Share of a panel's width that names may take before they are wrapped.
const NAMES: f64 = 0.38;
/// From the names to the frame \[px\].
pub(crate) const NAME_GAP: f64 = 7.0;
/// Height of one line of a name \[px\].
pub(crate) const NAME_LINE: f64 = 13.0;
/// Between the names of neighbouring bars, at least \[px\].
const NAME_SPACE: f64 = 5.0;
/// From a bar to its text, and from there to the frame \[px\].
pub(crate) const TEXT_GAP: f64 = 5.0;
/// Height of a bar's row where there is room for it \[px\].
const ROW: f64 = 24.0;

impl Bars {
    /// Height of a panel \[px\] of a width \[px\] in which all bars have their room, under a title
    /// and a row of mark labels of one line each.
    pub fn panel_height(&self, panel_width: f64) -> f64 {
        // Title, mark labels, tick labels and axis label, one line each, and the edges.
        rows(self, panel_width, ROW).sum::<f64>() + 5.0 * LINE + 2.0 * EDGE
    }

    /// What a bar reaches, whiskers and the second bar included.
    fn ends(bar: &Bar) -> impl Iterator<Item = f64> {
        let interval = bar.interval.into_iter().flat_map(|(lower, upper)| [lower, upper]);
        [bar.value].into_iter().chain(bar.second).chain(interval).filter(|end| end.is_finite())
    }
}

/// The lines of a bar's name.
pub(crate) fn name_lines(bar: &Bar, panel_width: f64) -> Vec<String> {
    wrapped(&bar.name, NAMES * panel_width, SMALL)
}

/// Room for the names with the space behind them \[px\].
pub(crate) fn names_room(bars: &Bars, panel_width: f64) -> f64 {
    let lines = bars.bars.iter().flat_map(|bar| name_lines(bar, panel_width));
    lines.map(|line| width(&line, SMALL)).fold(0.0, f64::max) + NAME_GAP
}

/// Room for the label of the y axis, where it has one \[px\].
pub(crate) fn axis_room(panel: &Panel) -> f64 {
    if panel.y.label.is_empty() { 0.0 } else { LINE + 4.0 }
}

/// Height of each bar's row: what its name takes, and `least` at least \[px\].
fn rows(bars: &Bars, panel_width: f64, least: f64) -> impl Iterator<Item = f64> {
    let lines = bars.bars.iter().map(move |bar| name_lines(bar, panel_width).len());
    lines.map(move |lines| (NAME_LINE * lines as f64 + NAME_SPACE).max(least))
}

/// Heights of the rows in axes of a height \[px\]: equal as far as long names allow.
pub(crate) fn row_heights(bars: &Bars, panel_width: f64, height: f64) -> Vec<f64> {
    let fill = |least: f64| rows(bars, panel_width, least).sum::<f64>();
    let (mut low, mut high) = (0.0, height);
    // Halved until no eye could tell: 2^-20 of the height.
    for _ in 0..20 {
        let middle = 0.5 * (low + high);
        if fill(middle) > height { high = middle } else { low = middle }
    }
    rows(bars, panel_width, low).collect()
}

/// Refuses axes too low for the names of their bars.
pub(crate) fn check_room(figure: &Figure, height: f64) -> Result<(), PlotError> {
    for panel in &figure.panels {
        let needed: f64 = panel.bars.iter().flat_map(|bars| rows(bars, figure.panel_width, 0.0)).sum();
        if needed > height {
            return Err(PlotError::BarRoom { label: panel.x.label.clone(), needed, height });
        }
    }
    Ok(())
}

/// The rulers of a panel of bars: values across, rows counted upwards from 0.
pub(crate) fn rulers(panel: &Panel, bars: &Bars, panel_width: f64) -> Result<[Ruler; 2], PlotError> {
    let from_zero = (panel.x.scale == Scale::Linear).then_some(0.0);
    let marks = panel.marks.iter().map(|mark| mark.x);
    let ends = bars.bars.iter().flat_map(Bars::ends).chain(marks).chain(from_zero);
    let mut x = Ruler::new(&panel.x, ends, 0.0)?;
    if panel.x.range.is_none() {
        let room = panel_width - EDGE - axis_room(panel) - names_room(bars, panel_width) - RIGHT;
        widen(&mut x, bars, room.max(40.0));
    }
    let rows = Axis { range: Some((0.0, bars.bars.len() as f64)), ..panel.y.clone() };
    let rows = Axis { scale: Scale::Linear, ..rows };
    Ok([x, Ruler::new(&rows, std::iter::empty(), 0.0)?])
}

/// Adds the room that texts at the bars' ends take in a frame `room` \[px\] wide.
fn widen(x: &mut Ruler, bars: &Bars, room: f64) {
    let widest = |falling: bool| {
        let texts = bars.bars.iter().filter(|bar| (bar.value < 0.0) == falling && !bar.text.is_empty());
        texts.map(|bar| width(&bar.text, SMALL) + 2.0 * TEXT_GAP).fold(0.0, f64::max)
    };
    let above = widest(false).max(0.04 * room);
    let below = if x.scale == Scale::Log10 { 0.04 * room } else { widest(true) };
    let unit = (x.upper - x.lower) / (room - above - below).max(0.3 * room);
    x.upper += unit * above;
    x.lower -= unit * below;
}
