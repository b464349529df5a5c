//! Turns of magnetic wire wherever they are along the axis: their L, and how it changes with each of their places.
//!
//! Next door: turns that are all alike (`surface`), the sum that moves with them (`moving`).

use nalgebra::{DMatrix, DVector, Dyn, LU};

use super::disc::Disc;
use super::surface::{Felt, NODES};
use crate::error::Error;

/// Two turns, as one feels the other and how that changes with the distance.
#[derive(Debug, Clone)]
struct Pair {
    /// From −1 to 1: whether the turn that feels is farther along than the other.
    sign: f64,
    felt: [Felt; 3],
}

/// Turns and what they do to each other.
pub(super) struct Pairs {
    turns: usize,
    own: Felt,
    /// By the turn that feels and the other; none of a turn with itself.
    pairs: Vec<Option<Pair>>,
}

/// L over μ₀ \[m\], and its first and second derivatives with the turns' places.
pub(super) struct Derivatives {
    pub inductance: f64,
    pub gradient: DVector<f64>,
    pub hessian: DMatrix<f64>,
}

/// Step of the differences as a share of the gap between wires, on whose scale all changes.
const STEP: f64 = 0.03;

impl Pairs {
    /// Of turns at rising places \[m\]; with derivatives where a gap between their wires \[m\] is given.
    pub fn of(disc: &Disc, places: &[f64], gap: Option<f64>) -> Self {
        let turns = places.len();
        let mut known: Vec<(f64, [Felt; 3])> = Vec::new();
        let mut pairs = Vec::with_capacity(turns * turns);
        for at in 0..turns {
            for from in 0..turns {
                if at == from {
                    pairs.push(None);
                    continue;
                }
                let apart = (places[at] - places[from]).abs();
                let between = at.abs_diff(from);
                let found = known.iter().position(|(other, _)| (other - apart).abs() <= 1e-12 * apart);
                let index = found.unwrap_or_else(|| {
                    known.push((apart, Self::felt(disc, between, apart, gap)));
                    known.len() - 1
                });
                let felt =
                    if at > from { known[index].1.clone() } else { known[index].1.each_ref().map(Felt::mirrored) };
                pairs.push(Some(Pair { sign: if at > from { 1.0 } else { -1.0 }, felt }));
            }
        }
        Self { turns, own: Felt::own(disc), pairs }
    }

    /// What a turn feels of one before it, and its first two derivatives with the distance; zeros without a gap.
    fn felt(disc: &Disc, between: usize, apart: f64, gap: Option<f64>) -> [Felt; 3] {
        let at = |by: f64| Felt::of(disc, between, apart + by);
        let here = at(0.0);
        let Some(gap) = gap else {
            let none = here.scaled(0.0);
            return [here, none.clone(), none];
        };
        // Of fourth order, from both sides at two distances.
        let h = STEP * gap;
        let [near, far] = [1.0, 2.0].map(|times| [at(times * h), at(-times * h)]);
        let first = near[0].minus(&near[1]).scaled(8.0).minus(&far[0].minus(&far[1])).scaled(1.0 / (12.0 * h));
        let sums = [near, far].map(|[above, below]| above.plus(&below));
        let second = sums[0].scaled(16.0).minus(&sums[1]).minus(&here.scaled(30.0)).scaled(1.0 / (12.0 * h * h));
        [here, first, second]
    }

    fn pair(&self, at: usize, from: usize) -> Option<&Pair> {
        self.pairs[at * self.turns + from].as_ref()
    }

    /// A, b and c of L = D + cᵀK, A K = b; and D.
    fn system(&self, permeability: f64) -> (DMatrix<f64>, DVector<f64>, DVector<f64>, f64) {
        let twice = 2.0 * (permeability - 1.0) / (permeability + 1.0);
        let size = self.turns * NODES;
        let mut matrix = DMatrix::identity(size, size);
        let (mut right, mut seen) = (DVector::zeros(size), DVector::zeros(size));
        let mut currents = 0.0;
        for at in 0..self.turns {
            for from in 0..self.turns {
                let felt = self.pair(at, from).map_or(&self.own, |pair| &pair.felt[0]);
                let mut block = matrix.view_mut((at * NODES, from * NODES), (NODES, NODES));
                block -= twice * &felt.block;
                let mut rows = right.rows_mut(at * NODES, NODES);
                rows += twice * permeability * &felt.field;
                let mut rows = seen.rows_mut(at * NODES, NODES);
                rows += &felt.seen;
                currents += permeability * felt.link;
            }
        }
        (matrix, right, seen, currents)
    }

