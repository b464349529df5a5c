//! Draws an area between two curves, such as what a range of damping leaves open.
//!
//! The lines themselves are `trace`'s matter, from which the thinning comes.

use crate::drawing::{Frame, Point, Shape};
use crate::ruler::Ruler;
use crate::scene::Scene;
use crate::trace::{straightened, within_reach};
use crate::{Band, Scale, Theme};

/// Opacity of a band: curves and grid show through. Dark ground swallows more.
pub(crate) fn opacity(theme: Theme) -> f64 {
    match theme {
        Theme::Light => 0.25,
        Theme::Dark => 0.4,
    }
}

/// A share of an axis from which nothing is seen.
const FAR_BELOW: f64 = -1e6;

/// The bands of a panel.
pub(crate) fn shapes(scene: &Scene, shapes: &mut Vec<Shape>) {
    for band in &scene.panel.bands {
        let outlines = outlines(band, &scene.rulers, &scene.frame);
        shapes.push(Shape::Area { outlines, ink: scene.theme.shade(band.colour), opacity: opacity(scene.theme) });
    }
}

/// The closed outlines of a band within the frame, one for each stretch without a gap.
pub(crate) fn outlines(band: &Band, [x, y]: &[Ruler; 2], frame: &Frame) -> Vec<Vec<Point>> {
    let share = |value: f64| {
        let beneath = y.scale == Scale::Log10 && value.is_finite() && value <= 0.0;
        if beneath { FAR_BELOW } else { y.share(value) }
    };
    let slice = |((&across, &a), &b): ((&f64, &f64), &f64)| {
        let [left, first] = frame.at(x.share(across), share(a)).map(within_reach);
        let second = within_reach(frame.at(0.0, share(b))[1]);
        // A NaN in either edge must stay one.
        let upside_down = second < first;
        if upside_down { [left, second, first] } else { [left, first, second] }
    };
    let slices: Vec<[f64; 3]> = band.x.iter().zip(&band.lower).zip(&band.upper).map(slice).collect();
    slices
        .split(|slice| slice.iter().any(|pixels| !pixels.is_finite()))
        .filter(|run| !run.is_empty())
        .map(|run| clipped(&outline(&merged(run)), frame))
        .filter(|outline| outline.len() > 2)
        .collect()
}

/// Slices that share a pixel column become its envelope; a lone one becomes a pixel wide.
fn merged(run: &[[f64; 3]]) -> Vec<[f64; 3]> {
    if let [[x, top, bottom]] = run {
        return vec![[x - 0.5, *top, *bottom], [x + 0.5, *top, *bottom]];
    }
    let mut kept = Vec::with_capacity(run.len());
    for crowd in run.chunk_by(|a, b| a[0].floor() == b[0].floor()) {
        if crowd.len() <= 3 {
            kept.extend_from_slice(crowd);
            continue;
        }
        let top = crowd.iter().map(|slice| slice[1]).fold(f64::INFINITY, f64::min);
        let bottom = crowd.iter().map(|slice| slice[2]).fold(f64::NEG_INFINITY, f64::max);
        kept.extend([crowd[0][0], crowd[crowd.len() - 1][0]].map(|x| [x, top, bottom]));
    }
    kept
}

/// Along the one edge and back along the other.
fn outline(slices: &[[f64; 3]]) -> Vec<Point> {
    let edge = |which: usize| straightened(&slices.iter().map(|slice| [slice[0], slice[which]]).collect::<Vec<_>>());
    edge(1).into_iter().chain(edge(2).into_iter().rev()).collect()
}

/// The part of an outline inside the frame, wall by wall (Sutherland and Hodgman's clipping).
fn clipped(outline: &[Point], frame: &Frame) -> Vec<Point> {
    let walls = [(0, frame.left, 1.0), (0, frame.right(), -1.0), (1, frame.top, 1.0), (1, frame.bottom(), -1.0)];
    walls.into_iter().fold(outline.to_vec(), |points, (axis, wall, side)| {
        let depth = |point: &Point| side * (point[axis] - wall);
        let mut kept = Vec::with_capacity(points.len() + 4);
        for (index, point) in points.iter().enumerate() {
            let before = &points[(index + points.len() - 1) % points.len()];
            if (depth(before) >= 0.0) != (depth(point) >= 0.0) {
                let t = depth(before) / (depth(before) - depth(point));
                let mut crossing = [0, 1].map(|axis| before[axis] + t * (point[axis] - before[axis]));
                crossing[axis] = wall;
                kept.push(crossing);
            }
            if depth(point) >= 0.0 {
                kept.push(*point);
            }
        }
        kept
    })
}
