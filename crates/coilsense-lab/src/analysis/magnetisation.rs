//! What a reader must know of the inductance of magnetic wire.
//!
//! Next door: the other warnings (`warnings`), the inductance itself (`crate::spec::SpringInductance`).

use super::case::Case;
use super::warnings::{Subject, Warning};
use crate::quantity::digits;
use crate::spec::Spec;

/// Where L is not that of the wire that the spec tells of, and where its windings are too uneven.
pub(super) fn of(spec: &Spec, cases: &[Case]) -> Vec<Warning> {
    let warning = |text| Warning { subject: Subject::Magnetisation, text };
    if let Some(Err(reason)) = spec.spring.magnetic_turns() {
        let text = format!(
            "relative_permeability is left out of L and F_L, which are those of wire that is not magnetic ({reason}): magnetic wire makes L of a spring larger, by 8 \
             to 13 % where it is cold-drawn stainless steel."
        );
        return vec![warning(text)];
    }
    let uneven = |case: &&Case| case.magnetised.is_some_and(|how| how.beyond > 0.0);
    let told = |case: &Case| {
        let beyond = case.magnetised.map_or(0.0, |how| how.beyond);
        let (condition, damping) = (&spec.conditions[case.condition].name, &spec.mount.cases[case.damping].label);
        warning(format!(
            "{condition}, {damping}: in {} % of the time a gap between windings is more than a third off that of even windings. There L counts magnetisation as that of \
             even windings; how far F_L may be off by it is in the uncertainty of a sensor by inductance.",
            digits(100.0 * beyond)
        ))
    };
    cases.iter().filter(uneven).map(told).collect()
}
