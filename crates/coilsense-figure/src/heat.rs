//! Draws a matrix in colour, such as how far each winding is displaced over time.
//!
//! Next door: which cells make which dot (`resample`), the colours (`colour_map`), the colour
//! bar (`beside`).

use crate::colour_map::{Kind, LEVELS, colours};
use crate::drawing::{Frame, Shape};
use crate::picture::Picture;
use crate::raster::PNG_SCALE;
use crate::resample::{Reach, reaches};
use crate::ruler::Ruler;
use crate::scene::Scene;
use crate::{Axis, Colour, HeatMap, PlotError, Scale, Theme};

/// The most dots across and down: a picture of some 50 kB.
const MOST_DOTS: [usize; 2] = [900, 400];
/// A sign held by less than this share of the greatest value is taken for rounding.
const SLIGHT: f64 = 0.01;

/// Places in the palette behind those of the scale.
const MISSING: u8 = LEVELS as u8;
const MARKED: u8 = MISSING + 1;
const OUTSIDE: u8 = MISSING + 2;

impl HeatMap {
    /// The ruler of the colour bar and how it is coloured.
    pub(crate) fn scale(&self) -> Result<(Ruler, Kind), PlotError> {
        let mut axis = Axis { label: self.label.clone(), range: self.range, scale: Scale::Linear };
        let fitted = Ruler::new(&axis, self.values.iter().copied(), 0.0)?;
        let (below, above) = (-fitted.lower, fitted.upper);
        let most = below.max(above);
        if below.min(above) < SLIGHT * most {
            return Ok((fitted, Kind::Sequential));
        }
        axis.range = Some((-most, most));
        Ok((Ruler::new(&axis, std::iter::empty(), 0.0)?, Kind::Diverging))
    }

    /// The cells within the frame.
    pub(crate) fn shape(&self, scene: &Scene) -> Result<Shape, PlotError> {
        let (ruler, kind) = self.scale()?;
        let Frame { width, height, .. } = scene.frame;
        let [across, down] = [(width, 0), (height, 1)]
            .map(|(pixels, axis)| ((pixels * PNG_SCALE).round() as usize).clamp(1, MOST_DOTS[axis]));
        let columns = reaches(across, &scene.rulers[0], self.x, self.values.len() / self.rows, self.smooth);
        let rows = reaches(down, &scene.rulers[1], self.y, self.rows, self.smooth);
        let dots = self.dots(&rows, &columns, &ruler);
        let picture = Picture { columns: across, dots, palette: palette(kind, scene.theme) };
        Ok(Shape::Picture { picture, frame: scene.frame })
    }

    /// The dots, row by row from the top.
    fn dots(&self, rows: &[Reach], columns: &[Reach], ruler: &Ruler) -> Vec<u8> {
        let width = self.values.len() / self.rows;
        let along = |row: usize| {
            let values = &self.values[row * width..][..width];
            columns.iter().map(move |reach| reach.value(|cell| values[cell]))
        };
        // One row after the other, as wide as the picture: then each dot needs its rows only.
        let narrowed: Vec<f64> = (0..self.rows).flat_map(along).collect();
        let marks: Vec<bool> = match &self.marked {
            Some(marked) => marked
                .cells
                .chunks_exact(width)
                .flat_map(|cells| columns.iter().map(|reach| reach.marked(|cell| cells[cell])))
                .collect(),
            None => vec![false; narrowed.len()],
        };
        let across = columns.len();
        let mut dots = Vec::with_capacity(rows.len() * across);
        for row in rows.iter().rev() {
            for (column, reach) in columns.iter().enumerate() {
                let value = row.value(|line| narrowed[line * across + column]);
                dots.push(match (row, reach) {
                    (Reach::Outside, _) | (_, Reach::Outside) => OUTSIDE,
                    _ if row.marked(|line| marks[line * across + column]) => MARKED,
                    _ => level(value, ruler),
                });
            }
        }
        dots
    }
}

/// The colour of a value; beyond the ends of the scale that of the end.
fn level(value: f64, ruler: &Ruler) -> u8 {
    if !value.is_finite() {
        return MISSING;
    }
    (ruler.share(value).clamp(0.0, 1.0) * (LEVELS - 1) as f64).round() as u8
}

/// The scale, then what is missing, marked, and outside.
fn palette(kind: Kind, theme: Theme) -> Vec<Option<crate::stroke::Rgb>> {
    let rest = [Some(theme.mark()), Some(theme.shade(Colour::Ink)), None];
    colours(kind, theme).into_iter().map(Some).chain(rest).collect()
}

/// The colour bar's picture, its upper end on top.
pub(crate) fn colour_bar(kind: Kind, theme: Theme) -> Picture {
    Picture { columns: 1, dots: (0..LEVELS as u8).rev().collect(), palette: palette(kind, theme) }
}
