//! What a reader must know of windings that met, and of ends that left their seats.
//!
//! Next door: the other warnings (`warnings`), the meetings themselves (`crate::study::Contacts`).

use coilsense::contact::Touch;

use super::case::Case;
use crate::quantity::digits;
use crate::spec::Spec;
use crate::study::{Between, Contacts};

/// Windings that meet, and ends that leave their seats: what of it a reader must know, under the case in which most of it happens.
pub(super) fn of(spec: &Spec, cases: &[&Case]) -> Option<String> {
    let of = |case: &&Case| case.contacts.clone().map(|contacts| (case.damping, contacts));
    let each: Vec<(usize, Contacts)> =
        cases.iter().filter_map(of).filter(|(_, contacts)| contacts.first.is_some()).collect();
    let (damping, most) = each
        .iter()
        .max_by_key(|(_, contacts)| contacts.touches.len() + contacts.lifts.len() + contacts.floats.len())?;
    let label = |damping: usize| spec.mount.cases[damping].label.as_str();
    let mut text = format!("{}, {}: {}.", spec.conditions[cases[0].condition].name, label(*damping), happened(most));
    let clear = cases.len() - each.len();
    if clear > 0 {
        text.push_str(&format!(" In {clear} of {} cases of this condition nothing meets.", cases.len()));
    }
    let short = |(damping, contacts): &(usize, Contacts)| {
        let until = contacts.holds_until.filter(|until| *until < contacts.until)?;
        Some((until, format!("{} from t = {until:.4} s on", label(*damping)), contacts.apart))
    };
    let lost: Vec<(f64, String, f64)> = each.iter().filter_map(short).collect();
    if let Some((_, _, apart)) = lost.first() {
        let each: Vec<&str> = lost.iter().map(|(_, words, _)| words.as_str()).collect();
        text.push_str(&format!(
            " An input larger by a millionth moves an end force by more than {} N at {}: what comes after that is good in its rms and its extremes \
             only.",
            digits(*apart),
            each.join("; ")
        ));
    }
    let blows = Between::SEATS.map(|seat| most.seat_impulses(seat).map(|(_, impulse)| impulse).fold(0.0, f64::max));
    if let Some(largest) = blows.into_iter().reduce(f64::max).filter(|impulse| *impulse > 0.0) {
        text.push_str(&format!(
            " Seats are struck with up to {} mN s at once, which is in no force series: a sensor of bandwidth B shows it as a peak of about {} N \
             for each kHz of B, and where it has one, or the goal does, is judged with that.",
            digits(1e3 * largest),
            digits(2e3 * std::f64::consts::PI * largest),
        ));
    }
    Some(text)
}

/// Windings that are together for a smaller share of the time only strike each other.
const LEAST_TOGETHER: f64 = 1e-4;

/// What happened in a run, in a clause or two.
fn happened(contacts: &Contacts) -> String {
    let mut clauses = Vec::new();
    if !contacts.touches.is_empty() {
        let longest = contacts.meetings.iter().max_by(|a, b| a.closed.total_cmp(&b.closed));
        let together = longest.filter(|longest| longest.closed >= LEAST_TOGETHER).map_or_else(String::new, |longest| {
            format!(", {} together for {} % of the time", longest.between.words(), digits(100.0 * longest.closed))
        });
        // Only what was closed before the input began can touch at 0.
        let resting = contacts.touches.iter().take_while(|touch| touch.time == 0.0).count();
        let (at_start, later) = contacts.touches.split_at(resting);
        let fastest = |touches: &[Touch]| touches.iter().map(|touch| touch.closing_speed).fold(0.0, f64::max);
        if resting > 0 {
            let blow = fastest(at_start);
            let struck = if blow > 0.0 {
                format!(", and the input sets out against them at {} m/s", digits(blow))
            } else {
                String::new()
            };
            clauses.push(format!("{resting} points of the wire are closed from the start{struck}"));
        }
        if let Some(first) = later.first() {
            clauses.push(format!(
                "windings meet from t = {:.4} s on ({} at {} m/s), {} times, at up to {} m/s{together}",
                first.time,
                contacts.between(first).words(),
                digits(first.closing_speed),
                later.len(),
                digits(fastest(later)),
            ));
        }
    }
    if let Some(first) = contacts.lifts.first() {
        let aloft: f64 = contacts.lifts.iter().map(|lift| lift.back.unwrap_or(contacts.until) - lift.time).sum();
        let end = if first.is_end2 { "end 2" } else { "end 1" };
        clauses.push(format!(
            "an end leaves its seat {} times, first {end} at t = {:.4} s, for {} ms in all",
            contacts.lifts.len(),
            first.time,
            digits(1e3 * aloft)
        ));
    }
    if let Some(first) = contacts.floats.first() {
        let fastest = contacts.floats.iter().map(|float| float.closing_speed).fold(0.0, f64::max);
        clauses.push(format!(
            "the follower leaves its cam {} times, first at t = {:.5} s for {}, {} ms in all, and comes down at up to {} m/s",
            contacts.floats.len(),
            first.time,
            first.back.map_or_else(|| "good".to_owned(), |back| format!("{} ms", digits(1e3 * (back - first.time)))),
            digits(1e3 * contacts.floated()),
            digits(fastest)
        ));
    }
    clauses.join("; ")
}
