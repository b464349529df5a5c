//! What explains the lines that ring: a coil on any mount, or something else, weighed on one scale.
//!
//! ```text
//! lines ─► heard ─► laws (`phase_law`) laid on them (search, place, fit) ─► + ends + decays + how likely each is ─► weighed ─► coil
//! ```
//!
//! The scale is the natural logarithm of the evidence (Laplace's integral over a law's parameters) over that of as many lines that have
//! nothing to do with one another. Next door: what is said of it (`verdict`).

mod beginnings;
mod coil;
mod decays;
mod ends;
mod explanation;
mod finalists;
mod fit;
mod giving;
mod heard;
mod known;
mod moving_end;
mod normal;
mod place;
mod resonating;
mod rivals;
mod room;
mod search;
mod trial;

use crate::identify::ModeSeries;
pub(super) use coil::Coil;
use coil::{coil_of, second};
use explanation::{Cause, Explanation};
pub(super) use heard::Heard;
pub(super) use known::Known;
use room::Room;

/// An explanation for people.
#[derive(Debug, Clone, PartialEq)]
pub struct Weight {
    /// What rings, in words.
    pub name: String,
    /// ln of its evidence over that of lines that have nothing in common \[nats\].
    pub evidence: f64,
    /// Share of the ringing's power that it explains \[1\].
    pub share: f64,
    /// f1 \[Hz\] of the coil between held ends; none of what is no coil.
    pub first_frequency: Option<f64>,
}

/// All of it.
#[derive(Debug, Clone, Default)]
pub(super) struct Weighed {
    pub(super) coil: Option<Coil>,
    /// Everything that explains more than chance, one of a name, the likeliest first.
    pub(super) ranked: Vec<Weight>,
    /// The best cause that is no coil, in words.
    pub(super) rival: String,
    /// Why nothing follows of the coil's f1, where that is so.
    pub(super) doubt: Option<String>,
}

/// Evidence by which windings that were said are believed beside a simpler coil with others \[nats\].
const SAID: f64 = 3.0;

/// Weighs what may be the cause of the lines; `top`: highest frequency at which lines are heard \[Hz\].
pub(super) fn weigh(heard: &[Heard], known: &Known, top: f64) -> Weighed {
    let mut room = Room { heard, top };
    let mut rivals = if heard.len() > 1 { rivals::of(&room) } else { Vec::new() };
    let mut coils = if heard.is_empty() { Vec::new() } else { search::coils(&room, known) };
    let mut late = search::delay(&room, known);
    let in_time: Vec<Heard> = late.map_or_else(Vec::new, |delay| heard.iter().map(|one| one.earlier(delay)).collect());
    if late.is_some() {
        // A channel that is late has to explain more than one that is not.
        let shifted = Room { heard: &in_time, top };
        let of_shifted = search::coils(&shifted, known);
        if of_shifted[0].total + ends::LATE > coils[0].total {
            (rivals, coils, room) = (rivals::of(&shifted), of_shifted, shifted);
            coils.iter_mut().for_each(|coil| coil.total += ends::LATE);
        } else {
            late = None;
        }
    }
    let heard = room.heard;
    let best_rival = rivals.first().map_or(0.0, |rival| rival.total.max(0.0));
    let rival = rivals.first().filter(|rival| rival.total > 0.0);
    let mut weighed = Weighed {
        coil: None,
        ranked: Vec::new(),
        rival: rival.map_or_else(|| "lines that have nothing in common".to_owned(), Explanation::name),
        doubt: None,
    };
    let mut other_windings = None;
    let mut unsaid = None;
    if known.windings.is_some() && heard.len() > 1 {
        // What was said of N is held against what the lines want.
        let free = Known { windings: None, mounts: known.mounts.clone(), ..*known };
        let without = search::coils(&room, &free);
        let (said, wanted) =
            (coils.first().map_or(0.0, |coil| coil.total), without.first().map_or(0.0, |coil| coil.total));
        if wanted > said.max(0.0) + 7.0 {
            other_windings = without.first().map(|coil| coil.windings());
            coils = without;
        } else {
            // A mount may stand for the windings that are there.
            let held = without.iter().find(|coil| coil.mode_series() == ModeSeries::HeldHeld);
            unsaid = held.filter(|coil| coil.total + SAID > said).map(|coil| coil.first().0);
        }
    }
    weighed.ranked = names(&room, coils.iter().chain(&rivals));
    if let Some(mut coil) = coil_of(&room, &coils) {
        coil.lead = coils[0].total - best_rival;
        coil.other_windings = other_windings;
        coil.delay = late.unwrap_or(0.0);
        second(heard, known, top, &mut coil);
        coil.disturbed();
        coil.or_held(unsaid);
        weighed.coil = Some(coil);
    }
    weighed
}

/// One of each name, the likeliest first.
fn names<'a>(room: &Room, all: impl Iterator<Item = &'a Explanation>) -> Vec<Weight> {
    let mut ranked: Vec<Weight> = Vec::new();
    for one in all {
        let weight = Weight {
            name: one.name(),
            evidence: one.total,
            share: one.place.share(room.heard),
            first_frequency: (one.cause == Cause::Coil).then_some(one.place.trial.base),
        };
        match ranked.iter_mut().find(|other| other.name == weight.name) {
            Some(other) if other.evidence < weight.evidence => *other = weight,
            Some(_) => {}
            None => ranked.push(weight),
        }
    }
    ranked.push(Weight {
        name: "lines that have nothing in common".to_owned(),
        evidence: 0.0,
        share: 1.0,
        first_frequency: None,
    });
    ranked.sort_by(|a, b| b.evidence.total_cmp(&a.evidence));
    ranked
}
