//! Turns of magnetic wire that move: what magnetisation adds to Maxwell's sum, to second order about an even spacing.
//!
//! Next door: turns at an even spacing (`susceptible`), thin rings wherever they are (`super::super::maxwell`).

use nalgebra::{DMatrix, DVector};

use super::disc::Disc;
use super::pairs::{Derivatives, Pairs};
use super::{PermeableRings, check_pitch};
use crate::error::{Error, count};
use crate::inductance::coil::Coil;
use crate::inductance::maxwell::MaxwellSum;
use crate::inductance::mutual::MU_0;
use crate::inductance::second_order::BoundedInductance;
use crate::inductance::self_term::SelfDistance;
use crate::motion::Windings;

/// Inductance of turns of magnetic wire near an even spacing.
///
/// L ≈ Maxwell's sum + E₀ + gᵀδ + ½ δᵀHδ, E = L of the magnetic turns less Maxwell's sum of thin rings, g and H its derivatives at the even spacing
///
/// With A K = b on the wires' surfaces and L = D + cᵀK, y = A⁻ᵀc, of turns m and n: g_m = D_m + c_mᵀK + yᵀr_m and H_mn = D_mn + c_mnᵀK + yᵀr_mn +
/// w_nᵀA⁻¹r_m + w_mᵀA⁻¹r_n, r_m being the derivative of b − A K and w_m that of c − Aᵀy, each with K and y held. Maxwell's sum is exact.
///
/// The bound is three times the largest |third-order part| over Σ_k |ε_k|³ that rows of five turns show, ε_k the change of a gap between neighbouring
/// wires as a share of the gap; infinite where a gap changes by more than a third.
///
/// Source:   bound currents as [`PermeableRings`]; derivatives by the adjoint equation.
/// Valid:    as [`PermeableRings`]; whole turns of one radius.
/// Accuracy: its own bound, which the tests hold against rows that are solved where their turns are.
///
/// ```
/// use coilsense::inductance::SteelWindings;
/// let turns = SteelWindings::about(5, 8e-3, 1e-3, 2.5, 3e-3)?;
/// let even = turns.at_positions(&[0.0, 3e-3, 6e-3, 9e-3, 12e-3])?;
/// let moved = turns.at_positions(&[0.0, 3.05e-3, 6e-3, 8.95e-3, 12e-3])?;
/// assert!(moved.inductance > even.inductance && moved.bound < 1e-5 * moved.inductance);
/// # Ok::<(), coilsense::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct SteelWindings {
    air: MaxwellSum,
    pitch: f64,
    /// Between the wires of neighbours \[m\].
    gap: f64,
    /// E₀ \[H\], g \[H/m\], H \[H/m²\].
    added: f64,
    gradient: DVector<f64>,
    hessian: DMatrix<f64>,
    /// Of Σ |ε|³ \[H\].
    third: f64,
}

/// By which share of it a gap may change.
const MOST_CHANGED: f64 = 1.0 / 3.0;
/// Turns of the row by which the third order is judged, and shares of the gap by which its turns move.
const JUDGED: usize = 5;
const MOVED: f64 = 0.2;
/// What is added to the third order that was seen.
const SAFETY: f64 = 3.0;

impl SteelWindings {
    /// About turns at a pitch \[m\]; the rest as of [`PermeableRings::new`].
    ///
    /// # Errors
    /// [`Error::Value`] as of [`PermeableRings::new`] and [`PermeableRings::inductance`], and for fewer than two turns.
    pub fn about(
        turns: usize,
        coil_radius: f64,
        wire_radius: f64,
        permeability: f64,
        pitch: f64,
    ) -> Result<Self, Error> {
        PermeableRings::new(turns, coil_radius, wire_radius, permeability)?;
        crate::error::check(turns >= 2, "turns", turns as f64, "", "at least 2")?;
        check_pitch(pitch, wire_radius)?;
        let own = Self::expanded(turns, [coil_radius, wire_radius, pitch], permeability, f64::INFINITY)?;
        let few = Self::expanded(JUDGED, [coil_radius, wire_radius, pitch], permeability, 0.0)?;
        let third = few.seen_third(&Disc::new(coil_radius, wire_radius, pitch), permeability)?;
        Ok(Self { third: SAFETY * third, ..own })
    }

    fn expanded(turns: usize, [radius, wire, pitch]: [f64; 3], permeability: f64, third: f64) -> Result<Self, Error> {
        let disc = Disc::new(radius, wire, pitch);
        let gap = pitch - 2.0 * wire;
        let even: Vec<f64> = (0..turns).map(|turn| turn as f64 * pitch).collect();
        let Derivatives { inductance, gradient, hessian } =
            Pairs::of(&disc, &even, Some(gap)).derivatives(permeability)?;
        let air = MaxwellSum::of_coil(&Coil::new(turns as f64, radius, wire)?, SelfDistance::GeometricMean);
        // A sum over turns alone has no ends to be given.
        let ends = [0.0, even[turns - 1]];
        let (air_gradient, air_hessian) = (air.gradient(ends, &even)?, air.hessian(ends, &even)?);
        let nodes = turns + 2;
        let gradient = DVector::from_fn(turns, |turn, _| MU_0 * gradient[turn] - air_gradient[turn + 1]);
        let hessian = DMatrix::from_fn(turns, turns, |row, column| {
            MU_0 * hessian[(row, column)] - air_hessian[(row + 1) * nodes + column + 1]
        });
        let added = MU_0 * inductance - air.at_positions(&even)?;
        Ok(Self { air, pitch, gap, added, gradient, hessian, third })
    }

