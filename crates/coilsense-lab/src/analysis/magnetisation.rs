//! What a reader must know of the inductance of magnetic wire.
//!
//! Next door: the other warnings (`warnings`), the inductance itself (`crate::spec::SpringInductance`).

use coilsense::inductance::{OverLength, SteelTurns, direct_up_to};
use coilsense::sensors::Quantity;

use super::case::Case;
use crate::quantity::digits;
use crate::spec::{PermeabilityFound, STAINLESS, SensorSpec, Spec, SpringSpec};

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

/// The names of sensors that look at the inductance; none where there are none.
fn by_inductance(sensors: &[SensorSpec]) -> Option<String> {
    let each = sensors.iter().filter(|sensor| matches!(sensor.quantity, Quantity::Inductance { .. }));
    let names: Vec<&str> = each.map(|sensor| sensor.name.as_str()).collect();
    (!names.is_empty()).then(|| names.join(", "))
}

/// Sensors by the inductance of wire that may be magnetic, of which the spec tells no permeability.
pub(super) fn untold(spec: &Spec, sensors: &[SensorSpec]) -> Option<String> {
    let found = spec.spring.permeability_found()?;
    let (names, material) = (by_inductance(sensors)?, &spec.spring.material);
    Some(match found {
        PermeabilityFound::Above(least) => format!(
            "{names}: {material} is strongly magnetic, its relative permeability above {least} at a meter's field and less at higher frequencies. L and F_L are computed for wire that is not \
             magnetic; the real L is far larger, and the error of the calibration's form in the budget is a lower bound. Calibrate at the frequency you use and give calibration_form.",
        ),
        PermeabilityFound::Between(least, most) => {
            let more = larger(&spec.spring, most).map_or_else(String::new, |share| {
                format!("; at {most} the real L is up to {} % larger", digits(100.0 * share))
            });
            format!(
                "{names}: the spec does not tell the permeability of its wire. Springs of such wire had {least} to {most}. L and F_L are computed for 1{more}. The budget includes what \
                 eq. (13) leaves at {most}. Tell relative_permeability, or find it with coilsense calibrate --theory steel."
            )
        }
    })
}

/// By which share L is larger with a permeability, where it is most so.
fn larger(spring: &SpringSpec, permeability: f64) -> Option<f64> {
    let (air, (shortest, longest)) = (spring.inductance_in_air(), spring.spring.operating_range());
    let turns = SteelTurns::over(&air, spring.spring.wire_radius(), permeability, [shortest, longest]).ok()?;
    let share = |length: f64| turns.at_length(length) / air.at_length(length) - 1.0;
    Some(share(shortest).max(share(longest)))
}

/// How an inductance of magnetic wire drifts with temperature, which nobody knows.
pub(super) fn drift(spec: &Spec, sensors: &[SensorSpec]) -> Option<String> {
    let found = spec.spring.permeability_found();
    let magnetic = spec.spring.is_magnetic() || found.is_some();
    if !cfg!(feature = "steel") || !magnetic || spec.uncertainty.temperature_change == 0.0 {
        return None;
    }
    let names = by_inductance(sensors)?;
    // Of springs found at 2.0 to 3.0.
    let share = match found {
        Some(PermeabilityFound::Above(_)) => "",
        _ => ", and 1 % of permeability is 0.12 to 0.18 % of L",
    };
    Some(format!(
        "{names}: how the permeability of its wire changes with temperature is not known; the budget includes thermal expansion alone{share}."
    ))
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
