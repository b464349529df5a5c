//! What a page says of a spec, its spring and a case, as JSON.
//!
//! Next door: curves (`preview`, `exact`).

use coilsense::modes::ChainModes;
use coilsense::{Clash, Deviation};
use coilsense_lab::spec::Spec;
use serde_json::{Value, json};

/// Surge lines that a page marks: those above it are no more told apart.
const MOST_LINES: usize = 12;

/// Spring, conditions, dampings and sensors of a spec.
pub(crate) fn of_spec(spec: &Spec, condition: usize, damping: usize) -> Value {
    let spring = &spec.spring.spring;
    let (shortest, longest) = spring.operating_range();
    let modes = ChainModes::mounted(spring, spec.mount.far_end());
    let lines = modes.frequencies().iter().take(MOST_LINES).map(|angular| angular / std::f64::consts::TAU);
    let conditions = spec.conditions.iter().map(|condition| {
        json!({
            "name": condition.name,
            "kind": condition.kind,
            "duration": condition.duration,
            "window": [condition.window.0, condition.window.1],
            "sampleRate": condition.sample_rate,
        })
    });
    let dampings = spec.mount.cases.iter().map(|case| json!({ "label": case.label, "ratio": case.ratio }));
    let mean_length = spec.conditions.get(condition).map(|condition| condition.excitation.mean_length());
    json!({
        "spring": {
            "name": spec.spring.name,
            "material": spec.spring.material,
            "byGeometry": spec.spring.by_geometry,
            "stiffness": spring.stiffness(),
            "mass": spec.spring.mass,
            "restLength": spring.rest_length(),
            "minLength": shortest,
            "maxLength": longest,
            "windings": spring.windings(),
            "masses": spring.whole_windings(),
            "massesPerWinding": spring.masses_per_winding(),
            "modelFrequency": spring.chain_frequency(),
            "coilRadius": spring.coil_radius(),
            "wireDiameter": spring.wire_diameter(),
            "contactPitch": spec.spring.contact_pitch(),
            "solidLength": spec.spring.solid_length(),
            "nominalForce": spring.nominal_force(),
            "surgeFrequency": spring.surge_frequency(),
            "transitTime": spring.transit_time(),
        },
        "meanLength": mean_length,
        "staticForce": mean_length.map(|length| spring.static_force(length)),
        "lines": lines.collect::<Vec<f64>>(),
        "conditions": conditions.collect::<Vec<_>>(),
        "dampings": dampings.collect::<Vec<_>>(),
        "isBand": spec.mount.is_band,
        "condition": condition,
        "damping": damping,
        "truth": spec.goal.force.name(),
        "goal": spec.goal.error,
    })
}

/// A deviation \[N\].
pub(crate) fn of_deviation(deviation: &Deviation) -> Value {
    json!({
        "rmsd": deviation.rmsd,
        "maximum": deviation.maximum,
        "maximumAbsolute": deviation.maximum_absolute,
        "mean": deviation.mean,
    })
}

/// How near the windings come.
pub(crate) fn of_clash(clash: &Clash) -> Value {
    json!({
        "smallestPitch": Some(clash.smallest_pitch).filter(|pitch| pitch.is_finite()),
        "contactPitch": clash.contact_pitch,
        "time": clash.time,
        "winding": clash.winding,
        "firstContact": clash.first_contact,
    })
}
