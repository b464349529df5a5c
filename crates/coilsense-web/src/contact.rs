//! Windings that met, for the page: what it says of them, and from when to when they lie on each other, for the animation.
//!
//! Next door: what is counted (`coilsense_lab::study::Contacts`), the case that holds it (`exact`, `preview`).

use coilsense::contact::{Lift, Touch};
use coilsense_lab::spec::DampingCase;
use coilsense_lab::study::{Between, Contacts, Meeting};
use serde_json::{Value, json};

/// Whether this build follows windings that meet; one that does not shall not carry what tells of them.
const MEET: bool = cfg!(feature = "workshop");

/// The law of a case and what it came to; null where windings pass through one another.
///
/// Names and values are those of `contact` in `results.json`, without the list of touches.
pub(crate) fn of_case(way: &DampingCase, contacts: Option<&Contacts>) -> Value {
    let (true, Some(way), Some(contacts)) = (MEET, &way.contact, contacts) else { return Value::Null };
    let fastest = contacts.touches.iter().map(|touch| touch.closing_speed).fold(0.0, f64::max);
    let aloft = |lift: &Lift| lift.back.unwrap_or(contacts.until) - lift.time;
    let meeting = |meeting: &Meeting| {
        json!({
            "between": meeting.between.words(),
            "touches": meeting.count,
            "closed": meeting.closed,
            "speed": meeting.speed,
        })
    };
    json!({
        "law": way.label,
        "isAssumed": way.is_assumed,
        "ends": way.contact.ends(),
        "first": contacts.touches.first().map(|touch| touch.time),
        "between": contacts.touches.first().map(|touch| contacts.between(touch).words()),
        "speed": contacts.touches.first().map(|touch| touch.closing_speed),
        "touches": contacts.touches.len(),
        "fastest": fastest,
        "lost": contacts.balance.lost,
        "pairs": contacts.meetings.iter().map(meeting).collect::<Vec<_>>(),
        "lifts": contacts.lifts.len(),
        "aloft": contacts.lifts.iter().map(aloft).sum::<f64>(),
        "holdsUntil": contacts.holds_until,
        "apart": contacts.apart,
        "until": contacts.until,
    })
}

/// When what lies on what: `closed from`, `closed to` \[s\] and `closed gap`, of which 0 is seat 1 and the first winding, i windings i and i + 1, and N
/// the last winding and seat 2; `off from`, `off to` \[s\] and `off end`, 1 or 2, of ends that have left their seats.
pub(crate) fn series(contacts: &Contacts) -> Vec<(String, Vec<f64>)> {
    if !MEET {
        return Vec::new();
    }
    let windings = contacts.masses / contacts.masses_per_winding;
    let gap = |touch: &Touch| match contacts.between(touch) {
        Between::Seat1 => 0.0,
        Between::Windings(first) => first as f64,
        Between::Seat2 => windings as f64,
    };
    let of_touches = |value: &dyn Fn(&Touch) -> f64| contacts.touches.iter().map(value).collect();
    let of_lifts = |value: &dyn Fn(&Lift) -> f64| contacts.lifts.iter().map(value).collect();
    [
        ("closed from", of_touches(&|touch| touch.time)),
        ("closed to", of_touches(&|touch| touch.parted.unwrap_or(contacts.until))),
        ("closed gap", of_touches(&gap)),
        ("off from", of_lifts(&|lift| lift.time)),
        ("off to", of_lifts(&|lift| lift.back.unwrap_or(contacts.until))),
        ("off end", of_lifts(&|lift| if lift.is_end2 { 2.0 } else { 1.0 })),
    ]
    .map(|(name, values)| (name.to_owned(), values))
    .into()
}
