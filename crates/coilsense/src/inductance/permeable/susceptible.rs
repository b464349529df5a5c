//! A row of turns for every permeability at once.
//!
//! Next door: what their surfaces feel of each other (`surface`), the row as people know it (`super`).

use nalgebra::{DMatrix, DVector};

use super::surface::Row;
use crate::inductance::mutual::MU_0;

/// The inductance of a row of turns over the permeability of its wire.
///
/// K − 2λ G K = 2λ μ_r g on the surfaces, G K and g the fields along them of K and of the wires' current over μ₀, λ = (μ_r − 1)/(μ_r + 1): one G
/// for every λ, so one Krylov space {g, G g, G² g …} holds K for all of them. G maps what is rough to almost nothing, and some ten
/// directions are enough.
///
/// Source:   systems that differ by a multiple of the identity, by Arnoldi's method, `[Simoncini2007]` 14.1.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Susceptible {
    /// ∬ j M j/μ₀ \[m\].
    of_currents: f64,
    /// G among the directions, an upper Hessenberg matrix.
    felt: DMatrix<f64>,
    /// g along the first direction, which is all of it.
    field: f64,
    /// What each direction adds to ∬ j M K/μ₀.
    seen: DVector<f64>,
}

/// Most directions; never reached from pitches of 1.04 wire diameters on.
const MOST: usize = 80;
/// The largest permeability that they must serve; what the next direction may still change of L there.
const SERVED: f64 = 20.0;
const ENOUGH: f64 = 1e-9;

impl Susceptible {
    /// Of so many of a row's turns.
    pub fn new(row: &Row, turns: usize) -> Self {
        let (felt, field, seen) = (row.felt(turns), row.field(turns), row.seen(turns));
        let size = field.norm();
        let mut directions = vec![field / size];
        let mut among: DMatrix<f64> = DMatrix::zeros(MOST + 1, MOST);
        let mut so_far = Self {
            of_currents: row.of_currents(turns),
            felt: DMatrix::zeros(0, 0),
            field: size,
            seen: DVector::zeros(0),
        };
        let mut before = f64::NAN;
        for count in 1..=MOST.min(seen.len()) {
            let mut next = &felt * &directions[count - 1];
            // Twice, as once leaves what rounding put in.
            for _ in 0..2 {
                for (index, direction) in directions.iter().enumerate() {
                    let along = direction.dot(&next);
                    among[(index, count - 1)] += along;
                    next.axpy(-along, direction, 1.0);
                }
            }
            so_far.felt = among.view((0, 0), (count, count)).into_owned();
            so_far.seen = DVector::from_iterator(count, directions.iter().map(|direction| direction.dot(&seen)));
            let now = so_far.inductance(SERVED);
            let left = next.norm();
            if (now - before).abs() <= ENOUGH * now.abs() || left <= f64::EPSILON * among[(0, 0)].abs() {
                break;
            }
            before = now;
            among[(count, count - 1)] = left;
            directions.push(next / left);
        }
        so_far
    }

    /// L \[H\]; NaN where there is no solution.
    pub fn inductance(&self, permeability: f64) -> f64 {
        let twice = 2.0 * (permeability - 1.0) / (permeability + 1.0);
        let count = self.seen.len();
        let mut right = DVector::zeros(count);
        right[0] = twice * permeability * self.field;
        let matrix = DMatrix::identity(count, count) - twice * &self.felt;
        let added = matrix.lu().solve(&right).map_or(f64::NAN, |currents| currents.dot(&self.seen));
        MU_0 * (permeability * self.of_currents + added)
    }
}
