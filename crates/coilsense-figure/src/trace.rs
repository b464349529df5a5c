//! From samples to the shortest polylines that look the same.
//!
//! Samples become points in pixels, gaps become breaks, what lies outside the axes is cut off,
//! and of a crowd within one pixel column only the first, lowest, highest and last stay.
//! How the line is drawn is `stroke`'s matter.

use crate::Curve;
use crate::drawing::{Frame, Point};
use crate::ruler::Ruler;

/// How far a dropped point may lie from the line that stays \[px\]: a third of a dot of a
/// 300 dpi print.
const TOLERANCE: f64 = 0.1;

/// Where a point stands whose true place lies farther away \[px\]; beyond it, differences
/// could overflow.
const FAR: f64 = 1e9;

/// Points looked at together when dropping those on a line: a whole run at once costs time
/// with the square of its points.
const STRETCH: usize = 64;

/// The unbroken runs of a curve within the frame.
pub(crate) fn runs(curve: &Curve, x: &Ruler, y: &Ruler, frame: &Frame) -> Vec<Vec<Point>> {
    let points: Vec<Point> =
        curve.x.iter().zip(&curve.y).map(|(&a, &b)| frame.at(x.share(a), y.share(b)).map(within_reach)).collect();
    points
        .split(|point| !(point[0].is_finite() && point[1].is_finite()))
        .filter(|run| !run.is_empty())
        .flat_map(|run| clipped(&thinned(&visible_alone(run)), frame))
        .map(|run| straightened(&run))
        .collect()
}

/// A place that can be reckoned with, or none.
pub(crate) fn within_reach(pixels: f64) -> f64 {
    if pixels.is_finite() { pixels.clamp(-FAR, FAR) } else { f64::NAN }
}

/// A sample between two gaps becomes a dash of a pixel, or it would vanish.
fn visible_alone(run: &[Point]) -> Vec<Point> {
    match run {
        [[x, y]] => vec![[x - 0.5, *y], [x + 0.5, *y]],
        _ => run.to_vec(),
    }
}

/// Keeps the first, lowest, highest and last of the neighbours that share a pixel column.
pub(crate) fn thinned(run: &[Point]) -> Vec<Point> {
    let mut kept = Vec::with_capacity(run.len());
    for crowd in run.chunk_by(|a, b| a[0].floor() == b[0].floor()) {
        if crowd.len() <= 4 {
            kept.extend_from_slice(crowd);
            continue;
        }
        let (mut low, mut high) = (0, 0);
        for (index, point) in crowd.iter().enumerate() {
            if point[1] < crowd[low][1] {
                low = index;
            }
            if point[1] > crowd[high][1] {
                high = index;
            }
        }
        let mut order = [0, low.min(high), low.max(high), crowd.len() - 1].to_vec();
        order.dedup();
        kept.extend(order.into_iter().map(|index| crowd[index]));
    }
    kept
}

/// The parts of a run inside the frame; where it leaves and comes back, a new run begins.
fn clipped(run: &[Point], frame: &Frame) -> Vec<Vec<Point>> {
    let mut parts: Vec<Vec<Point>> = Vec::new();
    for pair in run.windows(2) {
        let Some((from, to)) = segment_within(pair[0], pair[1], frame) else {
            continue;
        };
        match parts.last_mut() {
            Some(part) if part.last() == Some(&from) => part.push(to),
            _ => parts.push(vec![from, to]),
        }
    }
    parts
}

/// The stretch of a segment inside the frame (Liang and Barsky's clipping).
fn segment_within(a: Point, b: Point, frame: &Frame) -> Option<(Point, Point)> {
    let walls = [[frame.left, frame.right()], [frame.top, frame.bottom()]];
    let (mut enter, mut leave) = (0.0_f64, 1.0_f64);
    for axis in 0..2 {
        let step = b[axis] - a[axis];
        let [near, far] = walls[axis].map(|wall| (wall - a[axis]) / step);
        if step == 0.0 {
            if a[axis] < walls[axis][0] || a[axis] > walls[axis][1] {
                return None;
            }
        } else {
            enter = enter.max(near.min(far));
            leave = leave.min(near.max(far));
        }
    }
    let at = |t: f64| [a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])];
    let from = if enter > 0.0 { at(enter) } else { a };
    let to = if leave < 1.0 { at(leave) } else { b };
    (enter <= leave).then_some((from, to))
}

/// Drops the points that lie on the line between their neighbours (Douglas and Peucker's way).
pub(crate) fn straightened(run: &[Point]) -> Vec<Point> {
    let last = run.len() - 1;
    let mut keep = vec![false; run.len()];
    keep[last] = true;
    let mut stretches = Vec::new();
    for from in (0..last).step_by(STRETCH) {
        keep[from] = true;
        stretches.push((from, last.min(from + STRETCH)));
    }
    while let Some((from, to)) = stretches.pop() {
        let (mut farthest, mut distance) = (from, TOLERANCE);
        for index in from + 1..to {
            let off = distance_to(run[index], run[from], run[to]);
            if off > distance {
                (farthest, distance) = (index, off);
            }
        }
        if farthest > from {
            keep[farthest] = true;
            stretches.extend([(from, farthest), (farthest, to)]);
        }
    }
    run.iter().zip(keep).filter_map(|(point, kept)| kept.then_some(*point)).collect()
}

/// Distance of a point from a segment \[px\].
fn distance_to(point: Point, from: Point, to: Point) -> f64 {
    let along = [to[0] - from[0], to[1] - from[1]];
    let off = [point[0] - from[0], point[1] - from[1]];
    let length = along[0] * along[0] + along[1] * along[1];
    let share = if length > 0.0 { (off[0] * along[0] + off[1] * along[1]) / length } else { 0.0 };
    let share = share.clamp(0.0, 1.0);
    (off[0] - share * along[0]).hypot(off[1] - share * along[1])
}
