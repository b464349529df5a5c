//! What stands right of a frame: the labels of the horizontal marks, and the colour bar.
//!
//! What stands above is `head`'s matter; the cells that the bar explains, `heat`'s.

use crate::drawing::{Anchor, Frame, Pen, Point, Shape, Text};
use crate::heat::colour_bar;
use crate::lettering::{self, wrapped};
use crate::ruler::Ruler;
use crate::scene::Scene;
use crate::sheet::{EDGE, LETTERS, LINE, SMALL, TICK_ROOM};
use crate::ticks::ticks;
use crate::{Colour, HeatMap, Panel, PlotError};

/// Right of a frame: half of the last tick label \[px\].
pub(crate) const RIGHT: f64 = 16.0;
/// From the frame to a label of a horizontal mark, and to the colour bar \[px\].
const GAP: f64 = 6.0;
/// Width of a line of such a label, as far as its words allow \[px\].
const LABEL: f64 = 84.0;
/// Height of a line of such a label \[px\].
const LABEL_LINE: f64 = 13.0;
/// Width of a colour bar \[px\].
const BAR: f64 = 13.0;
/// Labels of a colour bar: few enough for the lowest frame, which is 40 px high.
const BAR_TICKS: usize = 5;

/// Room right of a frame \[px\].
pub(crate) fn width(panel: &Panel, y: &Ruler) -> Result<f64, PlotError> {
    let labels = labels_width(panel, y);
    let bar = panel.heat.as_ref().map(bar_width).transpose()?.unwrap_or(0.0);
    Ok(if labels + bar > 0.0 { labels + bar + EDGE } else { RIGHT }.max(RIGHT))
}

fn labels_width(panel: &Panel, y: &Ruler) -> f64 {
    let lines = shown(panel, y).flat_map(|(label, _)| wrapped(label, LABEL, SMALL));
    let widest = lines.map(|line| lettering::width(&line, SMALL)).fold(0.0, f64::max);
    if widest > 0.0 { GAP + widest } else { 0.0 }
}

fn bar_width(heat: &HeatMap) -> Result<f64, PlotError> {
    let labels = ticks(&heat.scale()?.0, BAR_TICKS).major;
    let widest = labels.iter().map(|(_, label)| lettering::width(label, SMALL)).fold(0.0, f64::max);
    let label = if heat.label.is_empty() { 0.0 } else { LINE };
    Ok(2.0 * GAP + BAR + TICK_ROOM + widest + label)
}

/// Labels of the horizontal marks in range, and their shares of the axis.
fn shown<'a>(panel: &'a Panel, y: &Ruler) -> impl Iterator<Item = (&'a str, f64)> {
    let all = panel.limits.iter().map(|limit| (limit.label.as_str(), y.share(limit.y)));
    all.filter(|(_, share)| Ruler::holds(*share))
}

/// The lines of the horizontal marks, over the curves: a limit must be seen.
pub(crate) fn limit_lines(scene: &Scene) -> Option<Shape> {
    let lines = shown(scene.panel, &scene.rulers[1]);
    let runs: Vec<Vec<Point>> =
        lines.map(|(_, share)| [0.0, 1.0].map(|across| scene.frame.at(across, share)).to_vec()).collect();
    let pen = Pen { ink: scene.theme.shade(Colour::Ink), ..Pen::reference(scene.theme) };
    (!runs.is_empty()).then_some(Shape::Lines { runs, pen })
}

/// The labels of the horizontal marks, each as near to its line as its neighbours allow.
pub(crate) fn limit_letters(scene: &Scene, shapes: &mut Vec<Shape>) {
    let mut labels: Vec<(Vec<String>, f64)> = shown(scene.panel, &scene.rulers[1])
        .map(|(label, share)| (wrapped(label, LABEL, SMALL), scene.frame.at(1.0, share)[1]))
        .filter(|(lines, _)| !lines.is_empty())
        .collect();
    labels.sort_by(|a, b| a.1.total_cmp(&b.1));
    let wishes: Vec<[f64; 2]> =
        labels.iter().map(|(lines, middle)| [*middle, LABEL_LINE * lines.len() as f64]).collect();
    for ((lines, _), top) in labels.iter().zip(tops(&wishes)) {
        for (index, line) in lines.iter().enumerate() {
            let baseline = top + LABEL_LINE * (index as f64 + 0.5) + 0.36 * SMALL;
            shapes.push(Shape::Text(scene.text(line, [scene.frame.right() + GAP, baseline], SMALL, Anchor::Start)));
        }
    }
}

/// Tops of blocks wished about a middle and of a height \[px\], from the highest: those that would
/// overlap are stacked about the mean of what they wish.
fn tops(wishes: &[[f64; 2]]) -> Vec<f64> {
    // Of each stack: its top, its blocks.
    let mut stacks: Vec<(f64, &[[f64; 2]])> = Vec::new();
    for index in 0..wishes.len() {
        let mut first = index;
        loop {
            let blocks = &wishes[first..=index];
            let mut above = 0.0;
            let mut sum = 0.0;
            for [middle, height] in blocks {
                sum += middle - 0.5 * height - above;
                above += height;
            }
            let top = sum / blocks.len() as f64;
            let foot = |(top, blocks): &(f64, &[[f64; 2]])| top + blocks.iter().map(|block| block[1]).sum::<f64>();
            match stacks.pop_if(|stack| foot(stack) > top) {
                Some((_, joined)) => first -= joined.len(),
                None => {
                    stacks.push((top, blocks));
                    break;
                }
            }
        }
    }
    let placed = stacks.into_iter().flat_map(|(top, blocks)| {
        blocks.iter().scan(top, |next, [_, height]| {
            let here = *next;
            *next += height;
            Some(here)
        })
    });
    placed.collect()
}

/// The colour bar with its ticks and label, as high as the frame.
pub(crate) fn bar(scene: &Scene, heat: &HeatMap, shapes: &mut Vec<Shape>) -> Result<(), PlotError> {
    let (ruler, kind) = heat.scale()?;
    let left = scene.frame.right() + (labels_width(scene.panel, &scene.rulers[1]) + 2.0 * GAP).floor();
    let frame = Frame { left, width: BAR, ..scene.frame };
    shapes.push(Shape::Picture { picture: colour_bar(kind, scene.theme), frame });
    let found = ticks(&ruler, BAR_TICKS);
    let mut runs = vec![frame.corners(), frame.corners()[..2].to_vec()];
    runs[0].extend(frame.corners().first().copied());
    for (share, label) in &found.major {
        let [x, y] = frame.at(1.0, *share);
        runs.push(vec![[x, y], [x + 4.5, y]]);
        shapes.push(Shape::Text(scene.text(label, [x + TICK_ROOM, y + 0.36 * SMALL], SMALL, Anchor::Start)));
    }
    let pen = Pen { ink: scene.theme.shade(Colour::Ink), width: 1.0, dashes: Vec::new() };
    shapes.push(Shape::Lines { runs, pen });
    if !heat.label.is_empty() {
        let at = [scene.frame.right() + scene.right_room - EDGE - 0.25 * LETTERS, frame.at(0.0, 0.5)[1]];
        let label = scene.text(&heat.label, at, LETTERS, Anchor::Middle);
        shapes.push(Shape::Text(Text { upwards: true, ..label }));
    }
    Ok(())
}
