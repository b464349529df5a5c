//! Seats and load cells with a resonance of their own, at one end or at both.
//!
//! Next door: seats that only give (`giving`), ends that move (`moving_end`).

use std::f64::consts::{LN_2, PI};

use super::beginnings::{USUAL_WINDINGS, bases, firsts};
use super::explanation::Explanation;
use super::finalists::best_of;
use super::known::Known;
use super::place::Place;
use super::room::Room;
use super::trial::{Knob, Trial};
use crate::identify::phase_law::{Law, Seat};

/// ln of how likely each seat that resonates is beside held ends, before the lines are looked at.
const RESONATES: f64 = -2.5;
/// Seats that are tried with windings, where no line speaks of those.
const WOUND: usize = 4;
/// Lines beyond one per knob that this takes, at least.
const SPARE: usize = 2;

/// A seat or load cell with a resonance of its own: near a line that is heard, or anywhere.
pub(super) fn resonating(room: &Room, known: &Known, starts: &[&Place]) -> Vec<Explanation> {
    let mut one_end = best_of(room, at_end_2(room, starts), |place| decided(1, place));
    // A second seat mimics windings that no held coil's lines showed: those come first.
    if known.windings.is_none() {
        let plain: Vec<&Place> = one_end.iter().filter(|place| !place.trial.knobs.contains(&Knob::Chain)).collect();
        let wound = plain.iter().take(WOUND).flat_map(|place| wound(room, place));
        let wound: Vec<Place> = wound.filter(|place| decided(1, place)).collect();
        one_end.extend(wound);
    }
    one_end.sort_by(|a, b| b.evidence.total_cmp(&a.evidence));
    let others: Vec<Place> = one_end.iter().take(3).flat_map(|place| multiples(room, place)).collect();
    one_end.extend(others);
    // The other end as well, where the lines leave room for it.
    let roomy = one_end.iter().filter(|place| place.modes.len() > 7 && place.misfit > 0.0).take(2);
    let both: Vec<Place> = roomy.flat_map(|place| at_both(room, place)).collect();
    let all = both.into_iter().map(|place| (place, 2.0 * RESONATES));
    let all = all.chain(one_end.into_iter().map(|place| (place, RESONATES)));
    all.flat_map(|(place, prior)| either_way(room, known, place, prior)).collect()
}

/// Whether the lines decide an end's seat: one that they do not is none.
fn decided(end: usize, place: &Place) -> bool {
    place.standard(Knob::Kappa(end)) < 1.0 && place.standard(Knob::Mu(end)) < 1.5
}

/// A place, where both forces were recorded also turned round.
fn either_way(room: &Room, known: &Known, place: Place, prior: f64) -> Vec<Explanation> {
    if known.both {
        vec![known.coil(room, place.turned_round(), prior - LN_2), known.coil(room, place, prior - LN_2)]
    } else {
        vec![known.coil(room, place, prior)]
    }
}

/// μ of a seat of compliance κ that resonates at a frequency \[Hz\] under a coil of f1 `base`.
fn mass(kappa: f64, resonance: f64, base: f64) -> f64 {
    1.0 / (kappa * (PI * resonance / base).powi(2))
}

/// Coils with one such seat, with how well each lies.
fn at_end_2(room: &Room, starts: &[&Place]) -> Vec<(f64, Trial)> {
    let near_lines = bases(room.heard, 8).into_iter().map(|line| room.heard[line].frequency);
    let resonances: Vec<f64> = near_lines
        .flat_map(|frequency| [0.97, 1.0, 1.03].map(|by| by * frequency))
        .chain((0..16).map(|number| 0.9 * room.top * 0.72_f64.powi(number)))
        .collect();
    let mut rough: Vec<(f64, Trial)> = Vec::new();
    for (base, windings, knobs) in firsts(room, starts) {
        for &resonance in &resonances {
            for kappa in [1.2e-4, 5e-4, 2e-3, 6e-3, 2e-2, 7e-2] {
                let mu = mass(kappa, resonance, base);
                if !(1e-3..300.0).contains(&mu) {
                    continue;
                }
                let law = Law::Coil { windings, seats: [Seat::Rigid, Seat::Gives(kappa, mu)] };
                let mut knobs = knobs.clone();
                knobs.extend([Knob::Kappa(1), Knob::Mu(1)]);
                rough.push((room.rough(&room.table(law, base), base, 0.003), Trial { law, base, knobs }));
            }
        }
    }
    rough
}

/// The same seat under a coil whose f1 is a multiple of that, or a part.
fn multiples(room: &Room, place: &Place) -> Vec<Place> {
    let near = |by: f64| {
        let mut trial = place.trial.clone();
        trial.base *= by;
        trial.set(Knob::Mu(1), place.trial.get(Knob::Mu(1)) + 2.0 * f64::ln(by));
        if trial.knobs.contains(&Knob::Chain) {
            trial.set(Knob::Chain, place.trial.get(Knob::Chain) * by * by);
        }
        Place::near(room, &trial, 0.004).filter(|place| decided(1, place))
    };
    [0.5, 2.0, 3.0].into_iter().filter_map(near).collect()
}

/// Places with a second such seat at the other end.
fn at_both(room: &Room, place: &Place) -> Vec<Place> {
    let Law::Coil { windings, seats } = place.trial.law else { return Vec::new() };
    let mut rough = Vec::new();
    for number in 0..12 {
        let resonance = 1.2 * room.top * 0.75_f64.powi(number);
        for kappa in [5e-4, 2e-3, 6e-3, 2e-2, 6e-2] {
            let base = place.trial.base * (1.0 + kappa);
            let mu = mass(kappa, resonance, base);
            let law = Law::Coil { windings, seats: [Seat::Gives(kappa, mu.clamp(1e-3, 300.0)), seats[1]] };
            let mut knobs = place.trial.knobs.clone();
            knobs.extend([Knob::Kappa(0), Knob::Mu(0)]);
            rough.push((room.rough(&room.table(law, base), base, 0.003), Trial { law, base, knobs }));
        }
    }
    best_of(room, rough, |place| decided(0, place) && decided(1, place))
}

/// The same seat under a coil of windings.
fn wound<'a>(room: &'a Room, place: &'a Place) -> impl Iterator<Item = Place> + 'a {
    [200.0, USUAL_WINDINGS, 60.0, 35.0].into_iter().filter_map(|windings| {
        let Law::Coil { seats, .. } = place.trial.law else { return None };
        let mut trial = place.trial.clone();
        trial.law = Law::Coil { windings, seats };
        trial.knobs.insert(1, Knob::Chain);
        // Few lines fit anything.
        Place::near(room, &trial, 0.004).filter(|place| place.modes.len() > place.trial.knobs.len() + SPARE)
    })
}
