//! Turns of magnetic wire at an even spacing: what magnetisation adds to Maxwell's sum, over length.
//!
//! Next door: the same turns where they move (`moving`), a whole coil with the current along it and a radius that shrinks (`coil`).

use super::coil::on_all_cores;
use super::disc::Disc;
use super::grid::{Grid, Polynomial};
use super::surface::Row;
use super::susceptible::Susceptible;
use super::{CLOSE, MOST_TURNS, check_permeability};
use crate::error::{Error, check};
use crate::inductance::coil::Coil;
use crate::inductance::maxwell::MaxwellSum;
use crate::inductance::over_length::OverLength;
use crate::inductance::self_term::SelfDistance;

/// A coil's inductance over length, its wire magnetic: Maxwell's sum and what magnetisation adds.
///
/// L = Maxwell's sum + (1 − f) E_n + f E_(n+1), n = ⌊N⌋, f = N − n, E_n = L_n of [`super::PermeableRings`] less Maxwell's sum of n thin rings
///
/// The rings are solved at nine lengths, between which the addition is the polynomial in the logarithm of the gap between wires that passes through them.
///
/// Source:   bound currents as [`super::PermeableRings`]; fractions as [`super::SteelCoil`].
/// Valid:    as [`super::PermeableRings`], radius as it is; a coil of one radius, 2 to 150 turns. Turns nearer than 1.02 wire diameters count as those at 1.02,
///           lengths outside of the range as its nearest end.
/// Accuracy: over 1.05 to 2.4 wire diameters the polynomial is off by 2e-6 of L for μ_r 2.5 (tests); fractions 1e-3 of what magnetisation adds.
///
/// ```
/// # let spring = coilsense::paper::s_t();
/// use coilsense::inductance::{MaxwellSum, OverLength, SelfDistance, SteelTurns};
/// let air = MaxwellSum::new(&spring, SelfDistance::GeometricMean);
/// let steel = SteelTurns::over(&air, spring.wire_radius(), 2.5, [0.2, 0.25])?;
/// let more = steel.at_length(0.23) / air.at_length(0.23) - 1.0;
/// assert!((0.05..0.2).contains(&more), "{more}");
/// # Ok::<(), coilsense::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct SteelTurns {
    pub(super) air: MaxwellSum,
    pub(super) wire_radius: f64,
    pub(super) permeability: f64,
    /// Between which it holds \[m\].
    pub(super) pitches: [f64; 2],
    /// Of what magnetisation adds \[H\], over ln of the gap between wires \[m\].
    added: Polynomial,
    /// What that polynomial may be off by \[H\].
    pub(super) unsettled: f64,
}

/// Lengths at which the rings are solved.
const NODES: usize = 9;
/// What L jumps by, as a share, where turns come so near that a finer rule is taken for them; ten times that of what magnetisation adds.
const RULES: f64 = 1e-6;

impl SteelTurns {
    /// - `coil`: in air, of 2 to 150 turns of one radius
    /// - `wire_radius`: \[m\]; `permeability`: of the wire, 1 to 20
    /// - `lengths`: the shortest and the longest in use \[m\]
    ///
    /// # Errors
    /// [`Error::Value`] for what is outside of that, and for lengths that are not above zero or do not rise.
    pub fn over(coil: &MaxwellSum, wire_radius: f64, permeability: f64, lengths: [f64; 2]) -> Result<Self, Error> {
        let [shortest, longest] = lengths;
        let rises = shortest > 0.0 && longest >= shortest && longest.is_finite();
        check(rises, "longest length", longest, "m", format!("from the shortest, {shortest} m, on, both above zero"))?;
        Self::over_pitches(coil, wire_radius, permeability, lengths.map(|length| length / coil.windings()))
    }

    /// Whether a coil of such wire is one that is told, without solving it.
    ///
    /// # Errors
    /// [`Error::Value`] for turns of several radii, another number of them than 2 to 150, and a permeability below 1 or above 20.
    pub fn covers(coil: &MaxwellSum, permeability: f64) -> Result<(), Error> {
        coil.check_even()?;
        check_permeability(permeability)?;
        let turns = coil.places().len();
        let allowed = format!("from 2 to {MOST_TURNS}");
        check((2..=MOST_TURNS).contains(&turns), "turns", turns as f64, "", allowed).map(|_| ())
    }

    pub(super) fn over_pitches(
        coil: &MaxwellSum,
        wire_radius: f64,
        permeability: f64,
        pitches: [f64; 2],
    ) -> Result<Self, Error> {
        Self::covers(coil, permeability)?;
        let (whole, share) = (coil.windings() as usize, coil.windings().fract());
        let thin = |turns: usize| thin(turns, coil.coil_radius(), wire_radius);
        let thin = [thin(whole)?, thin(whole + 1)?];
        let least = CLOSE * 2.0 * wire_radius;
        let pitches = pitches.map(|pitch| pitch.max(least));
        let added = |pitch: f64| {
            let row = Row::new(&Disc::new(coil.coil_radius(), wire_radius, pitch), whole + 1);
            let of = |turns: usize, thin: &MaxwellSum| {
                Susceptible::new(&row, turns).inductance(permeability) - thin.at_length(turns as f64 * pitch)
            };
            let more = if share > 0.0 { share * of(whole + 1, &thin[1]) } else { 0.0 };
            (1.0 - share) * of(whole, &thin[0]) + more
        };
        let grid = by_gap(pitches, wire_radius, NODES);
        let values = on_all_cores(at_pitches(&grid, wire_radius), added);
        let by_rules =
            |(pitch, added): (f64, &f64)| RULES * (thin[0].at_length(whole as f64 * pitch) + 10.0 * added.abs());
        let by_rules = at_pitches(&grid, wire_radius).into_iter().zip(&values).map(by_rules).fold(0.0, f64::max);
        let unsettled = if values.len() > 1 { grid.unsettled(&values) + by_rules } else { 0.0 };
        Ok(Self { air: coil.clone(), wire_radius, permeability, pitches, added: grid.through(&values), unsettled })
    }

