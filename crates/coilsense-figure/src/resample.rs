//! From the cells of a matrix to the dots of a picture, in one direction at a time.
//!
//! Where several cells share a dot, the one farthest from zero is shown, so that no peak is
//! lost. What colours the dots get is `heat`'s matter.

use std::ops::Range;

use crate::ruler::Ruler;

/// The cells that make one dot.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Reach {
    /// Beyond the cells.
    Outside,
    /// One cell or several, of which the farthest from zero counts.
    Cells(Range<usize>),
    /// Between the middles of two cells, at a share of the way.
    Between(usize, usize, f64),
}

/// Which of `cells`, evenly spaced between two `edges`, each of `dots` along the ruler shows.
pub(crate) fn reaches(dots: usize, ruler: &Ruler, edges: (f64, f64), cells: usize, smooth: bool) -> Vec<Reach> {
    let count = cells as f64;
    let place = |share: f64| count * (ruler.value(share) - edges.0) / (edges.1 - edges.0);
    let reach = |dot: usize| {
        let [from, middle, to] = [0.0, 0.5, 1.0].map(|part| place((dot as f64 + part) / dots as f64));
        if !(0.0..=count).contains(&middle) {
            return Reach::Outside;
        }
        // Each cell belongs to the dot that holds its middle.
        let [first, end] = [from, to].map(|edge| (edge - 0.5).ceil().clamp(0.0, count) as usize);
        if to - from >= 1.0 && end > first {
            return Reach::Cells(first..end);
        }
        let within = (middle - 0.5).clamp(0.0, count - 1.0);
        let (nearest, before) = ((middle as usize).min(cells - 1), within as usize);
        if !smooth {
            return Reach::Cells(nearest..nearest + 1);
        }
        Reach::Between(before, (before + 1).min(cells - 1), within - before as f64)
    };
    (0..dots).map(reach).collect()
}

impl Reach {
    /// The value of the dot, from those of the cells; NaN where it has none.
    pub fn value(&self, cell: impl Fn(usize) -> f64) -> f64 {
        match self {
            Self::Outside => f64::NAN,
            Self::Cells(cells) => cells.clone().map(cell).filter(|value| value.is_finite()).fold(f64::NAN, farther),
            Self::Between(before, after, share) => {
                let (near, far) = (cell(*before), cell(*after));
                let mixed = (1.0 - share) * near + share * far;
                // Beside a gap the value that is there reaches up to it.
                let alone = if *share < 0.5 { near } else { far };
                if mixed.is_finite() { mixed } else { alone }
            }
        }
    }

    /// Whether any cell of the dot is marked, the nearest where it lies between two.
    pub fn marked(&self, cell: impl Fn(usize) -> bool) -> bool {
        match self {
            Self::Outside => false,
            Self::Cells(cells) => cells.clone().any(cell),
            Self::Between(before, after, share) => cell(if *share < 0.5 { *before } else { *after }),
        }
    }
}

/// The one of two values that is farther from zero; any value beats none.
fn farther(kept: f64, value: f64) -> f64 {
    if value.abs() <= kept.abs() { kept } else { value }
}
