//! What is no coil and has such lines: multiples of one motion, mains, strings, beams.
//!
//! Next door: the coils (`search`).

use super::beginnings::{BASES, bases};
use super::explanation::{Cause, Explanation};
use super::finalists::finished;
use super::place::{Place, Sketch};
use super::room::Room;
use super::trial::{Knob, Trial};
use crate::identify::phase_law::{Law, Support};

/// What else has such lines.
pub(super) fn of(room: &Room) -> Vec<Explanation> {
    let mut found: Vec<Explanation> = Vec::new();
    for mains in [50.0, 60.0] {
        let trial = Trial { law: Law::Mains(mains), base: mains, knobs: vec![Knob::Base] };
        let place = Place::near(room, &trial, 2e-3).filter(|place| (place.trial.base / mains).ln().abs() < 3e-3);
        found.extend(place.map(|place| Explanation::rival(room, Cause::Mains, place)));
    }
    let beams = [Support::ClampedFree, Support::ClampedClamped, Support::Hinged, Support::ClampedHinged];
    let mut causes: Vec<(Cause, Vec<Law>, &[Knob])> = vec![
        (Cause::Harmonics, vec![Law::Harmonics], &[Knob::Base]),
        (Cause::String, [1e-4, 1e-3, 1e-2].map(Law::String).to_vec(), &[Knob::Base, Knob::Bending]),
    ];
    causes.extend(beams.map(|support| (Cause::Beam(support), vec![Law::Beam(support)], &[Knob::Base][..])));
    let bases = bases(room.heard, BASES);
    for (cause, laws, knobs) in causes {
        let mut sketches = Vec::new();
        for law in laws {
            let trial = Trial { law, base: 1.0, knobs: knobs.to_vec() };
            let each = bases.iter().flat_map(|line| (1..=6).map(move |mode| (*line, mode)));
            sketches.extend(each.filter_map(|(line, mode)| Sketch::grown(room, &trial, line, mode, &[1.0, 1.0])));
        }
        let mut places = finished(room, sketches, 5);
        // A string whose bending does not show has the lines of a coil, and rings as one.
        places.retain(|place| cause != Cause::String || place.standard(Knob::Bending) < 0.5);
        found.extend(places.into_iter().map(|place| Explanation::rival(room, cause, place)));
    }
    found.sort_by(|a, b| b.total.total_cmp(&a.total));
    found
}
