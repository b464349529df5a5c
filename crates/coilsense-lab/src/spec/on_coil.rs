//! A sensor by the spring's own inductance: how its calibration was found, and how far that departs from a measured spring.
//!
//! Next door: the other kinds (`measurand`), what eq. (13) leaves of magnetic wire (`coilsense::sensors::magnetic_form`).

use coilsense::sensors::{Quantity, magnetic_form, usual_form};

use super::inductance::MAGNETIC;
use super::section::Section;
use super::{SpecError, SpringSpec};

/// How eq. (13), or what stands in for it, was found.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Calibrated {
    /// Fitted to measured lengths over the range.
    Fitted,
    /// Through two of them, the ends of the range.
    TwoPoint,
    /// By the theory of magnetic wire.
    Steel,
    /// Not at all.
    Theory,
}

impl Calibrated {
    const ALL: [(&'static str, Self); 4] =
        [("fitted", Self::Fitted), ("two-point", Self::TwoPoint), ("steel", Self::Steel), ("theory", Self::Theory)];
}

/// Departure from eq. (13) through two end points, of four measured springs, root mean square: 1.50, 0.98, 2.16 and 0.32 % of the travel.
const THROUGH_ENDS: f64 = 0.014;
/// What the theory of magnetic wire left of two points on the same springs: 0.14 to 0.37 %.
const STEEL: f64 = 0.003;
/// What mounting a spring anew adds: runs held out against another run's calibration were 0.5 to 0.7 % of the travel off.
const REMOUNTING: f64 = 0.007;

/// What it measures, by its table.
pub(super) fn on_coil(section: &Section<'_>, spec: &SpringSpec) -> Result<Quantity, SpecError> {
    let word = section.optional_word("calibration", &Calibrated::ALL.map(|(word, _)| word))?;
    let way =
        Calibrated::ALL.into_iter().find(|(name, _)| Some(*name) == word).map_or(Calibrated::Fitted, |(_, way)| way);
    let uncalibrated = way == Calibrated::Theory;
    if let Some(form) = section.share("calibration_form")? {
        return Ok(Quantity::Inductance { uncalibrated, form, magnetic: false, remounting: 0.0 });
    }
    let wire = spec.geometry.material();
    let usual = usual_form(uncalibrated, wire);
    let relative = wire.relative_permeability().unwrap_or(1.0);
    let largest = relative * (1.0 + spec.tolerances.permeability);
    let (form, magnetic, remounting) = match way {
        Calibrated::Theory => (usual, false, 0.0),
        Calibrated::Steel => (STEEL, false, REMOUNTING),
        // Of wire whose permeability is told, what eq. (13) leaves is computed.
        Calibrated::Fitted | Calibrated::TwoPoint if largest > 1.0 + MAGNETIC => {
            let through_ends = way == Calibrated::TwoPoint;
            let needs = "needs calibration_form: relative_permeability says that the wire is magnetic";
            if !cfg!(feature = "steel") {
                return Err(section
                    .refuse("kind", format!("{needs}, and this build does not compute what eq. (13) then leaves")));
            }
            let found = magnetic_form(&spec.spring, largest, through_ends);
            (
                found.map_err(|error| {
                    section
                        .refuse("kind", format!("{needs}, and what eq. (13) then leaves cannot be computed: {error}"))
                })?,
                true,
                REMOUNTING,
            )
        }
        Calibrated::Fitted => (usual, false, 0.0),
        Calibrated::TwoPoint => (THROUGH_ENDS, false, REMOUNTING),
    };
    Ok(Quantity::Inductance { uncalibrated, form, magnetic, remounting })
}
