//! What the wire of `[spring]` bears in fatigue, where the spec says it.
//!
//! Next door: the rest of a spring (`spring`), who judges by it (`crate::speed`).

use super::SpecError;
use super::section::Section;
use crate::quantity::Dimension;

/// Strengths of the wire in shear.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StrengthSpec {
    /// Amplitude of the shear stress that it bears for ever about a mean of zero \[Pa\].
    pub endurance: f64,
    /// Shear stress at which it breaks \[Pa\].
    pub ultimate: f64,
}

impl StrengthSpec {
    /// Both strengths, where they are given.
    pub(super) fn parse(section: &Section<'_>) -> Result<Option<Self>, SpecError> {
        let [endurance, ultimate] = ["endurance_shear_strength", "ultimate_shear_strength"];
        if !section.has(endurance) && !section.has(ultimate) {
            return Ok(None);
        }
        let found = Self { endurance: strength(section, endurance)?, ultimate: strength(section, ultimate)? };
        let allowed = format!("below ultimate_shear_strength of {} MPa", 1e-6 * found.ultimate);
        section.check(endurance, found.endurance < found.ultimate, found.endurance, &allowed)?;
        Ok(Some(found))
    }
}

/// The highest strength that is taken \[Pa\]: above that of any wire.
const HIGHEST: f64 = 2e10;

fn strength(section: &Section<'_>, key: &str) -> Result<f64, SpecError> {
    let value = section.quantity(key, Dimension::Modulus)?;
    section.check(key, value > 0.0 && value <= HIGHEST, value, "above zero and at most 2e10 Pa")
}