    /// The largest third-order part over Σ |ε|³ \[H\] of rows of a few turns that are solved where they are: pulled apart evenly and one by one.
    fn seen_third(&self, disc: &Disc, permeability: f64) -> Result<f64, Error> {
        let even = |turn: usize| turn as f64 * self.pitch;
        let way = MOVED * self.gap;
        let moved: [&dyn Fn(usize) -> f64; 4] = [
            &|turn| turn as f64 * way,
            &|turn| -(turn as f64) * way,
            &|turn| if turn % 2 == 0 { 0.5 * way } else { -0.5 * way },
            &|turn| if turn + 1 < JUDGED { 0.0 } else { -way },
        ];
        let mut largest = 0.0_f64;
        for shape in moved {
            let positions: Vec<f64> = (0..JUDGED).map(|turn| even(turn) + shape(turn)).collect();
            let exact = MU_0 * Pairs::of(disc, &positions, None).inductance(permeability)?;
            let left = exact - self.at_positions(&positions)?.inductance;
            largest = largest.max(left.abs() / self.changes(&positions).1);
        }
        Ok(largest)
    }

    /// L \[H\] of turns at positions \[m\] in rising order, shape `turns`, with the bound of its error.
    ///
    /// # Errors
    /// [`Error::Count`] for another number of turns; [`Error::Value`] for the first position that is not finite.
    pub fn at_positions(&self, positions: &[f64]) -> Result<BoundedInductance, Error> {
        let air = self.air.at_positions(positions)?;
        let moved = self.moved(positions);
        Ok(self.bounded(air, positions, self.gradient.dot(&moved) + 0.5 * moved.dot(&(&self.hessian * &moved))))
    }

    /// The same of every sample of a motion, shape `samples`.
    ///
    /// # Errors
    /// [`Error::Count`] for another number of windings than turns.
    pub fn series(&self, windings: &Windings) -> Result<Vec<BoundedInductance>, Error> {
        count("windings", windings.count(), self.gradient.len())?;
        let air = self.air.series(windings);
        let turns = self.gradient.len();
        let mut series = Vec::with_capacity(air.len());
        // In blocks, so that the product of matrices does not leave the cache.
        for first in (0..air.len()).step_by(BLOCK) {
            let samples = BLOCK.min(air.len() - first);
            let mut moved = DMatrix::zeros(turns, samples);
            for (sample, mut column) in moved.column_iter_mut().enumerate() {
                column.copy_from(&self.moved(windings.row(first + sample)));
            }
            let bent = &self.hessian * &moved;
            for sample in 0..samples {
                let own = moved.column(sample);
                let added = self.gradient.dot(&own) + 0.5 * own.dot(&bent.column(sample));
                series.push(self.bounded(air[first + sample], windings.row(first + sample), added));
            }
        }
        Ok(series)
    }

    /// δ \[m\], about the even spacing in the middle of the turns: E does not change where all move together.
    fn moved(&self, positions: &[f64]) -> DVector<f64> {
        let middle = positions.iter().sum::<f64>() / positions.len() as f64;
        let half = 0.5 * (positions.len() - 1) as f64;
        DVector::from_fn(positions.len(), |turn, _| positions[turn] - middle - (turn as f64 - half) * self.pitch)
    }

    /// The largest change of a gap as a share of it, and Σ |ε|³.
    fn changes(&self, positions: &[f64]) -> (f64, f64) {
        let shares = positions.windows(2).map(|pair| ((pair[1] - pair[0] - self.pitch) / self.gap).abs());
        shares.fold((0.0, 0.0), |(most, cubes), share| (share.max(most), cubes + share.powi(3)))
    }

    fn bounded(&self, air: f64, positions: &[f64], change: f64) -> BoundedInductance {
        let (most, cubes) = self.changes(positions);
        let inductance = air + self.added + change;
        let bound = if most <= MOST_CHANGED { self.third * cubes + ROUNDING * inductance } else { f64::INFINITY };
        BoundedInductance { inductance, bound }
    }
}

/// Samples whose products are taken at once.
const BLOCK: usize = 256;
/// What differences and solutions may add, relative to L.
const ROUNDING: f64 = 1e-9;

#[cfg(test)]
mod tests {
    use rand::{RngExt, SeedableRng};
    use rand_pcg::Pcg64Mcg;

    use super::*;

    const RADIUS: f64 = 8.47e-3;
    const WIRE: f64 = 1.41e-3;

