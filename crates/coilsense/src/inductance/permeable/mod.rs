//! Turns of magnetic wire: cold-drawn stainless steel has a permeability of 1 to 3, which adds a tenth to a spring's inductance.
//!
//! ```text
//! current in the wires (disc) ──► its field on their surfaces (surface) ──► what flows there, for every permeability (susceptible) ──► inductance
//! ```
//!
//! Next door: turns of wire that is not magnetic (`maxwell`).

mod coil;
mod disc;
mod field;
mod grid;
mod leads;
mod moving;
mod node;
mod pairs;
mod surface;
mod susceptible;
mod turns;

pub(crate) use self::coil::{Changes, LEAST_FITTED};
pub use self::coil::{SteelCoil, SteelCurve};
use self::disc::Disc;
pub use self::leads::{Leads, inductance_along};
pub use self::moving::SteelWindings;
use self::surface::Row;
use self::susceptible::Susceptible;
pub use self::turns::SteelTurns;
use crate::error::{Error, above_zero, check};
pub(crate) use crate::inductance::coil::MOST_PERMEABLE;

/// A row of equal turns of round wire of one permeability.
///
/// Next door: a whole coil, with the current along it and a radius that shrinks ([`SteelCoil`]).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PermeableRings {
    turns: usize,
    coil_radius: f64,
    wire_radius: f64,
    permeability: f64,
}

/// Most turns: their matrix grows with the square of their number.
const MOST_TURNS: usize = 150;
/// The shortest pitch in wire diameters for which magnetic wire is solved: nearer edges need more points, and real turns touch.
pub const LEAST_PITCH: f64 = 1.04;
/// The same where a hundredth of what magnetisation adds does not matter.
pub(crate) const CLOSE: f64 = 1.02;

impl PermeableRings {
    /// Turns by their number, the radius to the wire's middle \[m\], the wire's radius \[m\] and its relative permeability \[1\].
    ///
    /// # Errors
    /// [`Error::Value`] for no turn or more than 150, radii that are not above zero, a wire as thick as the coil, and a permeability below 1 or
    /// above 20.
    pub fn new(turns: usize, coil_radius: f64, wire_radius: f64, permeability: f64) -> Result<Self, Error> {
        let allowed = format!("1 to {MOST_TURNS}");
        check((1..=MOST_TURNS).contains(&turns), "turns", turns as f64, "", allowed)?;
        above_zero("coil_radius", coil_radius, "m")?;
        above_zero("wire_radius", wire_radius, "m")?;
        let allowed = format!("below the coil's {coil_radius} m");
        check(wire_radius < coil_radius, "wire_radius", wire_radius, "m", allowed)?;
        check_permeability(permeability)?;
        Ok(Self { turns, coil_radius, wire_radius, permeability })
    }

    /// Inductance \[H\] at a pitch \[m\], for direct current that goes round in the turns.
    ///
    /// L I² = ∬ j M (μ_r j + K), j ∝ 1/√((2πr)² + p²); K = 2λ B_t/μ₀ on the surfaces, λ = (μ_r − 1)/(μ_r + 1)
    ///
    /// Source:   magnetised bodies as bound currents, `[Jackson1999]` 5.10; solved on 24 points of each wire's edge, with Kress's weights for the
    ///           logarithm on the own edge.
    /// Valid:    one linear, uniform permeability; no axial current, no eddy currents: for stainless steel up to some 10 kHz, not for carbon steel
    ///           beyond a few hundred hertz. Pitch from 1.04 wire diameters on.
    /// Accuracy: 1e-5 of finite elements from 1.1 wire diameters on for μ_r up to 5, 2e-5 at 20; at 1.05 diameters 2e-5 up to 2, 1.2e-4 at 5, 2.5e-4 at 20 (tests).
    /// Differs:  j ∝ 1/√((2πr)² + p²) goes round; that of current along the wire has the share 2πr/√((2πr)² + p²) of it round, which makes L 4e-5 to 1.5e-4
    ///           larger (`reference/permeable_rings.py`).
    ///
    /// ```
    /// use coilsense::inductance::PermeableRings;
    /// let of = |permeability: f64| PermeableRings::new(4, 8.47e-3, 1.41e-3, permeability)?.inductance(3.102e-3);
    /// let magnetic = of(2.0)? / of(1.0)?;
    /// assert!((magnetic - 1.109).abs() < 1e-3);
    /// # Ok::<(), coilsense::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Value`] for a pitch below 1.04 wire diameters, where the edges of neighbours are too near for these points.
    pub fn inductance(&self, pitch: f64) -> Result<f64, Error> {
        check_pitch(pitch, self.wire_radius)?;
        let disc = Disc::new(self.coil_radius, self.wire_radius, pitch);
        let row = Row::new(&disc, self.turns);
        Ok(Susceptible::new(&row, self.turns).inductance(self.permeability))
    }
}

/// Refuses a permeability for which the points on a wire's edge are too few, and one that no wire has.
fn check_permeability(permeability: f64) -> Result<f64, Error> {
    let allowed = format!("1 to {MOST_PERMEABLE}");
    check((1.0..=MOST_PERMEABLE).contains(&permeability), "permeability", permeability, "", allowed)
}

/// Refuses a pitch at which wires are too near to one another.
fn check_pitch(pitch: f64, wire_radius: f64) -> Result<f64, Error> {
    let least = LEAST_PITCH * 2.0 * wire_radius;
    let allowed = format!("at least {LEAST_PITCH} wire diameters, {least} m");
    check(pitch.is_finite() && pitch >= least, "pitch", pitch, "m", allowed)
}
