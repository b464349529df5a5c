//! What a sensor measures, by its kind.
//!
//! Next door: the instrument itself (`sensor`), what it makes of a signal (`coilsense::sensors`).

use coilsense::geometry::Material;
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

/// Departure of measured springs from eq. (13)'s form, share of the travel: 0.3–2 % in measured runs (book: theory, section 5).
const FITTED_FORM: f64 = 0.013;
/// The same of a Maxwell sum without calibration: measured extension springs, uncalibrated Maxwell sum: 27, 33, 28 and 8 % of travel
/// (book: theory, section 5). Most spring wire is magnetic, stainless wire too once it is drawn.
const THEORY_FORM: f64 = 0.30;
/// The same of a wire that is known not to be magnetic, which the sum's air coil is: the upper end of 1–14 %.
const THEORY_FORM_IN_AIR: f64 = 0.14;
/// A relative permeability so near to 1 changes no inductance of a coil by as much.
const NOT_MAGNETIC: f64 = 0.01;

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

/// What a sensor of a kind measures, by its table, on a spring of that wire.
pub(super) fn measurand(section: &Section<'_>, kind: &str, wire: &Material) -> Result<Quantity, SpecError> {
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
            let in_air = wire.relative_permeability().is_some_and(|relative| (relative - 1.0).abs() <= NOT_MAGNETIC);
            let usual = match (uncalibrated, in_air) {
                (false, _) => FITTED_FORM,
                (true, false) => THEORY_FORM,
                (true, true) => THEORY_FORM_IN_AIR,
            };
            let form = section.share("calibration_form")?.unwrap_or(usual);
            Quantity::Inductance { uncalibrated, form }
        }
    })
}
