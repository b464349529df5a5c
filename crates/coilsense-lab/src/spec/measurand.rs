//! What a sensor measures, read from its table by its kind.
//!
//! Next door: the instrument itself (`sensor`), how far its coil's calibration holds (`on_coil`), the kinds and what they make of a signal (`coilsense::sensors`).

use coilsense::End;
use coilsense::sensors::{Kind, Native, Quantity, USUAL_COMPLIANCE_TOLERANCE};

use super::SpecError;
use super::section::Section;
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

/// What a sensor of a kind measures, by its table; `on_coil` says it of the spring's own inductance.
pub(super) fn measurand(
    section: &Section<'_>,
    kind: Kind,
    on_coil: impl FnOnce() -> Result<Quantity, SpecError>,
) -> Result<Quantity, SpecError> {
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
        Kind::Inductance => on_coil()?,
    })
}
