//! Turns of magnetic wire that move: what magnetisation adds to Maxwell's sum, to second order about an even spacing.
//!
//! Next door: what is found about one pitch (`node`), turns at an even spacing (`turns`), thin rings wherever they are (`super::super::maxwell`).

use nalgebra::DMatrix;

use super::coil::on_all_cores;
use super::grid::Grid;
use super::node::{Node, changes};
use super::turns::{SteelTurns, at_pitches, by_gap, thin};
use super::{PermeableRings, check_pitch};
use crate::error::{Error, check};
use crate::inductance::over_length::OverLength;
use crate::inductance::second_order::BoundedInductance;
use crate::motion::Windings;

/// Inductance of turns of magnetic wire near an even spacing.
///
/// L ≈ Maxwell's sum + E₀ + gᵀδ + ½ δᵀHδ, E = L of the magnetic turns less Maxwell's sum of thin rings, g and H its derivatives at the even spacing, δ the turns'
/// places from that of their own mean pitch
///
/// With A K = b on the wires' surfaces and L = D + cᵀK, y = A⁻ᵀc, of turns m and n: g_m = D_m + c_mᵀK + yᵀr_m and H_mn = D_mn + c_mnᵀK + yᵀr_mn +
/// w_nᵀA⁻¹r_m + w_mᵀA⁻¹r_n, r_m being the derivative of b − A K and w_m that of c − Aᵀy, each with K and y held. Maxwell's sum is exact. Over a range of pitches
/// g and H are found at four of them; between these the quadratic form is the polynomial in the logarithm of the gap between wires.
///
/// The bound is three times the largest |third-order part| over Σ_k |ε_k|³ that rows of five turns show, ε_k the change of a gap between neighbouring
/// wires as a share of the gap; with what the polynomials leave unsettled; infinite where a gap changes by more than a third, and there L takes magnetisation as that
/// of even turns.
///
/// Source:   bound currents as [`PermeableRings`]; derivatives by the adjoint equation.
/// Valid:    as [`SteelTurns`].
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
    even: SteelTurns,
    grid: Grid,
    /// At the pitches of the grid, the nearest first.
    nodes: Vec<Node>,
}

