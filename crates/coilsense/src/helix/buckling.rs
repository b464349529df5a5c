//! At which length a compressed helix gives way sideways.
//!
//! Next door: how fast it swings before (`modes`).

use super::chain::Chain;
use super::ends::Ends;
use super::modes::{PER_WINDING, beyond};
use super::rod::Rod;
use super::state::{Helix, Turning};
use crate::error::{Error, check};

/// Lengths between rest and solid that are looked at before the first that gives way is closed in on.
const LENGTHS: u32 = 64;

/// Relative width to which it is closed in on.
const WIDTH: f64 = 1e-10;

/// The span of the active windings at which a helix that is pressed together from rest first buckles \[m\]; `None` where its windings
/// touch before.
///
/// The first length at which the stiffness against any motion that the ends allow is no longer positive: there the lowest frequency,
/// a sideways one, has come down to zero.
///
/// Source:   counted as modes are, at zero frequency.
/// Valid:    ends that stay in place; windings touch at a span of N d. A seated end that may lift off lies between clamped and pinned.
/// Accuracy: 1e-10 of the span. Against the formula of `[EN13906-1]` (Haringx) 1.5 % at d/D = 0.1 and 0.4 % at 0.05 (`tests/helix`).
///
/// # Errors
/// [`Error::Value`] for a wire whose windings touch or are flat at rest, or that has no equilibrium on the way.
///
/// ```
/// use coilsense::helix::{Ends, Hand, Rod, RodParameters, Turning, buckling_length};
///
/// // Eight diameters long: pinned it gives way at 4.4 %, clamped at 19.7 % of its length.
/// let rod = Rod::new(RodParameters {
///     wire_diameter: 0.001, coil_radius: 0.005, windings: 20.0, rest_span: 0.080,
///     youngs_modulus: 206e9, shear_modulus: 81.5e9, density: 7850.0, hand: Hand::Right,
/// })?;
/// let deflection = |ends| buckling_length(&rod, ends, Turning::Held).map(|length| length.map(|length| 1.0 - length / 0.080));
/// assert!((deflection(Ends::pinned())?.unwrap_or_default() - 0.044).abs() < 1e-3);
/// assert!((deflection(Ends::clamped())?.unwrap_or_default() - 0.197).abs() < 3e-3);
/// # Ok::<(), coilsense::Error>(())
/// ```
pub fn buckling_length(rod: &Rod, ends: Ends, turning: Turning) -> Result<Option<f64>, Error> {
    let p = rod.parameters();
    let (rest, solid) = (p.rest_span, p.windings * p.wire_diameter);
    check(rest > solid, "rest_span", rest, "m", format!("above {solid} m, where the windings touch"))?;
    let mut holds = rest;
    for step in 1..=LENGTHS {
        let span = rest + (solid - rest) * f64::from(step) / f64::from(LENGTHS);
        if !is_stable(rod, ends, turning, span)? {
            return close_in(rod, ends, turning, (holds, span)).map(Some);
        }
        holds = span;
    }
    Ok(None)
}

fn close_in(rod: &Rod, ends: Ends, turning: Turning, (mut holds, mut fails): (f64, f64)) -> Result<f64, Error> {
    while holds - fails > WIDTH * holds {
        let span = 0.5 * (holds + fails);
        match is_stable(rod, ends, turning, span)? {
            true => holds = span,
            false => fails = span,
        }
    }
    Ok(0.5 * (holds + fails))
}

/// Whether no motion grows; one that meets no stiffness at all (a free rotation) does not.
fn is_stable(rod: &Rod, ends: Ends, turning: Turning, span: f64) -> Result<bool, Error> {
    let helix = Helix::new(rod, span, turning)?;
    let chain = Chain::new(&helix, &ends, PER_WINDING, 0.0).ok_or_else(|| beyond("rest_span", span, "m"))?;
    // √λ of a bar, of which 1e-4 is neutral.
    let bar = helix.stiffness().abs() / rod.mass() * helix.eigenvalue_unit();
    Ok(chain.count(-1e-8 * bar) == 0)
}
