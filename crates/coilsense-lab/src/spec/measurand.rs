//! What a sensor measures, read from its table by its kind.
//!
//! Next door: the instrument itself (`sensor`), the kinds and what they make of a signal (`coilsense::sensors`).

use coilsense::End;
use coilsense::sensors::{Kind, Native, Quantity, USUAL_COMPLIANCE_TOLERANCE, magnetic_form, usual_form};

use super::section::Section;
use super::{SpecError, SpringSpec};
use crate::quantity::Dimension;

/// Every kind of sensor, by its word in a spec.
pub const KINDS: [&str; Kind::ALL.len()] = words();

const fn words() -> [&'static str; Kind::ALL.len()] {
    let mut words = [""; Kind::ALL.len()];
    let mut index = 0;
    while index < words.len() {
        words[index] = Kind::ALL[index].word();
        index += 1;
    }
    words
}

/// The dimension of a kind's readings.
pub(super) fn dimension(kind: Kind) -> Dimension {
    match kind.native() {
        Native::Force => Dimension::Force,
        Native::Length => Dimension::Length,
        Native::Inductance => Dimension::Inductance,
    }
}

/// What a sensor of a kind measures, by its table, on a spring.
pub(super) fn measurand(section: &Section<'_>, kind: Kind, spec: &SpringSpec) -> Result<Quantity, SpecError> {
    Ok(match kind {
        Kind::LoadCell => match section.optional_whole("end", 1, 2)? {
            Some(1) => Quantity::Force(End::One),
            _ => Quantity::Force(End::Two),
        },
        Kind::Deflection => Quantity::Deflection,
        Kind::TwoEncoder => Quantity::TwoEncoder {
            compliance: section.not_negative("compliance", Dimension::Compliance)?.unwrap_or(0.0),
            backlash: section.not_negative("backlash", Dimension::Length)?.unwrap_or(0.0),
            compliance_tolerance: section.share("compliance_tolerance")?.unwrap_or(USUAL_COMPLIANCE_TOLERANCE),
        },
        Kind::Inductance => on_coil(section, spec)?,
    })
}

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

fn on_coil(section: &Section<'_>, spec: &SpringSpec) -> Result<Quantity, SpecError> {
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
            let needs = "needs calibration_form of a wire whose relative_permeability is told as magnetic";
            if !cfg!(feature = "steel") {
                return Err(section.refuse("kind", format!("{needs}: this build does not compute it")));
            }
            let found = magnetic_form(&spec.spring, largest, through_ends);
            (found.map_err(|error| section.refuse("kind", format!("{needs}: {error}")))?, true, REMOUNTING)
        }
        Calibrated::Fitted => (usual, false, 0.0),
        Calibrated::TwoPoint => (THROUGH_ENDS, false, REMOUNTING),
    };
    Ok(Quantity::Inductance { uncalibrated, form, magnetic, remounting })
}

/// A relative permeability so far above 1 changes what eq. (13) leaves.
const MAGNETIC: f64 = 0.01;
