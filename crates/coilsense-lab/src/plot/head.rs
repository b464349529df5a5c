//! What stands above a frame: the title, and the labels of the marks, with their lines.
//!
//! The frame itself is drawn in `panel`.

use super::drawing::{Anchor, Pen, Shape};
use super::lettering::width;
use super::ruler::Ruler;
use super::scene::Scene;
use super::sheet::{EDGE, LETTERS, LINE, SMALL};
use super::{Mark, Panel};

/// Height of a row of mark labels \[px\].
const ROW: f64 = 14.0;
/// Least room between two mark labels of a row \[px\].
const GAP: f64 = 6.0;

/// Room that the head of a panel takes above a frame `room` \[px\] wide.
pub(super) fn height(panel: &Panel, x: &Ruler, room: f64) -> f64 {
    let rows = placed(panel, x, room).iter().map(|(_, _, row)| row + 1).max().unwrap_or(0);
    LINE * title_lines(&panel.title, room).len() as f64 + ROW * rows as f64
}

/// The lines of the marks, behind the curves.
pub(super) fn mark_lines(scene: &Scene) -> Shape {
    let share = |mark: &Mark| scene.rulers[0].share(mark.x);
    let shares = scene.panel.marks.iter().map(share).filter(|share| Ruler::holds(*share));
    let runs = shares.map(|at| vec![scene.frame.at(at, 0.0), scene.frame.at(at, 1.0)]).collect();
    let pen = Pen { ink: scene.theme.mark(), width: 0.9, dashes: vec![2.5, 2.5] };
    Shape::Lines { runs, pen }
}

/// Title and mark labels.
pub(super) fn letters(scene: &Scene, shapes: &mut Vec<Shape>) {
    let placed = placed(scene.panel, &scene.rulers[0], scene.frame.width);
    for (label, middle, row) in &placed {
        let at = [scene.frame.left + middle, scene.frame.top - 4.0 - ROW * *row as f64];
        shapes.push(Shape::Text(scene.text(label, at, SMALL, Anchor::Middle)));
    }
    let rows = placed.iter().map(|(_, _, row)| row + 1).max().unwrap_or(0);
    let lines = title_lines(&scene.panel.title, scene.frame.width);
    let foot = scene.frame.top - 6.0 - ROW * rows as f64;
    for (above, line) in lines.into_iter().rev().enumerate() {
        let at = [scene.frame.at(0.5, 0.0)[0], foot - LINE * above as f64];
        shapes.push(Shape::Text(scene.text(&line, at, LETTERS, Anchor::Middle)));
    }
}

/// Labels with their middle, from the left of the frame \[px\], and row, counted upwards: each
/// takes the lowest row in which it is clear of those before it.
fn placed<'a>(panel: &'a Panel, x: &Ruler, room: f64) -> Vec<(&'a str, f64, usize)> {
    let mut marks: Vec<(&str, f64)> = panel
        .marks
        .iter()
        .map(|mark| (mark.label.as_str(), x.share(mark.x)))
        .filter(|(label, share)| !label.is_empty() && Ruler::holds(*share))
        .collect();
    marks.sort_by(|a, b| a.1.total_cmp(&b.1));
    let mut taken: Vec<f64> = Vec::new();
    let mut placed = Vec::with_capacity(marks.len());
    for (label, share) in marks {
        let half = 0.5 * width(label, SMALL);
        let middle = (share * room).min(room + EDGE - half).max(half - EDGE);
        let free = taken.iter().position(|end| middle - half >= end + GAP);
        let row = free.unwrap_or(taken.len());
        if row == taken.len() {
            taken.push(0.0);
        }
        taken[row] = middle + half;
        placed.push((label, middle, row));
    }
    placed
}

/// The title in lines no wider than `room` \[px\], as far as its words allow.
fn title_lines(title: &str, room: f64) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in title.split_whitespace() {
        match lines.last_mut() {
            Some(line) if width(&format!("{line} {word}"), LETTERS) <= room => {
                line.push(' ');
                line.push_str(word);
            }
            _ => lines.push(word.to_owned()),
        }
    }
    lines
}
