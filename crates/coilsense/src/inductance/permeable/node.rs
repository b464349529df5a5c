//! L of magnetic turns less that of thin rings about one pitch: to second order in their places, and what the third order adds.
//!
//! Next door: what is made of it over pitches (`moving`), turns wherever they are (`pairs`).

use nalgebra::{DMatrix, DVector, DVectorView};

use super::disc::Disc;
use super::pairs::{Derivatives, Pairs};
use super::turns::{logarithm, thin};
use crate::error::Error;
use crate::inductance::maxwell::MaxwellSum;
use crate::inductance::mutual::MU_0;

/// How L of magnetic turns, less Maxwell's sum, changes with their places about one pitch.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Node {
    /// ln of the gap between wires \[m\].
    pub place: f64,
    /// g \[H/m\], H \[H/m²\].
    pub gradient: DVector<f64>,
    pub hessian: DMatrix<f64>,
    /// Of Σ |ε|³ \[H\], with what is added for safety.
    pub third: f64,
}

/// Turns of the row by which the third order is judged, and shares of the gap by which its turns move.
const JUDGED: usize = 5;
const MOVED: f64 = 0.2;
/// What is added to the third order that was seen.
const SAFETY: f64 = 3.0;

impl Node {
    pub fn new(turns: usize, [radius, wire, pitch]: [f64; 3], permeability: f64) -> Result<Self, Error> {
        let own = Excess::of(turns, [radius, wire, pitch], permeability)?;
        let third = SAFETY * Excess::of(JUDGED, [radius, wire, pitch], permeability)?.seen_third(permeability)?;
        let (gradient, hessian) = (own.gradient, own.hessian);
        Ok(Self { place: logarithm(pitch, wire), gradient, hessian, third })
    }

    /// gᵀδ + ½ δᵀHδ \[H\] of every column.
    pub fn forms(&self, moved: &DMatrix<f64>) -> Vec<f64> {
        let bent = &self.hessian * moved;
        let form =
            |(own, bent): (DVectorView<'_, f64>, DVectorView<'_, f64>)| self.gradient.dot(&own) + 0.5 * own.dot(&bent);
        moved.column_iter().zip(bent.column_iter()).map(form).collect()
    }
}

/// L of magnetic turns less that of thin rings, about one pitch.
struct Excess {
    disc: Disc,
    thin: MaxwellSum,
    /// E₀ \[H\].
    added: f64,
    gradient: DVector<f64>,
    hessian: DMatrix<f64>,
}

impl Excess {
    fn of(turns: usize, [radius, wire, pitch]: [f64; 3], permeability: f64) -> Result<Self, Error> {
        let disc = Disc::new(radius, wire, pitch);
        let even = evenly(turns, pitch);
        let Derivatives { inductance, gradient, hessian } =
            Pairs::of(&disc, &even, Some(pitch - 2.0 * wire)).derivatives(permeability)?;
        let thin = thin(turns, radius, wire)?;
        // A sum over turns alone has no ends to be given.
        let ends = [0.0, even[turns - 1]];
        let (of_thin, bends) = (thin.gradient(ends, &even)?, thin.hessian(ends, &even)?);
        let nodes = turns + 2;
        let gradient = DVector::from_fn(turns, |turn, _| MU_0 * gradient[turn] - of_thin[turn + 1]);
        let hessian = DMatrix::from_fn(turns, turns, |row, column| {
            MU_0 * hessian[(row, column)] - bends[(row + 1) * nodes + column + 1]
        });
        let added = MU_0 * inductance - thin.at_positions(&even)?;
        Ok(Self { disc, thin, added, gradient, hessian })
    }

    /// The largest third-order part over Σ |ε|³ \[H\] of turns that are solved where they are: pulled apart evenly and one by one.
    fn seen_third(&self, permeability: f64) -> Result<f64, Error> {
        let (turns, pitch) = (self.gradient.len(), self.disc.pitch);
        let gap = pitch - 2.0 * self.disc.wire;
        let way = MOVED * gap;
        let moved: [&dyn Fn(usize) -> f64; 4] = [
            &|turn| turn as f64 * way,
            &|turn| -(turn as f64) * way,
            &|turn| if turn % 2 == 0 { 0.5 * way } else { -0.5 * way },
            &|turn| if turn + 1 < turns { 0.0 } else { -way },
        ];
        let mut largest = 0.0_f64;
        for shape in moved {
            let by = DVector::from_fn(turns, |turn, _| shape(turn));
            let positions: Vec<f64> = evenly(turns, pitch).iter().zip(&by).map(|(even, by)| even + by).collect();
            let exact = MU_0 * Pairs::of(&self.disc, &positions, None).inductance(permeability)?;
            let to_second = self.added + self.gradient.dot(&by) + 0.5 * by.dot(&(&self.hessian * &by));
            let left = exact - self.thin.at_positions(&positions)? - to_second;
            largest = largest.max(left.abs() / changes(&positions, pitch, gap).1);
        }
        Ok(largest)
    }
}

/// The largest change of a gap as a share of it, and Σ |ε|³.
pub(super) fn changes(positions: &[f64], pitch: f64, gap: f64) -> (f64, f64) {
    let shares = positions.windows(2).map(|pair| ((pair[1] - pair[0] - pitch) / gap).abs());
    shares.fold((0.0, 0.0), |(most, cubes), share| (share.max(most), cubes + share.powi(3)))
}

/// Places of turns at a pitch \[m\].
fn evenly(turns: usize, pitch: f64) -> Vec<f64> {
    (0..turns).map(|turn| turn as f64 * pitch).collect()
}
