//! Draws points with their error bars and names.
//!
//! What they are is said in `figure`.

use crate::drawing::{Anchor, Pen, Point, Shape};
use crate::lettering::width;
use crate::ruler::Ruler;
use crate::scene::Scene;
use crate::sheet::SMALL;
use crate::{Colour, Marker, Points, Theme};

/// Half the height of a marker \[px\].
const SIZE: f64 = 3.6;
/// Half the length of an error bar's caps \[px\].
const CAP: f64 = 3.0;
/// Corners of what passes for a circle.
const CORNERS: usize = 20;

impl Marker {
    /// How much of what is behind it it hides.
    pub(crate) fn opacity(self) -> f64 {
        if self == Self::Dot { 0.35 } else { 1.0 }
    }

    /// Its outline about a point.
    pub(crate) fn outline(self, [x, y]: Point) -> Vec<Point> {
        // Corners, how far out, and the turn of the first in steps from corner to corner.
        let (corners, radius, turn) = match self {
            Self::Disc => (CORNERS, SIZE, 0.0),
            Self::Square => (4, 1.25 * SIZE, 0.5),
            Self::Diamond => (4, 1.35 * SIZE, 0.0),
            Self::Dot => (4, 0.4 * SIZE, 0.5),
        };
        let angle = |corner: usize| std::f64::consts::TAU * (corner as f64 + turn) / corners as f64;
        (0..corners).map(|corner| [x + radius * angle(corner).cos(), y + radius * angle(corner).sin()]).collect()
    }
}

/// The pen of error bars of a colour.
pub(crate) fn whisker(colour: Colour, theme: Theme) -> Pen {
    Pen { ink: theme.shade(colour), width: 1.1, dashes: Vec::new() }
}

/// Error bars and markers of a panel; the markers on top.
pub(crate) fn shapes(scene: &Scene, shapes: &mut Vec<Shape>) {
    let [x, y] = &scene.rulers;
    for points in &scene.panel.points {
        let across = |index: usize| x.share(points.x[index]);
        let up = |value: f64| y.share(value);
        let shown = |index: &usize| Ruler::holds(across(*index)) && Ruler::holds(up(points.y[*index]));
        let shown: Vec<usize> = (0..points.x.len()).filter(shown).collect();
        let mut runs = Vec::new();
        for &index in &shown {
            let Some(error) = points.errors.get(index).filter(|error| error.is_finite()) else { continue };
            let ends = [points.y[index] - error, points.y[index] + error];
            // A bar that leaves the axes ends at their edge, without a cap.
            let ends = ends.map(up).map(|share| if share.is_nan() { 0.0 } else { share });
            let [low, high] = ends.map(|share| scene.frame.at(across(index), share.clamp(0.0, 1.0)));
            runs.push(vec![low, high]);
            for (end, share) in [low, high].into_iter().zip(ends) {
                if Ruler::holds(share) {
                    runs.push(vec![[end[0] - CAP, end[1]], [end[0] + CAP, end[1]]]);
                }
            }
        }
        shapes.push(Shape::Lines { runs, pen: whisker(points.colour, scene.theme) });
        let outline = |index: usize| points.marker.outline(scene.frame.at(across(index), up(points.y[index])));
        let outlines = shown.into_iter().map(outline).collect();
        shapes.push(Shape::Area { outlines, ink: scene.theme.shade(points.colour), opacity: points.marker.opacity() });
    }
}

/// Names of points, each where it has room: right of its point, left of it, above or below; on no other point and on no name before it.
pub(crate) fn names(scene: &Scene, shapes: &mut Vec<Shape>) {
    let [x, y] = &scene.rulers;
    let place = |points: &Points, index: usize| {
        let (across, up) = (x.share(points.x[index]), y.share(points.y[index]));
        (Ruler::holds(across) && Ruler::holds(up)).then(|| scene.frame.at(across, up))
    };
    let all = || scene.panel.points.iter().flat_map(|points| (0..points.x.len()).map(move |index| (points, index)));
    let mut taken: Vec<[f64; 4]> = Vec::new();
    for (points, index) in all() {
        let Some([left, top]) = place(points, index) else { continue };
        taken.push([left - SIZE, top - SIZE, left + SIZE, top + SIZE]);
    }
    for (points, index) in all() {
        let (Some([left, top]), Some(name)) = (place(points, index), points.names.get(index)) else { continue };
        let (long, half) = (width(name, SMALL), 0.5 * SMALL);
        let beside = SIZE + 4.0;
        let places = [
            [left + beside, top],
            [left - beside - long, top],
            [left - 0.5 * long, top - beside - half],
            [left - 0.5 * long, top + beside + half],
        ];
        let around = |[from, middle]: Point| [from - 2.0, middle - half - 1.0, from + long + 2.0, middle + half + 1.0];
        let is_free = |at: &Point| {
            let sides = around(*at);
            let inside = sides[0] >= scene.frame.left
                && sides[2] <= scene.frame.right()
                && sides[1] >= scene.frame.top
                && sides[3] <= scene.frame.bottom();
            let clear = |other: &[f64; 4]| {
                sides[2] <= other[0] || other[2] <= sides[0] || sides[3] <= other[1] || other[3] <= sides[1]
            };
            inside && taken.iter().all(clear)
        };
        if let Some(at) = places.into_iter().find(is_free).filter(|_| !name.is_empty()) {
            taken.push(around(at));
            shapes.push(Shape::Text(scene.text(name, [at[0], at[1] + 0.36 * SMALL], SMALL, Anchor::Start)));
        }
    }
}
