//! What a reader must know of the inductance of magnetic wire.
//!
//! Next door: the other warnings (`warnings`), the inductance itself (`crate::spec::SpringInductance`).

use coilsense::inductance::direct_up_to;

use super::case::Case;
use crate::quantity::digits;
use crate::spec::{SensorSpec, Spec, SpringSpec};

/// Where L is not that of the wire that the spec tells of, and where its windings are too uneven.
pub(super) fn of(spec: &Spec, cases: &[Case]) -> Vec<String> {
    if let Some(Err(reason)) = spec.spring.magnetic_turns() {
        let text = format!(
            "relative_permeability is left out of L and F_L, which are those of wire that is not magnetic ({reason}): magnetic wire makes L of a spring larger, by 8 \
             to 13 % where it is cold-drawn stainless steel."
        );
        return vec![text];
    }
    // What is never told need not be loaded.
    if !cfg!(feature = "steel") {
        return Vec::new();
    }
    let uneven = |case: &&Case| case.magnetised.is_some_and(|how| how.beyond > 0.0);
    let told = |case: &Case| {
        let beyond = case.magnetised.map_or(0.0, |how| how.beyond);
        let (condition, damping) = (&spec.conditions[case.condition].name, &spec.mount.cases[case.damping].label);
        format!(
            "{condition}, {damping}: in {} % of the time a gap between windings is more than a third off that of even windings. There L counts magnetisation as that of \
             even windings; how far F_L may be off by it is in the uncertainty of a sensor by inductance.",
            digits(100.0 * beyond)
        )
    };
    cases.iter().filter(uneven).map(told).collect()
}

/// Of stainless spring wire \[Ω m\], as four measured springs have it.
const STAINLESS: f64 = 7.5e-7;

/// A meter at whose frequency the current crowds in the wire's skin.
pub(super) fn frequency(spring: &SpringSpec, sensor: &SensorSpec) -> Option<String> {
    // The browser's first load has no room for it.
    let frequency = sensor.frequency.filter(|_| cfg!(feature = "steel"))?;
    let wire = spring.geometry.material();
    let resistivity = wire.resistivity().unwrap_or(STAINLESS);
    let permeability = wire.relative_permeability().unwrap_or(1.0).max(1.0);
    let limit = direct_up_to(spring.spring.wire_radius(), resistivity, permeability).ok()?;
    (frequency > limit).then(|| {
        format!(
            "{}: at {} kHz the current crowds in the wire's skin, which L and F_L leave out: they hold up to {} kHz for this wire{}. Calibrate at the frequency in use.",
            sensor.name,
            digits(1e-3 * frequency),
            digits(1e-3 * limit),
            match wire.relative_permeability() {
                Some(_) => "",
                None => " if it is not magnetic, and less far if it is",
            }
        )
    })
}
