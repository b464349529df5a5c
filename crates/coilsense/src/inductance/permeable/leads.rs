//! The current that goes along a coil, from end to end, beside that which goes round in it.
//!
//! Next door: the turns (`super::PermeableRings`), a helix, which has both in one (`inductance::theories::helix`).

use std::f64::consts::TAU;

use crate::error::{Error, above_zero, check};
use crate::inductance::mutual::MU_0;

/// Where the current goes back that flows along a coil, from one end of the meter's leads to the other.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum Leads {
    /// Far away: the partial inductance of the coil between its ends.
    #[default]
    Open,
    /// Along the coil, so far from its axis \[m\].
    Beside(f64),
    /// It is left out, as rings leave it out.
    LeftOut,
}

/// What the current along a coil adds to its inductance \[H\].
///
/// - [`Leads::Open`]: μ₀ l/2π (ln(2l/r) − 1)
/// - [`Leads::Beside`]: μ₀ l/2π ln(D/r)
///
/// - `length`: l \[m\], `coil_radius`: r \[m\], both above zero
///
/// Source:   partial inductance of a tube of current, and of that with a thin wire beside it, `[Grover1946]` chapter 5.
/// Valid:    a coil much longer than it is wide, a lead farther away than the coil is wide; the leads' own inductance is none of it.
/// Accuracy: 6 nH of what Neumann's helix with open ends is above a sum of rings, on coils of 41.9 and 52 windings (tests).
///
/// ```
/// use coilsense::inductance::{Leads, inductance_along};
/// let open = inductance_along(0.15, 8.47e-3, Leads::Open)?;
/// let beside = inductance_along(0.15, 8.47e-3, Leads::Beside(0.05))?;
/// assert!((1e9 * open - 77.0).abs() < 0.1 && (1e9 * beside - 53.3).abs() < 0.1);
/// # Ok::<(), coilsense::Error>(())
/// ```
///
/// # Errors
/// [`Error::Value`] for a length or radius that is not above zero, and for leads inside the coil.
pub fn inductance_along(length: f64, coil_radius: f64, leads: Leads) -> Result<f64, Error> {
    above_zero("length", length, "m")?;
    above_zero("coil_radius", coil_radius, "m")?;
    leads.outside(coil_radius)?;
    Ok(leads.along(length, coil_radius))
}

impl Leads {
    /// Those that a word says: `open`, or `none` for what is left out.
    pub fn named(word: &str) -> Option<Self> {
        match word {
            "open" => Some(Self::Open),
            "none" => Some(Self::LeftOut),
            _ => None,
        }
    }

    /// Refuses leads inside a coil.
    pub(crate) fn outside(self, coil_radius: f64) -> Result<(), Error> {
        let Self::Beside(distance) = self else { return Ok(()) };
        let allowed = format!("above the coil radius of {coil_radius} m");
        check(distance.is_finite() && distance > coil_radius, "leads", distance, "m", allowed).map(|_| ())
    }

    /// Of values that were checked.
    pub(super) fn along(self, length: f64, coil_radius: f64) -> f64 {
        let logarithm = match self {
            Self::Open => (2.0 * length / coil_radius).ln() - 1.0,
            Self::Beside(distance) => (distance / coil_radius).ln(),
            Self::LeftOut => 0.0,
        };
        MU_0 * length / TAU * logarithm
    }
}
