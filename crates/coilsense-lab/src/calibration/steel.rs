//! The coil of magnetic wire that points may be those of, and what is not known of it.
//!
//! Next door: its theory (`coilsense::inductance::SteelCoil`), its fit (`coilsense::calibrate::SteelFit`).

use coilsense::calibrate::SteelDoubts;
use coilsense::inductance::theories::Coil;
use coilsense::inductance::{LEAST_PITCH, Leads, SteelCoil};

use super::{CalibrationError, Measured, SteelPlan};
use crate::quantity::digits;

/// How far beyond the points lengths may be read, as a share of their range.
const MARGIN: f64 = 0.05;
/// u(L) of a meter of which nothing is known, as a share of L: the basic accuracy of a good bridge.
const METER: f64 = 5e-4;
/// How far off a lead may be that is taken as far away \[m\], and by which share one whose distance is told.
const NEAR_LEAD: f64 = 0.05;
const OF_DISTANCE: f64 = 0.2;

/// The length at which the coil's radius is what it is \[m\].
pub(super) fn measured_at(measured: &Measured, plan: &SteelPlan) -> f64 {
    plan.measured_at.or(measured.zero_length).unwrap_or(measured.points.ends()[0])
}

/// The coil over the lengths of the points and a margin.
///
/// # Errors
/// [`CalibrationError`] with file and row where windings touch, and what the theory refuses.
pub(super) fn coil(measured: &Measured, coil: &Coil, plan: &SteelPlan) -> Result<SteelCoil, CalibrationError> {
    let lengths = measured.points.lengths();
    let diameter = 2.0 * coil.wire_radius();
    let least = LEAST_PITCH * diameter * coil.windings();
    if let Some(index) = (0..lengths.len()).find(|&index| lengths[index] < least) {
        return Err(CalibrationError::of(
            &measured.file,
            format!(
                "row {}: {} mm is {:.3} wire diameters a winding; below {LEAST_PITCH} windings touch and short, leave the row out",
                measured.rows[index],
                digits(1e3 * lengths[index]),
                lengths[index] / coil.windings() / diameter,
            ),
        ));
    }
    let [shortest, longest] = measured.points.ends();
    let margin = MARGIN * (longest - shortest);
    let range = [(shortest - margin).max(least), longest + margin];
    SteelCoil::new(coil, measured_at(measured, plan), plan.leads, range)
        .map_err(|error| CalibrationError::of(&measured.file, error))
}

/// What is not known, as standard uncertainties.
pub(super) fn doubts(measured: &Measured, coil: &Coil, plan: &SteelPlan) -> SteelDoubts {
    let errors = &measured.standard_errors;
    let scattered = errors.iter().map(|error| error * error).sum::<f64>() / errors.len() as f64;
    let inductances = measured.points.inductances();
    let average = inductances.iter().sum::<f64>() / inductances.len() as f64;
    let of_points = if errors.is_empty() { METER * average } else { scattered.sqrt() };
    let leads = match plan.leads {
        Leads::Open => Leads::Beside(NEAR_LEAD.max(1.5 * coil.coil_radius())),
        Leads::Beside(distance) => Leads::Beside((1.0 + OF_DISTANCE) * distance),
        Leads::LeftOut => Leads::Open,
    };
    SteelDoubts { meter: plan.meter_noise.unwrap_or(of_points), leads, ..SteelDoubts::default() }
}

/// Doubts that move no figure: for a fit of which only the curve is wanted.
pub(super) fn without(leads: Leads) -> SteelDoubts {
    SteelDoubts {
        meter: 0.0,
        windings: 0.0,
        coil_radius: 0.0,
        wire_diameter: 0.0,
        permeability: 0.0,
        leads,
        theory: 0.0,
    }
}
