//! Draws bars with their whiskers, texts and names.
//!
//! What a bar is, and the room it takes, is said in `bars`.

use crate::bars::{NAME_GAP, NAME_LINE, TEXT_GAP, name_lines, row_heights};
use crate::drawing::{Anchor, Frame, Pen, Point, Shape};
use crate::lettering::width;
use crate::ruler::Ruler;
use crate::scene::Scene;
use crate::sheet::SMALL;
use crate::stroke::Rgb;
use crate::{Bar, Bars, Colour, Scale};

/// Share of its row that a bar fills.
const THICK: f64 = 0.62;
/// The same for the second one of two.
const THIN: f64 = 0.24;
/// A bar is not thicker \[px\].
const MOST: f64 = 20.0;
/// Half the height of the ends of a whisker \[px\].
const CAP: f64 = 3.5;

/// All bars of a panel, from the top; over them the lines of the marks, and over those whatever
/// is to be read.
pub(crate) fn draw(scene: &Scene, bars: &Bars, marks: Shape, shapes: &mut Vec<Shape>) {
    let two = bars.bars.iter().any(|bar| bar.second.is_some());
    let heights = row_heights(bars, scene.panel_width, scene.frame.height);
    let row = heights.iter().copied().fold(f64::INFINITY, f64::min);
    let thick = (if two { 0.46 } else { THICK } * row).min(MOST);
    let thin = if two { (THIN * row).min(0.5 * MOST) } else { 0.0 };
    let (mut foot, mut over) = (scene.frame.top, Vec::new());
    for (bar, height) in bars.bars.iter().zip(heights) {
        let middle = foot + 0.5 * height;
        let top = middle - 0.5 * (thick + thin);
        shapes.extend(block(scene, bar.value, [top, thick], scene.theme.shade(bar.colour)));
        shapes.extend(bar.second.and_then(|end| block(scene, end, [top + thick, thin], scene.theme.mark())));
        over.extend(bar.interval.into_iter().flat_map(|interval| whisker(scene, interval, top + 0.5 * thick)));
        text(scene, bar, top + 0.5 * thick, &mut over);
        name(scene, bar, middle, &mut over);
        foot += height;
    }
    shapes.extend(zero_line(scene));
    shapes.push(marks);
    shapes.append(&mut over);
}

/// The name of a bar, its lines about a height of `middle` \[px\].
fn name(scene: &Scene, bar: &Bar, middle: f64, shapes: &mut Vec<Shape>) {
    let lines = name_lines(bar, scene.panel_width);
    let first = middle - 0.5 * NAME_LINE * (lines.len() as f64 - 1.0) + 0.36 * SMALL;
    for (index, line) in lines.iter().enumerate() {
        let at = [scene.frame.left - NAME_GAP, first + NAME_LINE * index as f64];
        shapes.push(Shape::Text(scene.text(line, at, SMALL, Anchor::End)));
    }
}

/// Where bars begin: at zero, or at the left where the axis does not hold it.
fn root(x: &Ruler) -> f64 {
    if x.scale == Scale::Log10 { 0.0 } else { x.share(0.0).clamp(0.0, 1.0) }
}

/// Place of a value across the frame \[px\], at the frame's edge where it lies beyond.
fn across(scene: &Scene, value: f64) -> Option<f64> {
    let share = scene.rulers[0].share(value);
    share.is_finite().then(|| scene.frame.at(share.clamp(0.0, 1.0), 0.0)[0])
}

fn block(scene: &Scene, value: f64, [top, height]: [f64; 2], ink: Rgb) -> Option<Shape> {
    let end = across(scene, value)?;
    let start = scene.frame.at(root(&scene.rulers[0]), 0.0)[0];
    let frame = Frame { left: start.min(end), top, width: (end - start).abs(), height };
    Some(Shape::Area { outlines: vec![frame.corners()], ink, opacity: 1.0 })
}

/// A whisker, on a seam of paper so that it shows on any bar.
fn whisker(scene: &Scene, (lower, upper): (f64, f64), y: f64) -> Vec<Shape> {
    let (Some(left), Some(right)) = (across(scene, lower), across(scene, upper)) else { return Vec::new() };
    let ends = [left, right].map(|x| vec![[x, y - CAP], [x, y + CAP]]);
    let runs: Vec<Vec<Point>> = ends.into_iter().chain([vec![[left, y], [right, y]]]).collect();
    let pen = |ink, width| Pen { ink, width, dashes: Vec::new() };
    let seam = Shape::Lines { runs: runs.clone(), pen: pen(scene.theme.paper(), 3.2) };
    vec![seam, Shape::Lines { runs, pen: pen(scene.theme.shade(Colour::Ink), 1.2) }]
}

/// The text past the end of bar and whisker, and past a mark that it would stand on where there is room; on paper, so that no line crosses it.
fn text(scene: &Scene, bar: &Bar, y: f64, shapes: &mut Vec<Shape>) {
    if bar.text.is_empty() {
        return;
    }
    let falling = bar.value < 0.0;
    let start = scene.frame.at(root(&scene.rulers[0]), 0.0)[0];
    let interval = bar.interval.into_iter().flat_map(|(lower, upper)| [lower, upper]);
    let ends = [bar.value].into_iter().chain(interval).filter_map(|value| across(scene, value));
    let end = ends.fold(start, if falling { f64::min } else { f64::max });
    let room = width(&bar.text, SMALL);
    let Frame { left, .. } = scene.frame;
    let last = scene.frame.right() - TEXT_GAP - room;
    let mut from = if falling { end - TEXT_GAP - room } else { end + TEXT_GAP };
    let mut marks: Vec<f64> = scene.panel.marks.iter().filter_map(|mark| across(scene, mark.x)).collect();
    marks.sort_by(f64::total_cmp);
    for mark in marks.into_iter().filter(|_| !falling) {
        let stands_on = (from - TEXT_GAP..=from + room + TEXT_GAP).contains(&mark);
        if stands_on && mark + TEXT_GAP <= last {
            from = mark + TEXT_GAP;
        }
    }
    // Where a given range leaves no room beyond the bar, the text moves onto it.
    let from = from.min(last).max(left + TEXT_GAP);
    let backing = Frame { left: from - 2.0, top: y - 0.55 * SMALL, width: room + 4.0, height: 1.1 * SMALL };
    shapes.push(Shape::Area { outlines: vec![backing.corners()], ink: scene.theme.paper(), opacity: 1.0 });
    shapes.push(Shape::Text(scene.text(&bar.text, [from, y + 0.36 * SMALL], SMALL, Anchor::Start)));
}

/// The line from which bars go both ways.
fn zero_line(scene: &Scene) -> Option<Shape> {
    let share = root(&scene.rulers[0]);
    let inside = share > 1e-9 && share < 1.0;
    let pen = Pen { ink: scene.theme.shade(Colour::Ink), width: 1.0, dashes: Vec::new() };
    inside.then(|| Shape::Lines { runs: vec![vec![scene.frame.at(share, 0.0), scene.frame.at(share, 1.0)]], pen })
}
