//! A chain at rest between its ends, with what is closed there.
//!
//! Next door: the chain on its way (`run`), the static curve of a coil (`crate::sections`).

use nalgebra::{DMatrix, DVector};

use super::chain::Chain;
use super::law::{Contact, Law};
use crate::error::{Error, check};
use crate::mount::FarEnd;

/// After so many rounds of closing and opening pairs no state of rest is looked for any more.
const MOST_ROUNDS: usize = 200;
/// A pair overlaps, or is pulled, from this share \[1\] of the compression, or of the force, on.
const ROUNDING: f64 = 1e-13;

impl Chain {
    /// Where the lumps lie at rest, the spring's ends displaced by these from the unloaded spring \[m\]; shape `N`.
    ///
    /// min ½ Σ k_j s_j² where Σ s_j = y_2 − y_1, and Σ s_j + g ≥ 0 over each pair (or with K_c of elastic ones): pairs that overlap are closed and
    /// those that would be pulled are opened until there are none of either kind.
    ///
    /// # Errors
    /// [`Error::Value`] for ends between which all is solid.
    pub(super) fn at_rest(&self, contact: &Contact, ends: [f64; 2]) -> Result<Vec<f64>, Error> {
        let mut stiffnesses = self.stiffnesses()[self.base()..=self.last_segment()].to_vec();
        if self.far_end() == FarEnd::Force {
            stiffnesses.push(1.0 / self.beyond());
        }
        let pairs: Vec<_> = self.pairs().iter().skip(usize::from(self.cam().is_some())).collect();
        // Σ 1/k up to each point.
        let mut soft = vec![0.0];
        soft.extend(stiffnesses.iter().scan(0.0, |sum, stiffness| {
            *sum += 1.0 / stiffness;
            Some(*sum)
        }));
        let points = |pair: usize| [pairs[pair].first - self.base(), pairs[pair].second - self.base()];
        let give = match contact.law() {
            Law::Hard { .. } => 0.0,
            Law::Elastic { stiffness, .. } => 1.0 / stiffness,
        };
        let stretch = ends[1] - ends[0];
        let mut closed: Vec<usize> = Vec::new();
        for _ in 0..MOST_ROUNDS {
            let state = Held::of(
                &soft,
                &closed.iter().map(|&pair| (points(pair), pairs[pair].gap)).collect::<Vec<_>>(),
                give,
                stretch,
            );
            let Some(Held { force, pushes }) = state else { break };
            let mut places = vec![ends[0]];
            for (segment, stiffness) in stiffnesses.iter().enumerate() {
                let over = closed.iter().zip(&pushes).filter(|(pair, _)| {
                    let [first, second] = points(**pair);
                    (first..second).contains(&segment)
                });
                let tension = force + over.map(|(_, push)| push).sum::<f64>();
                places.push(places[segment] + tension / stiffness);
            }
            let scale = ROUNDING * stretch.abs();
            let overlaps = |&pair: &usize| {
                let [first, second] = points(pair);
                places[second] - places[first] + pairs[pair].gap < -scale
            };
            let kept: Vec<usize> = closed
                .iter()
                .zip(&pushes)
                .filter(|(_, push)| **push > -ROUNDING * force.abs())
                .map(|(pair, _)| *pair)
                .collect();
            let new: Vec<usize> = (0..pairs.len()).filter(|pair| !closed.contains(pair)).filter(overlaps).collect();
            if new.is_empty() && kept.len() == closed.len() {
                // With end 1 where that stands on a follower, which is a lump.
                let first = 1 - self.base();
                return Ok(places[first..first + self.lumps()].to_vec());
            }
            closed = [kept, new].concat();
            closed.sort_unstable();
        }
        let allowed = "one at which windings are not solid between ends that close on them";
        check(false, "compression at the start", -stretch, "m", allowed)?;
        Ok(Vec::new())
    }
}

/// The force through a chain whose pairs are held at their gaps, and how they push.
struct Held {
    force: f64,
    pushes: Vec<f64>,
}

impl Held {
    /// - `soft`: Σ 1/k up to each point; `closed`: points and gaps of closed pairs; `give`: 1/K_c \[m/N\]; `stretch`: of the ends \[m\]
    ///
    /// A force through all and one over each pair: compliances they share times forces are what each is stretched by.
    fn of(soft: &[f64], closed: &[([usize; 2], f64)], give: f64, stretch: f64) -> Option<Self> {
        let last = soft.len() - 1;
        let spans: Vec<[usize; 2]> =
            std::iter::once([0, last]).chain(closed.iter().map(|(points, _)| *points)).collect();
        let shared = |a: [usize; 2], b: [usize; 2]| (soft[a[1].min(b[1])] - soft[a[0].max(b[0])]).max(0.0);
        let size = spans.len();
        let mut matrix = DMatrix::from_fn(size, size, |row, column| shared(spans[row], spans[column]));
        (1..size).for_each(|pair| matrix[(pair, pair)] += give);
        let stretches = std::iter::once(stretch).chain(closed.iter().map(|(_, gap)| -gap));
        let forces = matrix.cholesky()?.solve(&DVector::from_iterator(size, stretches));
        Some(Self { force: forces[0], pushes: forces.iter().skip(1).copied().collect() })
    }
}
