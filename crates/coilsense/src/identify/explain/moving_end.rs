//! Coils whose end 2 moves: a free end, or one with a mass.
//!
//! Next door: ends behind seats (`giving`, `resonating`).

use super::beginnings::{USUAL_WINDINGS, bases, firsts, trials};
use super::finalists::{best_of, finished};
use super::known::Known;
use super::place::{Place, Sketch};
use super::room::Room;
use super::trial::{Knob, Trial};
use crate::identify::phase_law::{Law, Seat};

/// With a free end.
pub(super) fn free(room: &Room, known: &Known) -> Vec<Place> {
    let mut sketches = Vec::new();
    for line in bases(room.heard, 6) {
        for mode in 1..=4 {
            for (trial, prior) in trials(known, [Seat::Rigid, Seat::Free], &[]).into_iter().take(3) {
                sketches.extend(Sketch::grown(room, &trial, line, mode, &prior));
            }
        }
    }
    finished(room, sketches, 6)
}

/// With a mass from a tenth of the coil's to forty times the coil's.
pub(super) fn with_mass(room: &Room, known: &Known, starts: &[&Place]) -> Vec<Place> {
    let mut firsts = firsts(room, starts);
    // Where a heavy mass swings, the lowest line lies far below the others.
    let knobs = if known.windings.is_some() { vec![Knob::Base] } else { vec![Knob::Base, Knob::Chain] };
    for line in bases(room.heard, 6) {
        let windings = known.windings.unwrap_or(USUAL_WINDINGS);
        firsts.extend((1..=4).map(|mode| (room.heard[line].frequency / f64::from(mode), windings, knobs.clone())));
    }
    let lowest = firsts.iter().map(|first| 0.94 * first.0).fold(f64::INFINITY, f64::min);
    let mut rough = Vec::new();
    for number in 0..24 {
        let mu = 0.1 * 1.3_f64.powi(number);
        let mut table: Option<(f64, Vec<f64>)> = None;
        for (base, windings, knobs) in &firsts {
            let law = Law::Coil { windings: *windings, seats: [Seat::Rigid, Seat::Mass(mu)] };
            if table.as_ref().is_none_or(|known| known.0 != *windings) {
                table = Some((*windings, room.table(law, lowest)));
            }
            let Some((_, table)) = &table else { continue };
            for by in 0..9 {
                let base = base * (0.94 + 0.01 * f64::from(by));
                let mut knobs = knobs.clone();
                knobs.push(Knob::Mu(1));
                rough.push((room.rough(table, base, 0.004), Trial { law, base, knobs }));
            }
        }
    }
    best_of(room, rough, |place| place.standard(Knob::Mu(1)) < 1.0)
}
