//! Load cells that would have to read more than they can.
//!
//! Next door: the verdict that hangs on it (`judge`, `assessed`), the warning (`warnings`).

use super::case::Case;
use crate::spec::{SensorSpec, Spec};

/// Up to what a load cell reads \[N\]; without bound for what estimates a force.
pub(super) fn full_scale(spec: &Spec, sensor: &SensorSpec) -> f64 {
    // F_nom is the full scale where nobody chose one, and a spring held there rings about it: that one is meant with a margin.
    let margin = if sensor.range == spec.spring.spring.nominal_force() { 1.25 } else { 1.0 };
    if sensor.quantity.estimates() { f64::INFINITY } else { margin * sensor.range }
}

/// The case in which a load cell sees most, and that \[N\]; `None` within its full scale.
pub(super) fn overload<'a>(
    spec: &Spec,
    index: usize,
    sensor: &SensorSpec,
    cases: &'a [Case],
) -> Option<(&'a Case, f64)> {
    let peak = |case: &Case| case.readings[index].native.iter().fold(0.0_f64, |peak, value| peak.max(value.abs()));
    let most = cases.iter().map(|case| (case, peak(case))).max_by(|a, b| a.1.total_cmp(&b.1));
    most.filter(|(_, most)| *most > full_scale(spec, sensor))
}