    fn solved(positions: &[f64], pitch: f64, permeability: f64) -> f64 {
        MU_0 * Pairs::of(&Disc::new(RADIUS, WIRE, pitch), positions, None).inductance(permeability).unwrap()
    }

    #[test]
    fn derivatives_are_those_of_rows_that_are_solved_where_their_turns_are() {
        let (pitch, permeability) = (1.2 * 2.0 * WIRE, 2.5);
        let own = SteelWindings::about(4, RADIUS, WIRE, permeability, pitch).unwrap();
        let even = [0.0, 1.0, 2.0, 3.0].map(|turn| turn * pitch);
        let excess =
            |positions: &[f64]| solved(positions, pitch, permeability) - own.air.at_positions(positions).unwrap();
        assert!((own.added / excess(&even) - 1.0).abs() < 1e-9);
        let step = 0.04 * own.gap;
        let moved = |turns: &[(usize, f64)]| {
            let mut positions = even;
            turns.iter().for_each(|(turn, by)| positions[*turn] += by);
            excess(&positions)
        };
        let largest = own.hessian.amax();
        for one in 0..4 {
            let slope = (8.0 * (moved(&[(one, step)]) - moved(&[(one, -step)]))
                - (moved(&[(one, 2.0 * step)]) - moved(&[(one, -2.0 * step)])))
                / (12.0 * step);
            assert!((slope - own.gradient[one]).abs() < 1e-4 * own.gradient.amax(), "{one}: {slope}");
            for other in 0..4 {
                let bend = (moved(&[(one, step), (other, step)])
                    - moved(&[(one, step), (other, -step)])
                    - moved(&[(one, -step), (other, step)])
                    + moved(&[(one, -step), (other, -step)]))
                    / (4.0 * step * step);
                let found = own.hessian[(one, other)];
                // What a difference of second order leaves.
                assert!((bend - found).abs() < 0.02 * largest, "{one}, {other}: {bend} and {found}");
            }
        }
        // All together, nothing changes.
        assert!(own.gradient.sum().abs() < 1e-9 * own.gradient.amax());
        assert!(own.hessian.column_sum().amax() < 1e-6 * largest);
    }

    #[test]
    fn the_bound_holds_where_turns_are_anywhere_near() {
        let mut random = Pcg64Mcg::seed_from_u64(3);
        let mut sharpest = 0.0_f64;
        for (diameters, permeability) in [(1.06, 2.0), (1.2, 2.5), (1.2, 10.0), (1.8, 2.5)] {
            let pitch = diameters * 2.0 * WIRE;
            for turns in [3, 6] {
                let own = SteelWindings::about(turns, RADIUS, WIRE, permeability, pitch).unwrap();
                for share in [0.02, 0.1, 0.3] {
                    let positions: Vec<f64> = (0..turns)
                        .scan(0.0, |place, _| {
                            let here = *place;
                            *place += pitch + share * own.gap * (2.0 * random.random::<f64>() - 1.0);
                            Some(here)
                        })
                        .collect();
                    let found = own.at_positions(&positions).unwrap();
                    let off = (found.inductance - solved(&positions, pitch, permeability)).abs();
                    sharpest = sharpest.max(off / found.bound);
                    assert!(
                        off <= found.bound,
                        "{turns} at {diameters} d, {permeability}, {share}: {off:e} of {:e}",
                        found.bound
                    );
                }
            }
        }
        println!("the bound is met to {sharpest}");
        // It tells something: it is no hundred times too wide.
        assert!(sharpest > 0.01, "{sharpest}");
    }

    #[test]
    fn a_series_is_its_samples_and_far_away_nothing_is_told() {
        let pitch = 1.3 * 2.0 * WIRE;
        let own = SteelWindings::about(6, RADIUS, WIRE, 2.0, pitch).unwrap();
        let samples: Vec<Vec<f64>> = (0..600)
            .map(|sample| (0..6).map(|turn| turn as f64 * pitch + 1e-4 * ((turn * sample) as f64).sin()).collect())
            .collect();
        let windings = Windings::new(vec![[0.0, 5.0 * pitch]; 600], samples.concat()).unwrap();
        for (sample, found) in samples.iter().zip(own.series(&windings).unwrap()) {
            let alone = own.at_positions(sample).unwrap();
            let off = (found.inductance / alone.inductance - 1.0).abs() + (found.bound / alone.bound - 1.0).abs();
            // Rounding, in another order.
            assert!(off < 1e-12, "{off:e}");
        }
        let far: Vec<f64> = (0..6).map(|turn| 1.2 * turn as f64 * pitch).collect();
        assert!(own.at_positions(&far).unwrap().bound.is_infinite());
        assert!(own.at_positions(&far[..5]).is_err() && SteelWindings::about(1, RADIUS, WIRE, 2.0, pitch).is_err());
        let message = SteelWindings::about(6, RADIUS, WIRE, 2.0, 2.0 * WIRE).unwrap_err().to_string();
        assert!(message.contains("pitch must be at least 1.04 wire diameters"), "{message}");
    }
}