/// Pitches of a range at which g and H are found.
const NODES: usize = 4;
/// By which share of it a gap may change.
const MOST_CHANGED: f64 = 1.0 / 3.0;
/// Samples whose products are taken at once.
const BLOCK: usize = 256;
/// What differences and solutions may add, relative to L.
const ROUNDING: f64 = 1e-9;

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
        check(turns >= 2, "turns", turns as f64, "", "at least 2")?;
        check_pitch(pitch, wire_radius)?;
        let coil = thin(turns, coil_radius, wire_radius)?;
        Self::of(SteelTurns::over_pitches(&coil, wire_radius, permeability, [pitch; 2])?)
    }

    /// Of turns at any pitch that those at rest are told for; a pitch takes half a second of 52 turns.
    ///
    /// # Errors
    /// [`Error::Value`] for a permeability at which there is no solution.
    ///
    /// ```
    /// # let spring = coilsense::paper::s_t();
    /// use coilsense::inductance::{MaxwellSum, SelfDistance, SteelTurns, SteelWindings};
    /// let air = MaxwellSum::of_coil(&coilsense::inductance::theories::Coil::new(6.0, 8e-3, 1e-3)?, SelfDistance::GeometricMean);
    /// let turns = SteelWindings::of(SteelTurns::over(&air, 1e-3, 2.5, [16e-3, 20e-3])?)?;
    /// let shorter = turns.at_positions(&[0.0, 2.7e-3, 5.4e-3, 8.1e-3, 10.8e-3, 13.5e-3])?;
    /// let longer = turns.at_positions(&[0.0, 3.3e-3, 6.6e-3, 9.9e-3, 13.2e-3, 16.5e-3])?;
    /// assert!(shorter.inductance > longer.inductance && shorter.bound < 1e-5 * shorter.inductance);
    /// # Ok::<(), coilsense::Error>(())
    /// ```
    pub fn of(even: SteelTurns) -> Result<Self, Error> {
        let (turns, radius, wire) = (even.air.places().len(), even.air.coil_radius(), even.wire_radius);
        let grid = by_gap(even.pitches, wire, NODES);
        let node = |pitch: f64| Node::new(turns, [radius, wire, pitch], even.permeability);
        let nodes = on_all_cores(at_pitches(&grid, wire), node).into_iter().collect::<Result<_, _>>()?;
        Ok(Self { even, grid, nodes })
    }

    /// The same turns at rest.
    pub fn at_rest(&self) -> &SteelTurns {
        &self.even
    }

    /// L \[H\] of turns at positions \[m\] in rising order, shape `turns`, with the bound of its error.
    ///
    /// # Errors
    /// [`Error::Count`] for another number of turns; [`Error::Value`] for the first position that is not finite.
    pub fn at_positions(&self, positions: &[f64]) -> Result<BoundedInductance, Error> {
        let air = self.even.air.at_positions(positions)?;
        Ok(self.of_block(&[air], positions).remove(0))
    }

    /// The same of every sample of a motion, shape `samples`, whose chain carries the turns as [`crate::inductance::MaxwellSum::series`] has it.
    pub fn series(&self, windings: &Windings) -> Vec<BoundedInductance> {
        let air = self.even.air.series(windings);
        let carry = self.even.air.carry(windings.count());
        let mut series = Vec::with_capacity(air.len());
        let (mut buffer, mut positions) = (Vec::new(), Vec::new());
        // In blocks, so that the product of matrices does not leave the cache.
        for first in (0..air.len()).step_by(BLOCK) {
            let last = air.len().min(first + BLOCK);
            positions.clear();
            for sample in first..last {
                positions.extend_from_slice(carry.turns(windings.ends(sample), windings.row(sample), &mut buffer));
            }
            series.extend(self.of_block(&air[first..last], &positions));
        }
        series
    }

    /// L of samples whose Maxwell's sums are `air`, their turns' positions one after the other.
    fn of_block(&self, air: &[f64], positions: &[f64]) -> Vec<BoundedInductance> {
        let turns = self.even.air.places().len();
        let gap_at = |pitch: f64| pitch - 2.0 * self.even.wire_radius;
        let rows = || positions.chunks_exact(turns);
        let pitches: Vec<f64> =
            rows().map(|row| self.even.told((row[turns - 1] - row[0]) / (turns - 1) as f64)).collect();
        let mut moved = DMatrix::zeros(turns, air.len());
        for ((row, pitch), mut column) in rows().zip(&pitches).zip(moved.column_iter_mut()) {
            // About the middle of the turns: E does not change where all move together.
            let middle = row.iter().sum::<f64>() / turns as f64;
            let half = 0.5 * (turns - 1) as f64;
            for ((turn, place), moved) in row.iter().enumerate().zip(column.iter_mut()) {
                *moved = place - middle - (turn as f64 - half) * pitch;
            }
        }
        // By node, then sample.
        let forms: Vec<Vec<f64>> = self.nodes.iter().map(|node| node.forms(&moved)).collect();
        let share = self.even.air.windings() / turns as f64;
        let of_sample = |((sample, row), pitch): ((usize, &[f64]), &f64)| {
            let gap = gap_at(*pitch);
            let even = air[sample] + self.even.added(*pitch);
            let (most, cubes) = changes(row, *pitch, gap);
            if most > MOST_CHANGED {
                return BoundedInductance { inductance: even, bound: f64::INFINITY };
            }
            let (change, unsettled, third) = match (forms.as_slice(), self.nodes.as_slice()) {
                ([only], [node]) => (only[sample], 0.0, node.third),
                _ => {
                    let values: Vec<f64> = forms.iter().map(|form| form[sample]).collect();
                    let weights = self.grid.weights(gap.ln());
                    let change = weights.iter().zip(&values).map(|(weight, value)| weight * value).sum();
                    (change, self.grid.unsettled(&values), self.third_at(gap.ln()))
                }
            };
            let inductance = even + share * change;
            let left = share * (third * cubes + unsettled) + self.even.unsettled;
            BoundedInductance { inductance, bound: left + ROUNDING * inductance }
        };
        rows().enumerate().zip(&pitches).map(of_sample).collect()
    }

    /// The larger of the neighbouring nodes'.
    fn third_at(&self, place: f64) -> f64 {
        let after = self.nodes.partition_point(|node| node.place < place);
        let near = [after.saturating_sub(1), after.min(self.nodes.len() - 1)];
        near.into_iter().map(|node| self.nodes[node].third).fold(0.0, f64::max)
    }
}

