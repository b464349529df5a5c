//! Where to look at a response: more closely where it bends.
//!
//! Next door: what is looked at (`response`), the curve through it (`curve`).

use coilsense::Error;

use super::moments::Moments;

/// A search for places enough for one sensor: which others are asked for makes no difference.
pub(super) struct Refinement<'a> {
    /// Where to look first, in any order; zero, the nominal spring, is added.
    pub places: &'a [f64],
    /// From where to where \[ln of a factor\].
    pub ends: (f64, f64),
    /// Variance \[N²\] beside which an error need not be known better.
    pub beside: f64,
    /// The goal \[N\], where the share of springs inside it is wanted.
    pub goal: Option<f64>,
}

/// A place must not stand out from its neighbours' curve by more than this share of the whole mean square.
const STANDS_OUT: f64 = 0.008;
/// An rms error is near the goal within so many times what it stands out by; then its neighbours must be within this part of the range.
const NEAR_GOAL: f64 = 2.0;
const PART: f64 = 0.004;
/// Most places.
const MOST: usize = 160;
/// Places closer than this share of the range are one.
const CLOSEST: f64 = 1e-4;

impl Refinement<'_> {
    /// Looks until nothing stands out; samples in order of their places.
    pub fn run(self, at: impl Fn(f64) -> Result<Moments, Error>) -> Result<Vec<(f64, Moments)>, Error> {
        let range = self.ends.1 - self.ends.0;
        let mut samples: Vec<(f64, Moments)> = vec![(0.0, at(0.0)?)];
        if range <= 1e-9 {
            return Ok(samples);
        }
        let mut wanted = self.places.to_vec();
        loop {
            let mut grown = false;
            for place in std::mem::take(&mut wanted) {
                let apart = |known: &(f64, Moments)| (known.0 - place).abs() > CLOSEST * range;
                if samples.len() < MOST && samples.iter().all(apart) {
                    let index = samples.partition_point(|known| known.0 < place);
                    samples.insert(index, (place, at(place)?));
                    grown = true;
                }
            }
            if !grown {
                return Ok(samples);
            }
            for index in 1..samples.len().max(2) - 1 {
                if self.stands_out(&samples, index) {
                    let [before, here, after] = [index - 1, index, index + 1].map(|index| samples[index].0);
                    wanted.extend([0.5 * (before + here), 0.5 * (here + after)]);
                }
            }
        }
    }

    /// Whether a sample lies off the line (in ln) between its neighbours by what counts.
    fn stands_out(&self, samples: &[(f64, Moments)], index: usize) -> bool {
        let ((before, left), (here, middle), (after, right)) =
            (&samples[index - 1], &samples[index], &samples[index + 1]);
        let share = (here - before) / (after - before);
        let part = 0.5 * (after - before) / (self.ends.1 - self.ends.0);
        let [a, b] = [left, right].map(|sample| sample.square().max(f64::MIN_POSITIVE).ln());
        let expected = (a + share * (b - a)).exp();
        if part > PART && self.crosses_goal(middle.square(), expected) {
            return true;
        }
        let off = (middle.square() - expected).abs() * part;
        off > STANDS_OUT * (self.beside + mean_square(samples))
    }

    /// Whether the goal lies so close to a mean square that what is not known of it may decide which side it is on.
    fn crosses_goal(&self, found: f64, expected: f64) -> bool {
        let Some(goal) = self.goal else { return false };
        let [found, expected] = [found, expected].map(|square| (square + self.beside).sqrt());
        (found - goal).abs() < NEAR_GOAL * (found - expected).abs()
    }
}

/// Mean square of an error over the range, by trapezes.
fn mean_square(samples: &[(f64, Moments)]) -> f64 {
    let range = samples[samples.len() - 1].0 - samples[0].0;
    let each = samples.windows(2).map(|pair| (pair[1].0 - pair[0].0) * 0.5 * (pair[0].1.square() + pair[1].1.square()));
    each.sum::<f64>() / range
}
