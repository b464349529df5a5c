//! What a known spring lets expect of a log.
//!
//! Next door: what else may be asked (`request`).

use coilsense::Spring;

use crate::spec::{EndsSpec, Model, SpringSpec};

/// What is expected of a spring that is known.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Expected {
    /// f1 with both ends held \[Hz\].
    pub first_frequency: f64,
    /// N of a chain with one mass for each winding; none of a coil, which is continuous.
    pub windings: Option<f64>,
}

impl Expected {
    /// Of a chain.
    pub fn of_spring(spring: &Spring) -> Self {
        let is_paper = spring.masses_per_winding() == 1;
        Self { first_frequency: spring.chain_frequency(), windings: is_paper.then(|| spring.whole_windings() as f64) }
    }

    /// Of a spring as a spec has it: of its model, as `coilsense spring` tells it.
    ///
    /// f1 of a coil is that of the helix at mid range, in the middle of what its ends leave open; of one that is no helix that of the continuous coil.
    pub fn of_spec(spec: &SpringSpec) -> Self {
        if spec.model == Model::Chain {
            return Self::of_spring(&spec.spring);
        }
        let ends = EndsSpec::assumed(spec.geometry.parameters().end_type);
        let of_helix = spec.helix(&ends).and_then(|coil| coil.first_surge(spec.spring.mid_length()));
        let first_frequency = of_helix.map_or_else(|_| spec.spring.surge_frequency(), |(low, high)| 0.5 * (low + high));
        Self { first_frequency, windings: None }
    }
}