impl OverLength for SteelWindings {
    fn at_length(&self, length: f64) -> f64 {
        self.even.at_length(length)
    }
}

#[cfg(test)]
mod tests {
    use rand::{RngExt, SeedableRng};
    use rand_pcg::Pcg64Mcg;

    use super::*;
    use crate::inductance::mutual::MU_0;
    use crate::inductance::permeable::disc::Disc;
    use crate::inductance::permeable::pairs::Pairs;

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
            |positions: &[f64]| solved(positions, pitch, permeability) - own.even.air.at_positions(positions).unwrap();
        assert!((own.even.added(pitch) / excess(&even) - 1.0).abs() < 1e-8);
        let gap = pitch - 2.0 * WIRE;
        let own = &own.nodes[0];
        let step = 0.04 * gap;
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
                            *place += pitch + share * (pitch - 2.0 * WIRE) * (2.0 * random.random::<f64>() - 1.0);
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
    fn over_a_range_the_bound_holds_at_every_length() {
        let mut random = Pcg64Mcg::seed_from_u64(5);
        let coil = thin(6, RADIUS, WIRE).unwrap();
        for (permeability, [from, to]) in [(2.5, [1.06, 2.4]), (5.0, [1.1, 1.5]), (2.5, [1.2, 1.2])] {
            let lengths = [from, to].map(|diameters| 6.0 * diameters * 2.0 * WIRE);
            let own = SteelWindings::of(SteelTurns::over(&coil, WIRE, permeability, lengths).unwrap()).unwrap();
            let mut sharpest = 0.0_f64;
            for number in 0..40 {
                let diameters = from + (to - from) * random.random::<f64>();
                let pitch = 2.0 * WIRE * diameters;
                let share = [0.0, 0.02, 0.1, 0.3][number % 4];
                let positions: Vec<f64> = (0..6)
                    .scan(0.3, |place, _| {
                        let here = *place;
                        *place += pitch + share * (pitch - 2.0 * WIRE) * (2.0 * random.random::<f64>() - 1.0);
                        Some(here)
                    })
                    .collect();
                let found = own.at_positions(&positions).unwrap();
                let exact = solved(&positions, pitch, permeability);
                let off = (found.inductance - exact).abs();
                sharpest = sharpest.max(off / found.bound);
                assert!(off <= found.bound, "{diameters} d, {share}: {off:e} of {:e}", found.bound);
                if share <= 0.02 {
                    assert!(found.bound < 2e-4 * exact, "{diameters} d, {share}: {:e}", found.bound / exact);
                }
            }
            println!("{permeability}: the bound is met to {sharpest}");
        }
    }

    #[test]
    fn a_series_is_its_samples_and_far_away_nothing_is_told() {
        let pitch = 1.3 * 2.0 * WIRE;
        let own = SteelWindings::about(6, RADIUS, WIRE, 2.0, pitch).unwrap();
        let samples: Vec<Vec<f64>> = (0..600)
            .map(|sample| (0..6).map(|turn| turn as f64 * pitch + 1e-4 * ((turn * sample) as f64).sin()).collect())
            .collect();
        let windings = Windings::new(vec![[0.0, 5.0 * pitch]; 600], samples.concat()).unwrap();
        for (sample, found) in samples.iter().zip(own.series(&windings)) {
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
