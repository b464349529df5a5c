//! A held coil's ends that give, by amounts that the lines resolve or do not.
//!
//! Next door: seats with a resonance of their own (`resonating`), ends that move (`moving_end`).

use super::explanation::Explanation;
use super::known::Known;
use super::place::Place;
use super::room::Room;
use super::trial::Knob;
use crate::identify::phase_law::{Law, Seat};

/// ln of how likely a mount with one end that gives is beside held ends, before the lines are looked at.
pub(super) const GIVES: f64 = -2.3;
/// The same where both give.
const BOTH_GIVE: f64 = -4.0;
/// Amounts by which ends are let give, where the lines do not resolve these.
const AMOUNTS: usize = 14;

/// A held coil whose ends are let give.
struct Giving<'a> {
    room: &'a Room<'a>,
    known: &'a Known,
    held: &'a Place,
}

/// A held coil's place with one or both ends giving.
pub(super) fn giving(room: &Room, known: &Known, held: &Place) -> Vec<Explanation> {
    let mount = Giving { room, known, held };
    // Both ends alike: what shows least of all.
    let prior = BOTH_GIVE - (AMOUNTS as f64).ln();
    let alike = amounts().filter_map(|kappa| mount.with([0.5 * kappa; 2], &[]));
    let mut found: Vec<Explanation> = alike.map(|place| known.coil(room, place, prior)).collect();
    let unresolved = mount.unresolved();
    let resolved = likeliest(&unresolved).map_or_else(Vec::new, |kappa| mount.resolved(kappa));
    // Both, from where one alone fits best.
    let start = likeliest(&resolved).map_or([0.005; 2], |kappas| kappas.map(|kappa| (0.5 * kappa).max(2e-3)));
    if resolved.is_empty() {
        // What the lines do not resolve is summed over the amounts.
        found.extend(unresolved.into_iter().map(|(_, one)| one));
    } else {
        found.extend(resolved.into_iter().map(|(_, one)| one));
    }
    let both = mount.with(start, &[Knob::Kappa(0), Knob::Kappa(1)]);
    let both = both.filter(|place| (0..2).all(|end| place.standard(Knob::Kappa(end)) < 0.7));
    found.extend(both.map(|place| known.coil(room, place, BOTH_GIVE)));
    found
}

/// κ that are tried.
fn amounts() -> impl Iterator<Item = f64> {
    (0..AMOUNTS).map(|n| 1e-4 * 1500.0_f64.powf((n as f64 + 0.5) / AMOUNTS as f64))
}

/// What stands beside the likeliest explanation, the first of them.
fn likeliest<T: Copy>(all: &[(T, Explanation)]) -> Option<T> {
    let mut best: Option<&(T, Explanation)> = None;
    for one in all {
        if best.is_none_or(|old| one.1.total > old.1.total) {
            best = Some(one);
        }
    }
    best.map(|one| one.0)
}

impl Giving<'_> {
    /// Ends that may give alone.
    fn ends(&self) -> &'static [usize] {
        if self.known.both { &[0, 1] } else { &[1] }
    }

    /// The coil laid again on seats of these compliances, with more knobs.
    fn with(&self, kappas: [f64; 2], knobs: &[Knob]) -> Option<Place> {
        let Law::Coil { windings, .. } = self.held.trial.law else { return None };
        let seats = kappas.map(|kappa| if kappa > 0.0 { Seat::Gives(kappa, 0.0) } else { Seat::Rigid });
        let mut trial = self.held.trial.clone();
        trial.law = Law::Coil { windings, seats };
        trial.base *= 1.0 + kappas[0] + kappas[1];
        trial.knobs.extend(knobs);
        Place::laid(self.room, trial, &self.held.modes)
    }

    /// A place whose end 2 gives, and where that may be end 1, the same turned round: frequencies do not tell one end from the other.
    fn either_end(&self, place: &Place, prior: f64) -> impl Iterator<Item = (usize, Explanation)> {
        self.ends().iter().map(move |&end| {
            let own = if end == 1 { place.clone() } else { place.turned_round() };
            (end, self.known.coil(self.room, own, prior))
        })
    }

    /// One end that gives by each amount: (κ, what it explains).
    fn unresolved(&self) -> Vec<(f64, Explanation)> {
        let share = GIVES - ((AMOUNTS * self.ends().len()) as f64).ln();
        let mut found = Vec::new();
        for kappa in amounts() {
            let Some(place) = self.with([0.0, kappa], &[]) else { continue };
            found.extend(self.either_end(&place, share).map(|(_, one)| (kappa, one)));
        }
        found
    }

    /// One end that gives by the amount that fits best, where the lines resolve that: (κ of both, what it explains).
    fn resolved(&self, start: f64) -> Vec<([f64; 2], Explanation)> {
        let sharp = self.with([0.0, start], &[Knob::Kappa(1)]);
        let Some(place) = sharp.filter(|place| place.standard(Knob::Kappa(1)) < 0.5) else { return Vec::new() };
        let each = self.either_end(&place, GIVES - (self.ends().len() as f64).ln()).map(|(end, one)| {
            let kappa = one.place.trial.get(Knob::Kappa(end)).exp();
            (if end == 0 { [kappa, 0.0] } else { [0.0, kappa] }, one)
        });
        each.collect()
    }
}
