//! The coil as every theory needs it: windings, two radii, what its wire is.
//!
//! Next door: the spring with its mass and stiffness (`crate::spring`).

use crate::error::{Error, above_zero, check};
use crate::spring::Spring;

/// Most windings that a theory takes: the helix is integrated turn by turn.
const MAX_WINDINGS: f64 = 1e5;

/// A coil whose every value has been checked.
///
/// ```
/// use coilsense::inductance::theories::{Coil, Theory};
///
/// let coil = Coil::new(41.904, 8.47e-3, 1.41e-3)?;
/// let microhenry = 1e6 * Theory::Nagaoka.inductance(&coil, 0.124);
/// assert!((3.6..4.0).contains(&microhenry));
/// # Ok::<(), coilsense::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Coil {
    windings: f64,
    coil_radius: f64,
    wire_radius: f64,
    permeability: f64,
}

/// The largest relative permeability for which a theory's points on a wire's edge are dense enough.
pub(crate) const MOST_PERMEABLE: f64 = 20.0;

impl Coil {
    /// - `windings`: N, from 1 to 1e5, may be fractional
    /// - `coil_radius`: r \[m\], from the axis to the centre of the wire; `wire_radius`: ρ \[m\], below r
    ///
    /// # Errors
    /// [`Error::Value`] for the first value that is outside of that.
    pub fn new(windings: f64, coil_radius: f64, wire_radius: f64) -> Result<Self, Error> {
        let holds = windings.is_finite() && (1.0..=MAX_WINDINGS).contains(&windings);
        check(holds, "windings", windings, "", format!("from 1 to {MAX_WINDINGS}"))?;
        above_zero("coil_radius", coil_radius, "m")?;
        above_zero("wire_radius", wire_radius, "m")?;
        let allowed = format!("below the coil radius of {coil_radius} m");
        check(wire_radius < coil_radius, "wire_radius", wire_radius, "m", allowed)?;
        Ok(Self { windings, coil_radius, wire_radius, permeability: 1.0 })
    }

    /// The coil of a spring: the windings that carry its current.
    ///
    /// # Errors
    /// As [`Self::new`].
    pub fn of(spring: &Spring) -> Result<Self, Error> {
        Self::new(spring.inductance_windings(), spring.coil_radius(), spring.wire_radius())
    }

    /// The same coil of magnetic wire, which [`super::theories::Theory::SteelSpring`] alone counts; without this its wire is not magnetic.
    ///
    /// - `permeability`: μ_r of the wire, from 1 to 20
    ///
    /// # Errors
    /// [`Error::Value`] outside of that.
    pub fn with_permeability(self, permeability: f64) -> Result<Self, Error> {
        let allowed = format!("from 1 to {MOST_PERMEABLE}");
        let permeability =
            check((1.0..=MOST_PERMEABLE).contains(&permeability), "permeability", permeability, "", allowed)?;
        Ok(Self { permeability, ..self })
    }

    /// N.
    pub fn windings(&self) -> f64 {
        self.windings
    }

    /// r \[m\].
    pub fn coil_radius(&self) -> f64 {
        self.coil_radius
    }

    /// ρ \[m\].
    pub fn wire_radius(&self) -> f64 {
        self.wire_radius
    }

    /// μ_r of the wire.
    pub fn permeability(&self) -> f64 {
        self.permeability
    }
}
