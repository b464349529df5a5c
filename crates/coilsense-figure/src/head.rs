//! What stands above a frame: the title, and the labels of the marks, with their lines.
//!
//! The frame itself is drawn in `panel`.

use crate::drawing::{Anchor, Pen, Shape};
use crate::lettering::{width, wrapped};
use crate::ruler::Ruler;
use crate::scene::Scene;
use crate::sheet::{EDGE, LETTERS, LINE, SMALL};
use crate::{Colour, Mark, Panel};

/// Height of a row of mark labels \[px\].
const ROW: f64 = 14.0;
/// More rows than this would take the room of what is to be seen.
const MOST_ROWS: usize = 3;
/// Least room between two mark labels of a row \[px\].
const GAP: f64 = 6.0;

/// Room that the head of a panel takes above a frame `room` \[px\] wide.
pub(crate) fn height(panel: &Panel, x: &Ruler, room: f64) -> f64 {
    let rows = placed(panel, x, room).iter().map(|(_, _, row)| row + 1).max().unwrap_or(0);
    LINE * wrapped(&panel.title, room, LETTERS).len() as f64 + ROW * rows as f64
}

/// The lines of the marks, behind curves, but over bars, on which only ink shows.
pub(crate) fn mark_lines(scene: &Scene) -> Shape {
    let share = |mark: &Mark| scene.rulers[0].share(mark.x);
    let shares = scene.panel.marks.iter().map(share).filter(|share| Ruler::holds(*share));
    let runs = shares.map(|at| vec![scene.frame.at(at, 0.0), scene.frame.at(at, 1.0)]).collect();
    let pen = Pen::reference(scene.theme);
    let ink = if scene.panel.bars.is_some() { scene.theme.shade(Colour::Ink) } else { pen.ink };
    Shape::Lines { runs, pen: Pen { ink, ..pen } }
}

/// Title and mark labels.
pub(crate) fn letters(scene: &Scene, shapes: &mut Vec<Shape>) {
    let placed = placed(scene.panel, &scene.rulers[0], scene.frame.width);
    for (label, middle, row) in &placed {
        let at = [scene.frame.left + middle, scene.frame.top - 4.0 - ROW * *row as f64];
        shapes.push(Shape::Text(scene.text(label, at, SMALL, Anchor::Middle)));
    }
    let rows = placed.iter().map(|(_, _, row)| row + 1).max().unwrap_or(0);
    let lines = wrapped(&scene.panel.title, scene.frame.width, LETTERS);
    let foot = scene.frame.top - 6.0 - ROW * rows as f64;
    for (above, line) in lines.into_iter().rev().enumerate() {
        let at = [scene.frame.at(0.5, 0.0)[0], foot - LINE * above as f64];
        shapes.push(Shape::Text(scene.text(&line, at, LETTERS, Anchor::Middle)));
    }
}

/// Labels with their middle, from the left of the frame \[px\], and row, counted upwards: each
/// takes the lowest row in which it is clear of those before it, or none.
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
        if row == MOST_ROWS {
            continue;
        }
        if row == taken.len() {
            taken.push(0.0);
        }
        taken[row] = middle + half;
        placed.push((label, middle, row));
    }
    placed
}
