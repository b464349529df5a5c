//! Where the frames of a figure lie, and which of them carry axis labels.
//!
//! Margins come from what stands in them, so that all frames are equally large and aligned.
//! What is drawn in and around a frame is said in `panel` and `head`.

use crate::drawing::Frame;
use crate::lettering::width;
use crate::ruler::Ruler;
use crate::sheet::{EDGE, LINE, SMALL, TICK_ROOM};
use crate::ticks::ticks;
use crate::{Axis, Figure, Panel, PlotError};
use crate::{bars, beside, head};

/// The frames of all panels, equally large.
pub(crate) struct Grid {
    /// Room left of the frames, by column \[px\].
    pub left: Vec<f64>,
    /// Room right of the frames, by column \[px\].
    pub right: Vec<f64>,
    /// Room above the frames, by row \[px\].
    above: Vec<f64>,
    /// Room below the frames, by row \[px\].
    below: Vec<f64>,
    /// Where the panels begin, below the legend \[px\].
    top: f64,
    frame: [f64; 2],
}

impl Grid {
    /// Divides the sheet below `top` \[px\] among the panels, whose x and y rulers are given.
    pub fn new(figure: &Figure, rulers: &[[Ruler; 2]], top: f64) -> Result<Self, PlotError> {
        let columns = figure.columns.min(figure.panels.len());
        let rows = figure.panels.len().div_ceil(columns);
        let (across, down) = (vec![0.0; columns], vec![0.0; rows]);
        let mut grid =
            Self { left: across.clone(), right: across, above: down.clone(), below: down, top, frame: [0.0; 2] };
        let widen = |room: &mut f64, need: f64| *room = room.max(need);
        for (index, (panel, ruler)) in figure.panels.iter().zip(rulers).enumerate() {
            widen(&mut grid.left[index % columns], room_left(figure, index, &ruler[1]));
            widen(&mut grid.right[index % columns], beside::width(panel, &ruler[1])?);
        }
        let margins: f64 = grid.left.iter().chain(&grid.right).sum();
        let across = columns as f64 * figure.panel_width - margins;
        grid.frame[0] = (across / columns as f64).floor();
        for (index, (panel, ruler)) in figure.panels.iter().zip(rulers).enumerate() {
            let label = if shows_x_label(figure, index) { LINE } else { 0.0 };
            widen(&mut grid.below[index / columns], TICK_ROOM + LINE + label + EDGE);
            let head = head::height(panel, &ruler[0], grid.frame[0]);
            widen(&mut grid.above[index / columns], head + EDGE);
        }
        let rooms: f64 = grid.above.iter().chain(&grid.below).sum();
        grid.frame[1] = ((rows as f64 * figure.panel_height - rooms) / rows as f64).floor();
        let drawable = |side: &f64| (40.0..=20_000.0).contains(side);
        if grid.frame.iter().all(drawable) {
            return bars::check_room(figure, grid.frame[1]).map(|()| grid);
        }
        Err(PlotError::Size { width: grid.frame[0], height: grid.frame[1] })
    }

    pub fn rows(&self) -> usize {
        self.above.len()
    }

    /// The frame of a panel, on half pixels, where its lines come out sharp.
    pub fn frame(&self, index: usize) -> Frame {
        let (column, row) = (index % self.left.len(), index / self.left.len());
        let [width, height] = self.frame;
        let margins: f64 = self.left[..=column].iter().chain(&self.right[..column]).sum();
        let left = margins + column as f64 * width;
        let passed: f64 = self.above[..=row].iter().chain(&self.below[..row]).sum();
        let top = self.top + passed + row as f64 * height;
        Frame { left: left.floor() + 0.5, top: top.floor() + 0.5, width, height }
    }
}

/// Room for tick labels and, where shown, the axis label.
fn room_left(figure: &Figure, index: usize, y: &Ruler) -> f64 {
    let panel = &figure.panels[index];
    if let Some(bars) = &panel.bars {
        return EDGE + bars::names_room(bars, figure.panel_width) + bars::axis_room(panel);
    }
    let labels = ticks(y, most_y_ticks(figure)).major;
    let widest = labels.iter().map(|(_, label)| width(label, SMALL)).fold(0.0, f64::max);
    let label = if shows_y_label(figure, index) { LINE + 4.0 } else { 0.0 };
    EDGE + label + widest + TICK_ROOM
}

/// A tick label for each 24 px of a panel leaves a blank line between labels.
pub(crate) fn most_y_ticks(figure: &Figure) -> usize {
    (figure.panel_height / 24.0).clamp(2.0, 8.0) as usize
}

/// The label of an x axis is dropped where the panel below says the same.
pub(crate) fn shows_x_label(figure: &Figure, index: usize) -> bool {
    let said = |below: &Panel| same(&below.x, &figure.panels[index].x);
    !figure.panels.get(index.saturating_add(figure.columns)).is_some_and(said)
}

/// The label of a y axis is dropped where the panel to the left says the same.
pub(crate) fn shows_y_label(figure: &Figure, index: usize) -> bool {
    index.is_multiple_of(figure.columns) || !same(&figure.panels[index - 1].y, &figure.panels[index].y)
}

fn same(a: &Axis, b: &Axis) -> bool {
    a.label == b.label && a.scale == b.scale
}
