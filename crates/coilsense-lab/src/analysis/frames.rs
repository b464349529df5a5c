//! Where the windings are over time, thinned out for maps and animation.
//!
//! Next door: the motion itself (`coilsense::motion`).

use coilsense::motion::Windings;

/// Winding positions at evenly spaced moments.
#[derive(Debug, Clone, PartialEq)]
pub struct Frames {
    /// Moments \[s\], shape `frames`.
    pub times: Vec<f64>,
    /// u1, x_1…x_N, u2 \[m\], shape `frames × (N + 2)`, row-major.
    pub positions: Vec<f64>,
    /// N + 2.
    pub columns: usize,
}

/// Most moments that are kept: a map of that many columns fills a page.
const MOST_FRAMES: usize = 400;
/// A map shows the surge where it has so many columns in a surge period.
const FRAMES_PER_PERIOD: f64 = 24.0;

impl Frames {
    /// Of the positions at `times` \[s\] from sample `from` on: as many surge periods as can be shown well.
    pub(super) fn of(windings: &Windings, times: &[f64], from: usize, surge_period: f64) -> Self {
        let remaining = times.len().saturating_sub(from);
        let step = if times.len() > 1 { times[1] - times[0] } else { 1.0 };
        let stride = (surge_period / FRAMES_PER_PERIOD / step).floor().max(1.0) as usize;
        let samples = (from..from + remaining).step_by(stride.min(remaining.max(1))).take(MOST_FRAMES);
        let columns = windings.count() + 2;
        let mut frames = Self { times: Vec::new(), positions: Vec::new(), columns };
        for sample in samples {
            let [first, last] = windings.ends(sample);
            frames.times.push(times[sample]);
            frames.positions.push(first);
            frames.positions.extend_from_slice(windings.row(sample));
            frames.positions.push(last);
        }
        frames
    }

    /// u1, x_1…x_N, u2 at one of the moments; shape `N + 2`.
    pub fn row(&self, frame: usize) -> &[f64] {
        &self.positions[frame * self.columns..][..self.columns]
    }

    /// How far each winding is from where it would lie in a spring without mass \[m\], shape `frames × N`, row-major.
    pub fn departures(&self) -> Vec<f64> {
        let masses = self.columns - 2;
        let of_row = |row: &[f64]| -> Vec<f64> {
            let (first, last) = (row[0], row[self.columns - 1]);
            let line = |index: usize| first + (last - first) * (index as f64 + 0.5) / masses as f64;
            (0..masses).map(|index| row[index + 1] - line(index)).collect()
        };
        self.positions.chunks_exact(self.columns).flat_map(of_row).collect()
    }
}