    /// A⁻¹ B.
    fn solved(matrix: &LU<f64, Dyn, Dyn>, right: &DMatrix<f64>, permeability: f64) -> Result<DMatrix<f64>, Error> {
        matrix.solve(right).ok_or_else(|| unsolved(permeability))
    }

    /// A⁻ᵀ c: PA = LU, so that Aᵀ y = c where Uᵀ z = c, Lᵀ w = z, y = Pᵀ w.
    fn solved_transposed(
        matrix: &LU<f64, Dyn, Dyn>,
        right: &DVector<f64>,
        permeability: f64,
    ) -> Result<DVector<f64>, Error> {
        let upper = matrix.lu_internal().tr_solve_upper_triangular(right).ok_or_else(|| unsolved(permeability))?;
        let mut solution = matrix.l().tr_solve_lower_triangular(&upper).ok_or_else(|| unsolved(permeability))?;
        matrix.p().inv_permute_rows(&mut solution);
        Ok(solution)
    }

    /// L over μ₀ \[m\].
    ///
    /// # Errors
    /// [`Error::Value`] for a permeability at which there is no solution.
    pub fn inductance(&self, permeability: f64) -> Result<f64, Error> {
        let (matrix, right, seen, currents) = self.system(permeability);
        let surface = Self::solved(&matrix.lu(), &DMatrix::from_columns(&[right]), permeability)?;
        Ok(currents + seen.dot(&surface.column(0)))
    }

    /// L with its derivatives.
    ///
    /// # Errors
    /// As [`Self::inductance`].
    pub fn derivatives(&self, permeability: f64) -> Result<Derivatives, Error> {
        let twice = 2.0 * (permeability - 1.0) / (permeability + 1.0);
        let drive = twice * permeability;
        let turns = self.turns;
        let (matrix, right, seen, currents) = self.system(permeability);
        let matrix = matrix.lu();
        let adjoint = Self::solved_transposed(&matrix, &seen, permeability)?;
        let surface = Self::solved(&matrix, &DMatrix::from_columns(&[right]), permeability)?;
        let inductance = currents + seen.dot(&surface.column(0));
        let mut gradient = DVector::zeros(turns);
        let mut hessian = DMatrix::zeros(turns, turns);
        // r and w, a column for each turn that moves.
        let size = turns * NODES;
        let (mut pushes, mut sees) = (DMatrix::zeros(size, turns), DMatrix::zeros(size, turns));
        for at in 0..turns {
            for from in 0..turns {
                let Some(Pair { sign, felt: [_, first, second] }) = self.pair(at, from) else { continue };
                let own = surface.view((at * NODES, 0), (NODES, 1));
                let other = surface.view((from * NODES, 0), (NODES, 1));
                let back = adjoint.view((at * NODES, 0), (NODES, 1));
                let whole = |felt: &Felt| {
                    let pushed = drive * &felt.field + twice * (&felt.block * other).column(0);
                    permeability * felt.link + felt.seen.dot(&own.column(0)) + pushed.dot(&back.column(0))
                };
                let slope = sign * whole(first);
                gradient[at] += slope;
                gradient[from] -= slope;
                let bend = whole(second);
                for (row, column, times) in [(at, at, 1.0), (from, from, 1.0), (at, from, -1.0), (from, at, -1.0)] {
                    hessian[(row, column)] += times * bend;
                }
                let pushed = *sign * (drive * &first.field + twice * (&first.block * other).column(0));
                let seen = *sign * &first.seen;
                let returned = *sign * twice * (first.block.transpose() * back).column(0);
                for (turn, times) in [(at, 1.0), (from, -1.0)] {
                    let mut rows = pushes.view_mut((at * NODES, turn), (NODES, 1));
                    rows += times * &pushed;
                    let mut rows = sees.view_mut((at * NODES, turn), (NODES, 1));
                    rows += times * &seen;
                    let mut rows = sees.view_mut((from * NODES, turn), (NODES, 1));
                    rows += times * &returned;
                }
            }
        }
        let answered = sees.transpose() * Self::solved(&matrix, &pushes, permeability)?;
        hessian += &answered + answered.transpose();
        Ok(Derivatives { inductance, gradient, hessian })
    }
}

/// Why there is no solution.
fn unsolved(permeability: f64) -> Error {
    Error::Value {
        field: Some("permeability"),
        quantity: "permeability".into(),
        value: permeability,
        unit: "",
        allowed: "one at which the wires' surfaces can be solved for".into(),
    }
}
