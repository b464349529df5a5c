//! What a sensor measures, by its kind.
//!
//! Next door: the instrument itself (`sensor`), what it makes of a signal (`coilsense::sensors`).

use coilsense::inductance::MaxwellSum;
use coilsense::{End, Spring};

use super::SpecError;
use super::section::Section;
use crate::quantity::Dimension;

/// Every kind of sensor, by its word in a spec.
pub const KINDS: [&str; 4] = ["load-cell", "deflection", "two-encoder", "inductance"];

/// What a sensor measures.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Quantity {
    /// The force at an end \[N\].
    Force(End),
    /// u2 − u1 \[m\].
    Deflection,
    /// The elongation between a motor-side encoder and end 2 \[m\].
    TwoEncoder {
        /// Of the drive train \[m/N\].
        compliance: f64,
        /// Its whole play \[m\].
        backlash: f64,
    },
    /// The spring's inductance \[H\].
    Inductance {
        /// Whether eq. (13) is not fitted to the spring but to Maxwell's sum.
        uncalibrated: bool,
        /// Standard deviation of the departure from eq. (13)'s form, as a share of the travel \[1\].
        form: f64,
    },
}

/// Departure of measured springs from eq. (13)'s form, share of the travel: findings of measured runs, 0.3–2 %; and of a Maxwell sum
/// without calibration, 1–14 %.
const FITTED_FORM: f64 = 0.013;
const THEORY_FORM: f64 = 0.14;

impl Quantity {
    /// Its word in a spec.
    pub fn kind(self) -> &'static str {
        match self {
            Self::Force(_) => KINDS[0],
            Self::Deflection => KINDS[1],
            Self::TwoEncoder { .. } => KINDS[2],
            Self::Inductance { .. } => KINDS[3],
        }
    }

    /// Its dimension.
    pub(super) fn dimension(self) -> Dimension {
        match self {
            Self::Force(_) => Dimension::Force,
            Self::Deflection | Self::TwoEncoder { .. } => Dimension::Length,
            Self::Inductance { .. } => Dimension::Inductance,
        }
    }

    /// The SI unit of its readings.
    pub fn unit(self) -> &'static str {
        match self.dimension() {
            Dimension::Force => "N",
            Dimension::Length => "m",
            _ => "H",
        }
    }

    /// Full scale where a spec says nothing: the spring's.
    pub(super) fn natural_range(self, spring: &Spring, coil: &MaxwellSum) -> f64 {
        let (shortest, longest) = spring.operating_range();
        match self {
            Self::Force(_) => spring.nominal_force(),
            Self::Deflection | Self::TwoEncoder { .. } => longest - shortest,
            Self::Inductance { .. } => (coil.at_length(shortest) - coil.at_length(longest)).abs(),
        }
    }
}

/// What a sensor of a kind measures, by its table.
pub(super) fn measurand(section: &Section<'_>, kind: &str) -> Result<Quantity, SpecError> {
    Ok(match kind {
        "load-cell" => match section.optional_whole("end", 1, 2)? {
            Some(1) => Quantity::Force(End::One),
            _ => Quantity::Force(End::Two),
        },
        "deflection" => Quantity::Deflection,
        "two-encoder" => Quantity::TwoEncoder {
            compliance: section.not_negative("compliance", Dimension::Compliance)?.unwrap_or(0.0),
            backlash: section.not_negative("backlash", Dimension::Length)?.unwrap_or(0.0),
        },
        _ => {
            let uncalibrated = section.optional_word("calibration", &["fitted", "theory"])? == Some("theory");
            let usual = if uncalibrated { THEORY_FORM } else { FITTED_FORM };
            let form = section.share("calibration_form")?.unwrap_or(usual);
            Quantity::Inductance { uncalibrated, form }
        }
    })
}
