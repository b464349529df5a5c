//! Of many laws laid roughly, those that lie best, one of a kind, fitted.
//!
//! Next door: where they come from (`beginnings`), a law laid (`place`).

use super::place::{Place, Sketch};
use super::room::Room;
use super::trial::Trial;

/// The best sketches, one of a kind, fitted and judged; the best first.
pub(super) fn finished(room: &Room, mut sketches: Vec<Sketch>, most: usize) -> Vec<Place> {
    sketches.sort_by(|a, b| b.score.total_cmp(&a.score));
    let mut kept: Vec<Sketch> = Vec::new();
    for sketch in sketches {
        let same = |other: &Sketch| {
            (other.trial.base / sketch.trial.base).ln().abs() < 1e-4 && other.trial.knobs == sketch.trial.knobs
        };
        if kept.len() < most && !kept.iter().any(same) {
            kept.push(sketch);
        }
    }
    let mut places: Vec<Place> = kept.into_iter().filter_map(|sketch| Place::of(room, sketch)).collect();
    places.sort_by(|a, b| b.evidence.total_cmp(&a.evidence));
    // Two sketches may have been fitted to one place.
    let mut found: Vec<Place> = Vec::new();
    for place in places {
        let same = |other: &Place| {
            (other.trial.base / place.trial.base).ln().abs() < 1e-6 && other.trial.knobs == place.trial.knobs
        };
        if !found.iter().any(same) {
            found.push(place);
        }
    }
    found
}

/// The places of the trials that lie best, one of a kind.
pub(super) fn best_of(room: &Room, mut rough: Vec<(f64, Trial)>, good: impl Fn(&Place) -> bool) -> Vec<Place> {
    rough.sort_by(|a, b| b.0.total_cmp(&a.0));
    let mut found: Vec<Place> = Vec::new();
    for (_, trial) in rough.into_iter().take(24) {
        let Some(place) = Place::near(room, &trial, 0.01).filter(|place| good(place)) else { continue };
        match found.iter_mut().find(|other| (other.trial.base / place.trial.base).ln().abs() < 3e-3) {
            Some(other) if other.evidence < place.evidence => *other = place,
            Some(_) => {}
            None => found.push(place),
        }
    }
    found
}
