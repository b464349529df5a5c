//! L to second order of many samples at once, about uniform turns of each sample's own length: coefficients are polynomials in the pitch.
//!
//! Next door: coefficients at one pitch (`expansion`), the samples (`turn_block`), who asks (`within`), the bound (`second_order`).

use pulp::{Simd, WithSimd};

use super::chebyshev::Interpolation;
use super::expansion::{Expansion, LANES};
use super::maxwell::MaxwellSum;
use super::squares;
use super::turn_block::{Columns, TurnBlock};
use crate::motion::WIDTH;
use crate::simd::dispatch;

/// Half of the range of pitches that polynomials of degree 7 are good for, relative to its middle: with ρ ≥ 300 of the ellipse down to a
/// quarter of the middle, where M, M′, M″ are at most 4³, 4⁴, 4⁵ as large (−d ln|M‴|/d ln h < 6, see `second_order`), they are off by
/// at most 4 · 4⁵ ρ⁻⁷/(ρ − 1) = 6e-17 of themselves.
const HALF_RANGE: f64 = 0.005;

/// Coefficients of L to second order for pitches in a range, as polynomials in z = (p − p0)/w from −1 to 1, lowest power first.
#[derive(Debug, Clone)]
pub(super) struct NearUniform {
    /// Pitches they are good for \[m\].
    range: [f64; 2],
    /// How many coefficients a polynomial has: one where there is but one pitch.
    terms: usize,
    /// L0 \[H\].
    inductance: Vec<f64>,
    /// ∂L/∂x_t \[H/m\] of the first half of the turns; the others' are the opposite.
    gradient: Vec<f64>,
    /// M″(ap) \[H/m²\], by lag.
    curvatures: Vec<f64>,
    /// At least ⅓ |M‴(ap)| ap \[H/m²\] at every pitch of the range, by lag.
    remainders: Vec<f64>,
    expansion: Expansion,
    interpolation: Interpolation,
    /// Of a block, by lag.
    squares: Vec<Columns>,
}

/// The second-order form of each sample, and what its bound is made of.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Forms {
    /// L \[H\].
    pub(super) inductance: Columns,
    /// Σ_a ⅓ |M‴(ap)| ap Σ_i e² \[H\].
    pub(super) remainder: Columns,
}

impl NearUniform {
    pub(super) fn new(turns: usize) -> Self {
        Self {
            range: [f64::NAN; 2],
            terms: 1,
            inductance: Vec::new(),
            gradient: Vec::new(),
            curvatures: Vec::new(),
            remainders: Vec::new(),
            expansion: Expansion::new(turns),
            interpolation: Interpolation::new(LANES),
            squares: Vec::new(),
        }
    }

    /// Makes the coefficients good for a block; whether its pitches are near enough to each other.
    pub(super) fn cover(&mut self, coil: &MaxwellSum, block: &TurnBlock) -> bool {
        let [least, largest] = block.pitch_range();
        let [low, high] = self.range;
        if low <= least && largest <= high {
            return true;
        }
        if !(least > 0.0 && largest.is_finite()) {
            return false;
        }
        let is_near = |[low, high]: [f64; 2]| high - low <= HALF_RANGE * (high + low);
        // With room for the next block, and with what was before, where that is near enough.
        let room = 0.1 * (largest - least);
        let wide = [(least - room).min(low), (largest + room).max(high)];
        let range = [wide, [least, largest]].into_iter().find(|range| is_near(*range));
        let Some(range) = range else { return false };
        self.range = range;
        self.fill(coil);
        true
    }

    fn fill(&mut self, coil: &MaxwellSum) {
        let [low, high] = self.range;
        let (middle, half) = (0.5 * (low + high), 0.5 * (high - low));
        self.terms = if low == high { 1 } else { LANES };
        let nodes = std::array::from_fn(|node| middle + half * self.interpolation.nodes()[node]);
        self.expansion.expand(coil, if self.terms == 1 { [low; LANES] } else { nodes });
        let (terms, interpolation) = (self.terms, &self.interpolation);
        let polynomials = |rows: &[[f64; LANES]], out: &mut Vec<f64>| {
            out.clear();
            for row in rows {
                let begin = out.len();
                out.resize(begin + terms, 0.0);
                match terms {
                    1 => out[begin] = row[0],
                    _ => interpolation.coefficients(row, &mut out[begin..]),
                }
            }
        };
        let turns = self.expansion.gradient.len();
        polynomials(&[self.expansion.inductance], &mut self.inductance);
        polynomials(&self.expansion.gradient[..turns / 2], &mut self.gradient);
        polynomials(&self.expansion.curvatures, &mut self.curvatures);
        // |M‴| falls, by less than h⁻⁶: from the first node's value to one that no pitch of the range exceeds.
        let first = self.expansion.pitches[0];
        let rise = (first / low).powi(6) * (high / first);
        self.remainders = self.expansion.remainders.iter().map(|lanes| rise * lanes[0]).collect();
    }

