//! What comes first in the answer of a placement: which force to feed back, how fast, and what then holds.
//!
//! Next door: the rest of the answer (`answer`), its numbers (`super`).

use coilsense::control::Environment;

use super::words::{place, unstable, upto};
use super::{Candidate, MOST_PEAK, Peak, Placement, TIE};
use crate::quantity::digits;

/// What is recommended, or what a crossover that is given does.
pub(super) fn head(placement: &Placement, best: &Candidate) -> String {
    let channel = best.channel;
    let is_instant = !placement.spec.sensors.is_empty() && placement.reading(channel).sensor.is_none();
    let without = if is_instant { "; the spec has no sensor of it" } else { "" };
    let name = format!("{} ({}{without})", channel.name(), place(channel));
    if best.stable_crossover() == 0.0 {
        return "No force can be fed back with this controller: no loop is stable at any gain.".to_owned();
    }
    if !best.is_stable() {
        let nearest = placement.candidates.iter().max_by(|a, b| a.stable_crossover().total_cmp(&b.stable_crossover()));
        let nearest = nearest.unwrap_or(best);
        return format!(
            "No force is stable at the crossover of {} Hz; {} ({}) comes nearest: {}.",
            digits(placement.crossover),
            nearest.channel.name(),
            place(nearest.channel),
            upto("stability", 0.0, nearest.stable_crossover())
        );
    }
    let weak = match (placement.follows, placement.control.environment) {
        (Some([slow, _]), Environment::Held) if slow < FOLLOWS => {
            format!(" Such gains hardly control the force: F_o is at {} of even a slow reference.", digits(slow))
        }
        _ => String::new(),
    };
    recommended(placement, best, &name) + &weak
}

fn recommended(placement: &Placement, best: &Candidate, name: &str) -> String {
    let within = format!("both ends stay within {MOST_PEAK} times their static response");
    if let Some(crossover) = placement.control.crossover {
        return format!(
            "Feed back {name}: at the crossover of {} Hz as set {}.",
            digits(crossover),
            verdict(best, &within)
        );
    }
    match (best.robust_from(), best.calm_crossover, best.robust_crossover()) {
        (0.0, calm, _) if calm > 0.0 => format!(
            "Feed back {name}, up to a crossover of {} Hz: its sensitivity is at most 2 there, and {within}.",
            digits(calm)
        ),
        (from, calm, _) if calm > 0.0 => format!(
            "Feed back {name}, at a crossover of {} to {} Hz: its sensitivity is at most 2 there, and {within}.",
            digits(from),
            digits(calm)
        ),
        (_, _, 0.0) => format!(
            "Feed back {name}, yet at every gain its sensitivity is above 2 at some damping: {}.",
            upto("stability", 0.0, best.stable_crossover())
        ),
        (from, _, robust) => {
            format!("Feed back {name}, yet an end rings: {}.", upto("a sensitivity of at most 2", from, robust))
        }
    }
}

/// Whether the loop that is set is stable, robust and quiet.
fn verdict(best: &Candidate, within: &str) -> String {
    let modulus = best.judged.iter().map(|judged| judged.margins.modulus).fold(f64::INFINITY, f64::min);
    let (sensitivity, loud) = (1.0 / modulus, loudest(best).filter(|peak| peak.over_static > MOST_PEAK));
    let robust = if sensitivity > 2.0 * (1.0 + 1e-6) { ", above the limit of 2" } else { "" };
    let quiet = match loud {
        None => format!("and {within}"),
        Some(peak) => format!(
            "yet {} peaks at {} times its static response at {} Hz, above the limit of {MOST_PEAK}",
            peak.force.name(),
            digits(peak.over_static),
            digits(peak.at)
        ),
    };
    format!("it is stable with a sensitivity of up to {}{robust}, {quiet}", digits(sensitivity))
}

/// The largest peak as set.
fn loudest(best: &Candidate) -> Option<&Peak> {
    let peaks = best.judged.iter().filter_map(|judged| judged.peaks.as_ref()).flatten();
    peaks.max_by(|a, b| a.over_static.total_cmp(&b.over_static))
}

/// What does not excite what rings, and what does.
const UNLESS: &str = "A reference without content there does not excite that, what disturbs the loop does";

