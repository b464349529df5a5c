//! Load cells that would have to read more than they can.
//!
//! Next door: the verdict that hangs on it (`judge`, `assessed`), the warning (`warnings`).

use super::case::Case;
use super::change::Fix;
use super::verdict::Verdict;
use crate::quantity::digits;
use crate::spec::{SensorSpec, Spec};

/// Up to what a load cell reads \[N\]; without bound for what estimates a force, and where nobody chose a range.
pub(super) fn full_scale(sensor: &SensorSpec) -> f64 {
    if sensor.quantity.estimates() || !sensor.range_is_given { f64::INFINITY } else { sensor.range }
}

/// The case in which a load cell sees most, and that \[N\]; `None` within its full scale.
pub(super) fn overload<'a>(index: usize, sensor: &SensorSpec, cases: &'a [Case]) -> Option<(&'a Case, f64)> {
    most(index, cases).filter(|(_, most)| *most > full_scale(sensor))
}

/// What a reader must know of a range: that it is exceeded, or of one that nobody chose, that errors are those of a smaller cell than is needed.
pub(super) fn warning(spec: &Spec, index: usize, sensor: &SensorSpec, cases: &[Case]) -> Option<String> {
    let (case, most) = most(index, cases)?;
    let (name, condition, range) = (&sensor.name, &spec.conditions[case.condition].name, sensor.range);
    if most > full_scale(sensor) {
        let share = 100.0 * most / range;
        return Some(format!("{name}: {most:.1} N in {condition} is {share:.0} % of its full scale of {range:.1} N."));
    }
    // Without sensors a spec is judged by perfect ones.
    let is_asked = !sensor.quantity.estimates() && !sensor.range_is_given && !spec.sensors.is_empty();
    (is_asked && most > MARGIN * range).then(|| {
        format!(
            "{name}: no range is given, so its errors are those of a cell of {} N (F_nom), and it has to read up to {} N in {condition}.",
            digits(range),
            digits(most)
        )
    })
}

/// A spring that is held at F_nom rings about it.
const MARGIN: f64 = 1.25;

/// The case in which a sensor sees most, and that, in its native unit. What comes after windings have touched that pass through one another is no force
/// of this spring, and does not count.
fn most(index: usize, cases: &[Case]) -> Option<(&Case, f64)> {
    let peak = |case: &Case| {
        let contact = case.clash.first_contact.filter(|_| case.contacts.is_none());
        let times = case.signals.time();
        let count = contact.map_or(times.len(), |contact| times.partition_point(|time| *time < contact));
        case.readings[index].native[..count].iter().fold(0.0_f64, |peak, value| peak.max(value.abs()))
    };
    cases.iter().map(|case| (case, peak(case))).max_by(|a, b| a.1.total_cmp(&b.1))
}

/// What would let an overloaded load cell meet the goal that its uncertainty meets already.
pub(super) fn wider(spec: &Spec, verdict: &Verdict) -> Option<Fix> {
    let (most, goal, combined) = (verdict.overload?, spec.goal.error?, verdict.combined());
    let meets = combined <= goal && !verdict.too_slow;
    let change = format!("a range of {} N, if its errors in N stay the same", digits(HEADROOM * most));
    meets.then_some(Fix { change, combined, lag: verdict.lag })
}

/// So much above what a load cell sees its range is to be: what is printed is rounded.
const HEADROOM: f64 = 1.01;
