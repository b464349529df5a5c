//! What a fit of a steel coil takes for granted, and how well it is known.
//!
//! Next door: the fit (`steel`).

use crate::error::{Error, called, check};
use crate::inductance::Leads;

/// How well is known what a fit of a steel coil takes for granted: standard uncertainties.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SteelDoubts {
    /// Of a reading of L \[H\]: the meter's noise.
    pub meter: f64,
    /// Of the windings, as a share.
    pub windings: f64,
    /// Of the coil's radius, as a share.
    pub coil_radius: f64,
    /// Of the wire's diameter \[m\].
    pub wire_diameter: f64,
    /// Of a permeability that was told, as a share of it; one that is fitted needs none.
    pub permeability: f64,
    /// Another way on which the current may go back, as far from the one taken as one standard uncertainty.
    pub leads: Leads,
    /// What the theory leaves of L, as a share of it.
    pub theory: f64,
}

impl Default for SteelDoubts {
    /// A meter of 2 nH, windings counted to half a percent, a radius to 0.2 %, a wire to 10 µm; a permeability of
    /// another spring to 15 %, as a common factor of L and it can hardly be told apart; a lead 5 cm off; 0.06 % of L, the most that was left on the four
    /// springs of `[Vlasblom2015]`.
    fn default() -> Self {
        Self {
            meter: 2e-9,
            windings: 5e-3,
            coil_radius: 2e-3,
            wire_diameter: 1e-5,
            permeability: 0.15,
            leads: Leads::Beside(0.05),
            theory: 6e-4,
        }
    }
}

impl SteelDoubts {
    /// Refuses what is no standard uncertainty.
    pub(super) fn check(&self) -> Result<(), Error> {
        for (what, value, unit) in [
            (called("meter", "uncertainty of the meter"), self.meter, "H"),
            (called("windings", "uncertainty of the windings"), self.windings, ""),
            (called("coil_radius", "uncertainty of the coil radius"), self.coil_radius, ""),
            (called("wire_diameter", "uncertainty of the wire diameter"), self.wire_diameter, "m"),
            (called("permeability", "uncertainty of the permeability"), self.permeability, ""),
            (called("theory", "uncertainty of the theory"), self.theory, ""),
        ] {
            check(value.is_finite() && value >= 0.0, what, value, unit, "zero or above")?;
        }
        Ok(())
    }
}