/// Up to where what holds of the force, and what rings past that.
pub(super) fn limits(placement: &Placement, best: &Candidate) -> Option<String> {
    let stable = best.stable_crossover();
    if stable == 0.0 {
        return None;
    }
    let calm = best.calm_crossover;
    let quiet = match (placement.control.crossover, best.rings) {
        (Some(_), Some(_)) if calm > 0.0 => {
            format!("both ends within {MOST_PEAK} times up to a crossover of {} Hz, ", digits(calm))
        }
        _ => String::new(),
    };
    let robust = upto("a sensitivity of at most 2", best.robust_from(), best.robust_crossover());
    // A loop with three integrations is stable again where it is fast.
    let again = if best.is_stable() && placement.crossover > stable * (1.0 + TIE) {
        "; as set it is past a range in which it is not stable, and stable again"
    } else {
        ""
    };
    let limits =
        format!("Limits as the loop is made faster: {quiet}{robust}, {}{again}", upto("stability", 0.0, stable));
    let Some((fastest, rings)) = best.rings else { return Some(format!("{limits}.")) };
    let (force, size, at) = (rings.force.name(), digits(rings.over_static), digits(rings.at));
    let there = format!("at {} Hz {force} peaks at {size} times its static response at {at} Hz", digits(fastest));
    // Where slow loops are the less damped ones, both ends may be quiet in one that is not robust.
    let slower =
        if best.robust_from() > 0.0 { "no slower loop with a sensitivity of at most 2" } else { "no slower loop" };
    Some(match calm {
        0.0 => format!(
            "{limits}; {there}, and {slower} keeps both ends within {MOST_PEAK} times. {UNLESS}; more damping of the spring or the load lowers it."
        ),
        _ => format!("{limits}; {there}. {UNLESS}."),
    })
}

/// What the loop is like as it is set.
pub(super) fn set(placement: &Placement, best: &Candidate) -> Option<String> {
    if !best.is_stable() {
        return None;
    }
    let phase = best.judged.iter().map(|judged| judged.margins.phase).fold(f64::INFINITY, f64::min).to_degrees();
    let phase = if phase.is_finite() { format!("a phase margin of {phase:.0}°, ") } else { String::new() };
    let loads = best.judged.iter().filter_map(|judged| judged.peaks).map(|[_, load]| load);
    let peak = loads.max_by(|a, b| a.size.total_cmp(&b.size)).filter(|peak| peak.size > LEAST_PEAK);
    let peak = peak.map_or_else(
        || "no peak of F_o above it".to_owned(),
        |peak| format!("a peak of F_o of {} times it at {} Hz", digits(peak.size), digits(peak.at)),
    );
    let follows = match placement.follows {
        None => String::new(),
        Some([slow, _]) if slow < FOLLOWS => format!("F_o at {} of even a slow reference, ", digits(slow)),
        Some([_, up_to]) if up_to.is_infinite() => {
            "F_o following the reference within 3 dB at all frequencies up to f4, ".to_owned()
        }
        Some([_, up_to]) => {
            format!("F_o following the reference within 3 dB up to {} Hz (nominal spring), ", digits(up_to))
        }
    };
    Some(format!(
        "At {} Hz: {phase}{follows}{peak}; unstable on {}; all {}.",
        digits(placement.crossover),
        unstable(placement),
        damping(placement),
    ))
}

/// A force that would bear a faster loop than the one chosen, where the reference has no content at what rings.
pub(super) fn faster(placement: &Placement, best: &Candidate) -> Option<String> {
    let robust = best.robust_crossover();
    let readable = |other: &&Candidate| placement.reading(other.channel).coarse.is_none();
    let others = placement.candidates.iter().filter(readable).filter(|other| other.robust_crossover() > 2.0 * robust);
    let other = others.max_by(|a, b| a.robust_crossover().total_cmp(&b.robust_crossover()))?;
    let (_, rings) = other.rings?;
    Some(format!(
        "On {} ({}): {}, though {} then peaks at {} times its static response at {} Hz: only for references without content there, as behind a low-pass.",
        other.channel.name(),
        place(other.channel),
        upto("a sensitivity of at most 2", other.robust_from(), other.robust_crossover()),
        rings.force.name(),
        digits(rings.over_static),
        digits(rings.at)
    ))
}

/// A force that rises by less over the reference has no peak \[1\].
const LEAST_PEAK: f64 = 1.05;

/// What F_o over the reference must reach to follow it: −3 dB.
pub(crate) const FOLLOWS: f64 = std::f64::consts::FRAC_1_SQRT_2;

/// Over which damping all holds.
fn damping(placement: &Placement) -> String {
    let labels: Vec<&str> = placement.dampings.iter().map(|damping| damping.label.as_str()).collect();
    let between = if labels.iter().any(|label| label.contains(',')) { "; " } else { ", " };
    let labels = labels.join(between);
    match placement.spec.mount.is_band {
        true => format!(
            "over {labels}, assumed since the spec gives no damping (how quiet the ends are goes with the least of them: measure ζ)"
        ),
        false => format!("over {labels}"),
    }
}
