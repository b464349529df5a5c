//! Force from the ends' positions: potentiometers, encoders, lasers.
//!
//! Next door: force from the inductance (`inductance`).

use crate::error::{Error, count};
use crate::spring::Spring;

/// F_x: force of a spring without mass between the ends \[N\], shape `samples`; the paper's reference.
///
/// F_x = k (u2 − u1 − l0)
///
/// - `u1`, `u2`: positions of the ends \[m\], shape `samples`
///
/// Source:   `[Weijde2017]` section III-C.
/// Valid:    an ideal sensor; no initial tension.
/// Accuracy: rounding of the difference of lengths.
///
/// # Errors
/// [`Error::Count`] where the two series are not equally long.
///
/// ```
/// # let spring = coilsense::paper::s_t();
/// let force = coilsense::sensors::deflection_force(&spring, &[0.0], &[0.204])?;
/// assert!((force[0] - 76.0).abs() < 1e-12);
/// # Ok::<(), coilsense::Error>(())
/// ```
pub fn deflection_force(spring: &Spring, u1: &[f64], u2: &[f64]) -> Result<Vec<f64>, Error> {
    count("u2", u2.len(), u1.len())?;
    Ok(u1.iter().zip(u2).map(|(u1, u2)| spring.static_force(u2 - u1)).collect())
}