    /// The remainder of turns up to `lags` apart only, which is less than the whole.
    pub(super) fn remainder_of(&mut self, block: &TurnBlock, lags: usize) -> Columns {
        self.pairs(block, lags).remainder
    }

    /// L0 \[H\] of every sample.
    pub(super) fn uniform(&self, block: &TurnBlock) -> Columns {
        polynomial::<false>(&self.inductance, &self.places(block))
    }

    /// The form of every sample.
    pub(super) fn forms(&mut self, block: &TurnBlock) -> Forms {
        let mut forms = self.pairs(block, self.remainders.len());
        dispatch(AddLine { near: self, block, forms: &mut forms });
        forms
    }

    /// ½ δᵀHδ and the remainder of turns up to `lags` apart.
    fn pairs(&mut self, block: &TurnBlock, lags: usize) -> Forms {
        let mut forms = Forms { inductance: [0.0; WIDTH], remainder: [0.0; WIDTH] };
        let mut buffer = std::mem::take(&mut self.squares);
        buffer.resize(self.remainders.len(), [0.0; WIDTH]);
        let squares = &mut buffer[..lags.min(self.remainders.len())];
        squares::fill(block, squares);
        dispatch(AddPairs { near: self, block, squares, forms: &mut forms });
        self.squares = buffer;
        forms
    }

    /// z of every sample.
    #[inline(always)]
    fn places(&self, block: &TurnBlock) -> Columns {
        let [low, high] = self.range;
        let (middle, per_half) = (0.5 * (low + high), if high > low { 2.0 / (high - low) } else { 0.0 });
        let mut places = [0.0; WIDTH];
        for (place, pitch) in places.iter_mut().zip(&block.pitches) {
            *place = (pitch - middle) * per_half;
        }
        places
    }
}

/// Horner's scheme for every column.
#[inline(always)]
fn polynomial<const FUSED: bool>(coefficients: &[f64], places: &Columns) -> Columns {
    let (last, rest) = match coefficients.split_last() {
        Some((last, rest)) => (*last, rest),
        None => (0.0, coefficients),
    };
    let mut values = [last; WIDTH];
    for coefficient in rest.iter().rev() {
        for (value, place) in values.iter_mut().zip(places) {
            *value = if FUSED { value.mul_add(*place, *coefficient) } else { *value * place + coefficient };
        }
    }
    values
}

/// Adds ½ δᵀHδ and the remainder of pairs as far apart as there are squares for.
struct AddPairs<'a> {
    near: &'a NearUniform,
    block: &'a TurnBlock,
    squares: &'a [Columns],
    forms: &'a mut Forms,
}

impl WithSimd for AddPairs<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        let places = self.near.places(self.block);
        let (places, _) = S::as_simd_f64s(&places);
        let (inductance, _) = S::as_mut_simd_f64s(&mut self.forms.inductance);
        let (remainders, _) = S::as_mut_simd_f64s(&mut self.forms.remainder);
        for (column, place) in places.iter().enumerate() {
            let (mut sum, mut remainder) = (inductance[column], remainders[column]);
            let each = self.near.curvatures.chunks_exact(self.near.terms).zip(&self.near.remainders);
            for ((curvature, weight), squares) in each.zip(self.squares) {
                let square = S::as_simd_f64s(squares).0[column];
                let mut value = simd.splat_f64s(0.0);
                for coefficient in curvature.iter().rev() {
                    value = simd.mul_add_e_f64s(value, *place, simd.splat_f64s(*coefficient));
                }
                sum = simd.mul_add_e_f64s(value, square, sum);
                remainder = simd.mul_add_e_f64s(simd.splat_f64s(*weight), square, remainder);
            }
            (inductance[column], remainders[column]) = (sum, remainder);
        }
    }
}

/// Adds L0 and gᵀδ.
struct AddLine<'a> {
    near: &'a NearUniform,
    block: &'a TurnBlock,
    forms: &'a mut Forms,
}

impl AddLine<'_> {
    #[inline(always)]
    fn add<const FUSED: bool>(self) {
        let places = self.near.places(self.block);
        let turns = self.block.turns();
        let mut sums = [0.0; WIDTH];
        for (turn, gradient) in self.near.gradient.chunks_exact(self.near.terms).enumerate() {
            let gradient = polynomial::<FUSED>(gradient, &places);
            let first = &self.block.displacements[turn * WIDTH..][..WIDTH];
            let last = &self.block.displacements[(turns - 1 - turn) * WIDTH..][..WIDTH];
            for column in 0..WIDTH {
                sums[column] += gradient[column] * (first[column] - last[column]);
            }
        }
        let uniform = polynomial::<FUSED>(&self.near.inductance, &places);
        for column in 0..WIDTH {
            self.forms.inductance[column] += sums[column] + uniform[column];
        }
    }
}

impl WithSimd for AddLine<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) {
        if S::IS_SCALAR { self.add::<false>() } else { self.add::<true>() }
    }
}
