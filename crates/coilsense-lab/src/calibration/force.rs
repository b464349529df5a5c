//! From length to force, by what a spec says of its spring.
//!
//! Next door: the law itself (`crate::stored`), how uncertain the length is (`coilsense::calibrate::ReadingUncertainty`).

use crate::spec::SpringSpec;
use crate::stored::ForceLaw;

impl ForceLaw {
    /// That of a spec's spring, with its tolerances taken as evenly spread.
    pub fn of(spec: &SpringSpec) -> Self {
        let (stiffness, even) = (spec.spring.stiffness(), 1.0 / 3.0_f64.sqrt());
        Self {
            stiffness,
            stiffness_u: even * stiffness * spec.stiffness_tolerance(),
            rest_length: spec.spring.rest_length(),
            rest_length_u: even * spec.rest_length_tolerance(),
        }
    }
}
