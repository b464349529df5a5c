//! Draws one panel into its frame: grid, curves, axes and their labels, and has the rest drawn.
//!
//! Where the frame lies is `layout`'s matter; title and marks are `head`'s,
//! what stands right of the frame `beside`'s.

use crate::drawing::{Anchor, Pen, Point, Shape, Text};
use crate::lettering::width;
use crate::ruler::Ruler;
use crate::scene::Scene;
use crate::sheet::{EDGE, LETTERS, LINE, SMALL, TICK_ROOM};
use crate::ticks::{Ticks, ticks};
use crate::trace::runs;
use crate::{Colour, PlotError, Scale, band, bar_shapes, beside, head, points};

/// Length of a labelled tick, outwards \[px\].
const TICK: f64 = 4.5;
/// Length of a bare tick \[px\].
const MINOR_TICK: f64 = 2.5;
/// Least room between two tick labels \[px\].
const LABEL_GAP: f64 = 14.0;

/// Draws everything of a panel, from the back to the front.
pub(crate) fn draw(scene: &Scene, shapes: &mut Vec<Shape>) -> Result<(), PlotError> {
    let (panel, [x, y]) = (scene.panel, &scene.rulers);
    let x = fitting_ticks(x, scene.frame.width);
    let y = if panel.bars.is_some() { Ticks::default() } else { ticks(y, scene.y_ticks) };
    shapes.push(grid(scene, &x, &y));
    if let Some(heat) = &panel.heat {
        shapes.push(heat.shape(scene)?);
        beside::bar(scene, heat, shapes)?;
    }
    band::shapes(scene, shapes);
    match &panel.bars {
        Some(bars) => bar_shapes::draw(scene, bars, head::mark_lines(scene), shapes),
        None => shapes.push(head::mark_lines(scene)),
    }
    curves(scene, shapes);
    points::shapes(scene, shapes);
    shapes.extend(beside::limit_lines(scene));
    shapes.push(axes(scene, &x, &y));
    x_letters(scene, &x, shapes);
    y_letters(scene, &y, shapes);
    head::letters(scene, shapes);
    points::names(scene, shapes);
    beside::limit_letters(scene, shapes);
    Ok(())
}

/// As many x ticks as have room for their labels.
fn fitting_ticks(ruler: &Ruler, room: f64) -> Ticks {
    let fits = |found: &Ticks| {
        found.major.windows(2).all(|pair| {
            let needed = 0.5 * (width(&pair[0].1, SMALL) + width(&pair[1].1, SMALL)) + LABEL_GAP;
            (pair[1].0 - pair[0].0) * room >= needed
        })
    };
    // Labels of a logarithmic axis are short: 1, 2, 5.
    let spacing = if ruler.scale == Scale::Log10 { 30.0 } else { 45.0 };
    let most = (room / spacing).clamp(2.0, 10.0) as usize;
    let found = (2..=most).rev().map(|count| ticks(ruler, count)).find(fits);
    found.unwrap_or_else(|| ticks(ruler, 1))
}

fn grid(scene: &Scene, x: &Ticks, y: &Ticks) -> Shape {
    let frame = &scene.frame;
    let inside = |share: &f64| (0.001..0.999).contains(share);
    let upright = x.major.iter().map(|tick| tick.0).filter(inside);
    let level = y.major.iter().map(|tick| tick.0).filter(inside);
    let runs = upright
        .map(|share| vec![frame.at(share, 0.0), frame.at(share, 1.0)])
        .chain(level.map(|share| vec![frame.at(0.0, share), frame.at(1.0, share)]))
        .collect();
    Shape::Lines { runs, pen: Pen { ink: scene.theme.grid(), width: 0.7, dashes: Vec::new() } }
}

fn curves(scene: &Scene, shapes: &mut Vec<Shape>) {
    let [x, y] = &scene.rulers;
    for curve in &scene.panel.curves {
        let pen = Pen {
            ink: scene.theme.shade(curve.stroke.colour),
            width: curve.stroke.width,
            dashes: curve.stroke.dash.lengths(curve.stroke.width),
        };
        shapes.push(Shape::Lines { runs: runs(curve, x, y, &scene.frame), pen });
    }
}

/// The frame with its ticks.
fn axes(scene: &Scene, x: &Ticks, y: &Ticks) -> Shape {
    let frame = &scene.frame;
    let box_line = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0], [0.0, 0.0], [1.0, 0.0]];
    let mut runs = vec![box_line.map(|[across, up]| frame.at(across, up)).to_vec()];
    let mut tick = |from: Point, [right, down]: Point| {
        runs.push(vec![from, [from[0] + right, from[1] + down]]);
    };
    for share in &x.minor {
        tick(frame.at(*share, 0.0), [0.0, MINOR_TICK]);
    }
    for (share, _) in &x.major {
        tick(frame.at(*share, 0.0), [0.0, TICK]);
    }
    for share in &y.minor {
        tick(frame.at(0.0, *share), [-MINOR_TICK, 0.0]);
    }
    for (share, _) in &y.major {
        tick(frame.at(0.0, *share), [-TICK, 0.0]);
    }
    let ink = scene.theme.shade(Colour::Ink);
    Shape::Lines { runs, pen: Pen { ink, width: 1.0, dashes: Vec::new() } }
}

fn x_letters(scene: &Scene, x: &Ticks, shapes: &mut Vec<Shape>) {
    let first = scene.frame.bottom() + TICK_ROOM + 0.8 * SMALL;
    for (share, label) in &x.major {
        let at = [scene.frame.at(*share, 0.0)[0], first];
        shapes.push(Shape::Text(scene.text(label, at, SMALL, Anchor::Middle)));
    }
    if scene.x_label {
        let at = [scene.frame.at(0.5, 0.0)[0], first + LINE + 1.0];
        let label = scene.text(&scene.panel.x.label, at, LETTERS, Anchor::Middle);
        shapes.push(Shape::Text(label));
    }
}

fn y_letters(scene: &Scene, y: &Ticks, shapes: &mut Vec<Shape>) {
    for (share, label) in &y.major {
        let [left, middle] = scene.frame.at(0.0, *share);
        let at = [left - TICK_ROOM, middle + 0.36 * SMALL];
        shapes.push(Shape::Text(scene.text(label, at, SMALL, Anchor::End)));
    }
    if scene.y_label {
        let middle = scene.frame.at(0.0, 0.5)[1];
        let at = [scene.frame.left - scene.y_room + EDGE + 0.75 * LETTERS, middle];
        let label = scene.text(&scene.panel.y.label, at, LETTERS, Anchor::Middle);
        shapes.push(Shape::Text(Text { upwards: true, ..label }));
    }
}
