//! What a reader must know of the inductance of magnetic wire.
//!
//! Next door: the other warnings (`warnings`), the inductance itself (`crate::spec::SpringInductance`).

use coilsense::inductance::direct_up_to;

use super::case::Case;
use crate::quantity::digits;
use crate::spec::{STAINLESS, SensorSpec, Spec, SpringSpec};

/// Windings of magnetic wire that are too uneven, in the case of a condition in which most of the time.
pub(super) fn uneven(spec: &Spec, cases: &[&Case]) -> Option<String> {
    // What is never told need not be loaded.
    if !cfg!(feature = "steel") {
        return None;
    }
    let beyond = |case: &&&Case| case.magnetised.map_or(0.0, |how| how.beyond);
    let most = cases.iter().max_by(|a, b| beyond(a).total_cmp(&beyond(b)))?;
    let share = beyond(&most);
    let (condition, damping) = (&spec.conditions[most.condition].name, &spec.mount.cases[most.damping].label);
    (share > 0.0).then(|| {
        format!(
            "{condition}, {damping}: for {} % of the time a gap between windings differs by more than a third from that of evenly spaced ones. L and F_L then count \
             the magnetisation of evenly spaced windings; what that may be off is in the uncertainty of a sensor by inductance.",
            digits(100.0 * share)
        )
    })
}

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
            "{}: at {} kHz the skin effect matters, which L and F_L leave out: they hold up to {} kHz for this wire{}. Calibrate at the frequency in use.",
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
