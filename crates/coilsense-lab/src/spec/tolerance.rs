//! How far a spring's stiffness and rest length may be off.
//!
//! Next door: the spring (`spring`), what tolerances do to it (`coilsense::geometry::Sensitivities`).

use coilsense::geometry::Sensitivities;

use super::SpecError;
use super::section::Section;
use crate::quantity::Dimension;

/// As it is given, or by what the tolerances of wire, coil and material do to k = G d⁴/(8 D³ n) at their worst.
pub(super) fn stiffness_tolerance(section: &Section<'_>, by_geometry: bool) -> Result<f64, SpecError> {
    let share = |key| -> Result<Option<f64>, SpecError> {
        let given = section.not_negative(key, Dimension::Share)?;
        given.map(|value| section.check(key, value < 1.0, value, "below 100 %")).transpose()
    };
    if let Some(tolerance) = share("stiffness_tolerance")? {
        return Ok(tolerance);
    }
    if !by_geometry {
        return Ok(0.0);
    }
    let sensitivities = Sensitivities::of_stiffness();
    let each = [
        ("wire_diameter_tolerance", sensitivities.wire_diameter),
        ("coil_diameter_tolerance", sensitivities.coil_diameter),
        ("windings_tolerance", sensitivities.active_windings),
        ("shear_modulus_tolerance", sensitivities.shear_modulus),
    ];
    // Independent limits of error add up as their squares do.
    let squares = each.into_iter().map(|(key, slope)| Ok((slope * share(key)?.unwrap_or(0.0)).powi(2)));
    let tolerance = squares.sum::<Result<f64, SpecError>>()?.sqrt();
    match section.first_of(&each.map(|(key, _)| key)) {
        Some(key) if tolerance >= 1.0 => {
            let text = format!(
                "the tolerances leave {:.0} % of doubt in the stiffness; must be below 100 %",
                100.0 * tolerance
            );
            Err(section.refuse(key, text))
        }
        _ => Ok(tolerance),
    }
}

/// How far the rest length may be off \[m\].
pub(super) fn rest_length_tolerance(section: &Section<'_>, rest_length: f64) -> Result<f64, SpecError> {
    let tolerance = section.not_negative("rest_length_tolerance", Dimension::Length)?.unwrap_or(0.0);
    section.check("rest_length_tolerance", tolerance < rest_length, tolerance, "below rest_length")
}
