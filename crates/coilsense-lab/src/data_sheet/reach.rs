//! How far the axial model reaches: what other modes put into an axial force, and from which frequency on.
//!
//! Next door: the modes (`crate::helix`).

use crate::helix::{ModeLine, ModesAt, UnderEnds};

/// From so large a difference on, f1 of the model is told not to be that of the coil.
const ANOTHER_SURGE: f64 = 0.005;

/// A mode at a length and with the ends in one way.
#[derive(Debug, Clone, Copy)]
struct Place<'a> {
    length: f64,
    way: &'a UnderEnds,
    mode: &'a ModeLine,
}

/// Sentences for people who rely on the axial model.
///
/// - `model`: f1 of both ends held in the model that is used \[Hz\]; `own`: its first frequency on the spec's own mount \[Hz\]
/// - `goal`: what error is wanted, as a share
pub(super) fn warnings(all: &[ModesAt], model: f64, own: f64, goal: f64) -> Vec<String> {
    let mut sentences: Vec<String> = another_surge(all, model).into_iter().collect();
    sentences.extend(["torsional", "lateral"].into_iter().filter_map(|kind| below(all, kind, own)));
    sentences.extend(limit(all, goal));
    sentences.extend(buckled(all));
    sentences
}

fn places(all: &[ModesAt]) -> impl Iterator<Item = Place<'_>> {
    let of_way = |length: f64| move |way| of(length, way);
    all.iter().flat_map(move |at| at.ways().flat_map(of_way(at.length_m)))
}

fn of(length: f64, way: &UnderEnds) -> impl Iterator<Item = Place<'_>> {
    way.modes.iter().map(move |mode| Place { length, way, mode })
}

/// The surge of the helix, where it is not the model's.
fn another_surge(all: &[ModesAt], model: f64) -> Option<String> {
    let ways = all.iter().flat_map(|at| at.ways().map(move |way| (at.length_m, way)));
    let off = |way: &UnderEnds| (way.first_surge_hz / model - 1.0).abs();
    let (length, way) = ways.max_by(|a, b| off(a.1).total_cmp(&off(b.1)))?;
    let departure = way.first_surge_hz / model - 1.0;
    (departure.abs() > ANOTHER_SURGE).then(|| {
        format!(
            "f1 of the coil as a helix is {:.1} Hz at {:.1} mm ({}), {:.1} % {} the {model:.1} Hz of the axial model.",
            way.first_surge_hz,
            1e3 * length,
            way.ends,
            100.0 * departure.abs(),
            if departure < 0.0 { "below" } else { "above" },
        )
    })
}

/// Motion of a kind below the first mode of the model.
fn below(all: &[ModesAt], kind: &str, own: f64) -> Option<String> {
    let of_kind = || places(all).filter(|place| place.mode.kind == kind && place.mode.frequency_hz < own);
    let lowest = of_kind().min_by(|a, b| a.mode.frequency_hz.total_cmp(&b.mode.frequency_hz))?;
    let strongest = of_kind().map(|place| place.mode.read_strength).fold(0.0, f64::max);
    let beside = all.iter().filter(|at| at.length_m == lowest.length).flat_map(ModesAt::ways);
    let others: String = beside
        .filter(|way| way.ends != lowest.way.ends)
        .filter_map(|way| Some(format!("; {}: {:.1} Hz", way.ends, way.first(kind)?.frequency_hz)))
        .collect();
    Some(format!(
        "{kind} motion starts at {:.1} Hz at {:.1} mm ({}{others}), below the first axial mode of {own:.1} Hz; in the axial force its line has \
         {} % of an axial line's strength.",
        lowest.mode.frequency_hz,
        1e3 * lowest.length,
        lowest.way.ends,
        percent(strongest),
    ))
}

/// The lowest line of another kind that is stronger than the goal.
fn limit(all: &[ModesAt], goal: f64) -> Option<String> {
    let other = |place: &Place<'_>| place.mode.kind != "axial" && place.mode.frequency_hz != place.way.first_surge_hz;
    let strong = places(all).filter(|place| other(place) && place.mode.read_strength > goal);
    let lowest = strong.min_by(|a, b| a.mode.frequency_hz.total_cmp(&b.mode.frequency_hz))?;
    Some(format!(
        "the axial model holds to {} % up to {:.1} Hz: there, at {:.1} mm ({}), a {} line stands in the axial force with {} % of an axial \
         line's strength.",
        percent(goal),
        lowest.mode.frequency_hz,
        1e3 * lowest.length,
        lowest.way.ends,
        lowest.mode.kind,
        percent(lowest.mode.read_strength),
    ))
}

/// Where the spring leaves its axis.
pub(super) fn buckled(all: &[ModesAt]) -> Option<String> {
    let mut each: Vec<String> = Vec::new();
    for at in all {
        let ways: Vec<&str> = at.ways().filter(|way| way.buckles).map(|way| way.ends.as_str()).collect();
        if !ways.is_empty() {
            each.push(format!("at {:.1} mm with {}", 1e3 * at.length_m, ways.join(" and with ")));
        }
    }
    (!each.is_empty()).then(|| {
        format!("the spring buckles {} unless a guide holds it; the axial model leaves that out.", each.join(", "))
    })
}

/// Two significant digits of a share.
fn percent(share: f64) -> String {
    let value = 100.0 * share;
    if value >= 10.0 {
        return format!("{value:.0}");
    }
    let decimals = if value > 0.0 { (1.0 - value.log10().floor()).clamp(1.0, 6.0) as usize } else { 1 };
    let text = format!("{value:.decimals$}");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}
