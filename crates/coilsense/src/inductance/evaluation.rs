//! L of samples by the block: to second order where that is good enough, elsewhere exactly, by polynomials or turn by turn.
//!
//! Next door: who asks (`within`, `maxwell`), the second-order form (`near_uniform`), the polynomials (`lag_polynomials`).

use super::expansion::{Expansion, LANES, Lanes};
use super::lag_polynomials::LagPolynomials;
use super::maxwell::MaxwellSum;
use super::mutual::MU_0;
use super::near_uniform::NearUniform;
use super::second_order::{BoundedInductance, ROUNDING, bound, bounded};
use super::turn_block::{Columns, TurnBlock};
use crate::motion::WIDTH;

/// For fewer samples polynomials are not worth finding.
const FEWEST: usize = 8;
/// Turns up to so far apart tell whether the second-order form is worth evaluating.
const LAGS_OF_A_GLANCE: usize = 2;

/// Evaluates blocks one after the other; what one has needed serves the next.
pub(super) struct Evaluation<'a> {
    coil: &'a MaxwellSum,
    polynomials: LagPolynomials,
    near: NearUniform,
    /// For samples whose pitches are too far apart for `near`.
    expansion: Expansion,
    lanes: Vec<Lanes>,
    /// Whether the last block had samples for which the second-order form is not good enough.
    was_far: bool,
    /// How many samples took the second-order form, and how many the exact sum.
    pub(super) counts: [usize; 2],
}

impl<'a> Evaluation<'a> {
    pub(super) fn new(coil: &'a MaxwellSum) -> Self {
        let turns = coil.places().len();
        Self {
            coil,
            polynomials: LagPolynomials::new(),
            near: NearUniform::new(turns),
            expansion: Expansion::new(turns),
            lanes: vec![[0.0; LANES]; turns],
            was_far: false,
            counts: [0, 0],
        }
    }

    /// L of a block's samples, exactly. `alone`: L of one of them, turn by turn.
    pub(super) fn exact(&mut self, block: &TurnBlock, mut alone: impl FnMut(&TurnBlock, usize) -> f64) -> Columns {
        let scale = 4.0 * MU_0 * self.coil.coil_radius();
        let floor = self.coil.self_part() / scale;
        let together = (block.samples >= FEWEST && self.coil.is_even())
            .then(|| self.polynomials.sum(block, self.coil.coil_radius(), floor));
        match together.flatten() {
            Some(sums) => sums.map(|sum| self.coil.self_part() + scale * sum),
            None => {
                let mut values = [0.0; WIDTH];
                (0..block.samples).for_each(|column| values[column] = alone(block, column));
                values
            }
        }
    }

    /// L of a block's samples with their bounds, each within `tolerance` of L; calls `give` with each.
    pub(super) fn within(
        &mut self,
        block: &TurnBlock,
        tolerance: f64,
        alone: impl FnMut(&TurnBlock, usize) -> f64,
        mut give: impl FnMut(usize, BoundedInductance),
    ) {
        let exact_only = tolerance < ROUNDING || !self.coil.is_even();
        let near = if exact_only || self.is_far(block, tolerance) { None } else { Some(self.near(block)) };
        let good = |value: &BoundedInductance| value.bound <= tolerance * value.inductance;
        let near_enough =
            near.as_ref().map_or(0, |near| near[..block.samples].iter().filter(|value| good(value)).count());
        self.was_far = near_enough < block.samples;
        let exact = if self.was_far { self.exact(block, alone) } else { [0.0; WIDTH] };
        self.counts[0] += near_enough;
        self.counts[1] += block.samples - near_enough;
        for (column, inductance) in exact.into_iter().enumerate().take(block.samples) {
            match near.as_ref().map(|near| near[column]).filter(good) {
                Some(value) => give(column, value),
                None => give(column, BoundedInductance { inductance, bound: ROUNDING * inductance }),
            }
        }
    }

    /// Whether, as in the last block, no sample's bound will be met: neighbours alone exceed it. Half of L more or less does not matter.
    fn is_far(&mut self, block: &TurnBlock, tolerance: f64) -> bool {
        if !self.was_far || !self.near.cover(self.coil, block) {
            return false;
        }
        let remainder = self.near.remainder_of(block, LAGS_OF_A_GLANCE);
        let uniform = self.near.uniform(block);
        (0..block.samples).all(|column| {
            let least = bound(strain(block, column), remainder[column]);
            least > 1.5 * tolerance * uniform[column]
        })
    }

    /// The second-order form of all samples.
    fn near(&mut self, block: &TurnBlock) -> [BoundedInductance; WIDTH] {
        if !self.near.cover(self.coil, block) {
            return self.near_each(block);
        }
        let forms = self.near.forms(block);
        std::array::from_fn(|column| {
            let inductance = forms.inductance[column];
            let bound = bound(strain(block, column), forms.remainder[column]) + ROUNDING * inductance;
            BoundedInductance { inductance, bound }
        })
    }

    /// The same about each sample's own length, where those are far apart.
    fn near_each(&mut self, block: &TurnBlock) -> [BoundedInductance; WIDTH] {
        let mut values = [BoundedInductance { inductance: 0.0, bound: f64::INFINITY }; WIDTH];
        for (group, values) in values.chunks_exact_mut(LANES).enumerate() {
            for (lanes, row) in self.lanes.iter_mut().zip(block.displacements.chunks_exact(WIDTH)) {
                lanes.copy_from_slice(&row[group * LANES..][..LANES]);
            }
            let pitches = std::array::from_fn(|lane| block.pitches[group * LANES + lane]);
            self.expansion.expand(self.coil, pitches);
            values.copy_from_slice(&bounded(&self.expansion, &self.lanes));
        }
        values
    }
}

/// ε: the largest change of neighbours' distance over the pitch.
fn strain(block: &TurnBlock, column: usize) -> f64 {
    let [least, largest] = &block.extent.neighbours;
    let change = largest[column].max(-least[column]).max(0.0);
    if block.extent.is_finite && block.pitches[column] > 0.0 { change / block.pitches[column] } else { f64::INFINITY }
}
