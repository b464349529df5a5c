//! Which coils are tried on the lines of a record, from where.
//!
//! Next door: how a search begins (`beginnings`), each kind of mount (`giving`, `resonating`, `moving_end`), what is no coil (`rivals`), what is
//! made of all of them (the parent).

use super::beginnings::{beginnings, trials};
use super::explanation::Explanation;
use super::finalists::finished;
use super::giving::giving;
use super::known::{Known, Mount};
use super::place::{Place, Sketch};
use super::resonating::resonating;
use super::room::Room;
use super::{ends, moving_end};
use crate::identify::phase_law::Seat;

/// ln of how likely an end that moves is beside held ends, before the lines are looked at.
const MOVES: f64 = -0.7;
/// The same where no record says that it does.
const UNSEEN_MOVES: f64 = -5.0;
/// Coils between held ends from which other mounts are sought.
const STARTS: usize = 4;

/// Every coil that the lines allow.
pub(super) fn coils(room: &Room, known: &Known) -> Vec<Explanation> {
    let mut found = Vec::new();
    let held = held(room, known);
    let may = |mount: Mount| known.mounts.contains(&mount);
    if may(Mount::Held) {
        found.extend(held.iter().take(12).map(|place| known.coil(room, place.clone(), 0.0)));
    }
    let mut starts: Vec<&Place> = Vec::new();
    for place in &held {
        let alike = |other: &&Place| (other.trial.base / place.trial.base).ln().abs() < 0.02;
        if starts.len() < STARTS && !starts.iter().any(alike) {
            starts.push(place);
        }
    }
    if may(Mount::Gives) {
        for place in starts.iter().take(2) {
            found.extend(giving(room, known, place));
        }
        found.extend(resonating(room, known, &starts));
    }
    let moves = if known.end_moves { MOVES } else { UNSEEN_MOVES };
    if may(Mount::Free) {
        let places = moving_end::free(room, known);
        found.extend(places.into_iter().map(|place| known.coil(room, place, moves)));
    }
    if may(Mount::Mass) {
        let places = moving_end::with_mass(room, known, &starts);
        found.extend(places.into_iter().map(|place| known.coil(room, place, moves)));
    }
    found.sort_by(|a, b| b.total.total_cmp(&a.total));
    found
}

/// By how much F_o is later than F_i \[s\], where the likeliest held coil's ends say so.
pub(super) fn delay(room: &Room, known: &Known) -> Option<f64> {
    let held = if known.both && room.heard.len() > 2 { held(room, known) } else { Vec::new() };
    ends::delay(held.iter().max_by(|a, b| a.evidence.total_cmp(&b.evidence))?, room.heard, known.turned)
}

/// Coils between held ends, likeliest first.
fn held(room: &Room, known: &Known) -> Vec<Place> {
    let seats = [Seat::Rigid; 2];
    let mut sketches = Vec::new();
    for (line, mode) in beginnings(room.heard) {
        for (trial, prior) in trials(known, seats, &[]) {
            sketches.extend(Sketch::grown(room, &trial, line, mode, &prior));
        }
    }
    let mut judged: Vec<(f64, Place)> = finished(room, sketches, 32)
        .into_iter()
        .map(|place| (known.coil(room, place.clone(), 0.0).total, place))
        .collect();
    judged.sort_by(|a, b| b.0.total_cmp(&a.0));
    judged.into_iter().map(|(_, place)| place).collect()
}