    /// What magnetisation adds \[H\] at a pitch \[m\]; outside of the range that at its nearest end.
    pub(super) fn added(&self, pitch: f64) -> f64 {
        self.added.at(logarithm(self.told(pitch), self.wire_radius))
    }

    /// The nearest pitch that it holds for.
    pub(super) fn told(&self, pitch: f64) -> f64 {
        pitch.clamp(self.pitches[0], self.pitches[1])
    }

    /// Maxwell's sum, by itself.
    pub fn in_air(&self) -> &MaxwellSum {
        &self.air
    }

    /// Of the wire \[1\].
    pub fn permeability(&self) -> f64 {
        self.permeability
    }
}

impl OverLength for SteelTurns {
    fn at_length(&self, length: f64) -> f64 {
        self.air.at_length(length) + self.added(length / self.air.windings())
    }
}

/// A row of thin rings with which magnetic turns are compared.
pub(super) fn thin(turns: usize, radius: f64, wire: f64) -> Result<MaxwellSum, Error> {
    Ok(MaxwellSum::of_coil(&Coil::new(turns as f64, radius, wire)?, SelfDistance::GeometricMean))
}

/// Pitches of a range between which quantities are polynomials in ln of the gap between wires.
pub(super) fn by_gap(pitches: [f64; 2], wire_radius: f64, count: usize) -> Grid {
    Grid::new(pitches.map(|pitch| logarithm(pitch, wire_radius)), count)
}

/// The pitches \[m\] of such a grid.
pub(super) fn at_pitches(grid: &Grid, wire_radius: f64) -> Vec<f64> {
    grid.places().into_iter().map(|place| 2.0 * wire_radius + place.exp()).collect()
}

/// Of the gap between the wires of neighbours at a pitch \[m\].
pub(super) fn logarithm(pitch: f64, wire_radius: f64) -> f64 {
    (pitch - 2.0 * wire_radius).ln()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::inductance::PermeableRings;

    const RADIUS: f64 = 8.47e-3;
    const WIRE: f64 = 1.41e-3;

    fn air(windings: f64) -> MaxwellSum {
        MaxwellSum::of_coil(&Coil::new(windings, RADIUS, WIRE).unwrap(), SelfDistance::GeometricMean)
    }

    #[test]
    fn between_its_lengths_it_is_what_rings_are_that_are_solved_there() {
        let air = air(12.0);
        let length = |diameters: f64| 12.0 * diameters * 2.0 * WIRE;
        for (permeability, most) in [(1.0, 1e-6), (2.5, 2e-6), (10.0, 5e-6)] {
            let own = SteelTurns::over(&air, WIRE, permeability, [1.05, 2.4].map(length)).unwrap();
            let rings = PermeableRings::new(12, RADIUS, WIRE, permeability).unwrap();
            for diameters in [1.05, 1.06, 1.1, 1.2, 1.35, 1.6, 2.0, 2.3, 2.4] {
                let exact = rings.inductance(diameters * 2.0 * WIRE).unwrap();
                let off = own.at_length(length(diameters)) / exact - 1.0;
                assert!(
                    off.abs() < most && off.abs() < own.unsettled / exact,
                    "{permeability}, {diameters} d: {off:e}"
                );
            }
            assert!(own.unsettled < 1e-4 * own.at_length(length(1.2)));
        }
    }

    #[test]
    fn part_turns_count_in_proportion_and_lengths_outside_as_the_nearest_end() {
        let lengths = [36e-3, 60e-3];
        let own = SteelTurns::over(&air(11.5), WIRE, 2.5, lengths).unwrap();
        let pitch = 48e-3 / 11.5;
        let [less, more] = [11.0, 12.0].map(|turns| {
            SteelTurns::over(&air(turns), WIRE, 2.5, lengths.map(|length| length / 11.5 * turns)).unwrap().added(pitch)
        });
        let off = own.added(pitch) / (0.5 * (less + more)) - 1.0;
        assert!(off.abs() < 1e-7, "{off}");
        assert_eq!(own.added(1.0), own.added(60e-3 / 11.5));
        // Touching wires have no logarithm of their gap.
        assert!(SteelTurns::over(&air(11.5), WIRE, 2.5, [10e-3, 20e-3]).unwrap().at_length(15e-3).is_finite());
        for wrong in [[0.0, 0.1], [0.2, 0.1], [0.1, f64::NAN]] {
            assert!(SteelTurns::over(&air(4.0), WIRE, 2.5, wrong).is_err());
        }
        let message = SteelTurns::over(&air(4.0), WIRE, 60.0, lengths).unwrap_err().to_string();
        assert!(message.contains("permeability must be 1 to 20"), "{message}");
        assert!(SteelTurns::over(&air(1.0), WIRE, 2.0, lengths).is_err());
    }
}
