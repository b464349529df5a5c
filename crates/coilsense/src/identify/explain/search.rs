//! Which laws are tried on the lines of a record, from where.
//!
//! Next door: a law laid (`place`), what is made of all of them (the parent).

use std::f64::consts::{LN_2, PI};

use super::heard::Heard;
use super::place::{Knob, Place, Room, Sketch, Trial};
use super::{Cause, Explanation, Known, ends};
use crate::identify::phase_law::{Law, Seat, Support};

/// Lines that are taken for a mode, the strongest.
const BASES: usize = 8;
/// Highest mode that a line is taken for to begin with.
const MODES: usize = 8;
/// 1/N² to begin with, and its standard deviation.
const CHAINS: [(f64, f64); 4] = [(0.0, 6e-4), (1.1e-3, 1e-3), (6.9e-3, 5e-3), (2e-2, 1e-2)];
/// ln of how likely each mount is beside held ends, before the lines are looked at.
pub(super) const GIVES: f64 = -2.3;
const BOTH_GIVE: f64 = -4.0;
const RESONATES: f64 = -2.5;
const MOVES: f64 = -0.7;
/// The same of an end that moves where no record says that it does.
const UNSEEN_MOVES: f64 = -5.0;
/// Squares of the highest line's frequency over that of a seat's own resonance, which lies above all that is heard.
const NEAR: [f64; 1] = [0.0];
/// N from which windings are sought where the lines say nothing of them.
const USUAL_WINDINGS: f64 = 100.0;
/// Seats that are tried with windings, where no line speaks of those.
const WOUND: usize = 4;
/// Lines beyond one per knob that this takes, at least.
const SPARE: usize = 2;
/// Coils between held ends from which other mounts are sought.
const STARTS: usize = 4;

/// The strongest lines.
fn bases(heard: &[Heard], count: usize) -> Vec<usize> {
    let mut all: Vec<usize> = (0..heard.len()).collect();
    all.sort_by(|&a, &b| heard[b].energy.total_cmp(&heard[a].energy));
    all.truncate(count);
    all
}

/// Lines that may be some mode of a coil: strong and low ones any of the first, strong ones also a high one by the distance to their neighbours.
fn beginnings(heard: &[Heard]) -> Vec<(usize, usize)> {
    let strong = bases(heard, BASES);
    let mut found: Vec<(usize, usize)> =
        strong.iter().chain(&[0, 1]).flat_map(|line| (1..=MODES).map(|mode| (*line, mode))).collect();
    for &line in strong.iter().take(4) {
        for other in [line.checked_sub(2), line.checked_sub(1), Some(line + 1), Some(line + 2)].into_iter().flatten() {
            let Some(other) = heard.get(other) else { continue };
            let steps = heard[line].frequency / (heard[line].frequency - other.frequency).abs();
            let near = steps.round() as usize;
            // Modes of few windings lie the closer, the higher they are.
            found.extend([near.saturating_sub(1), near, near + 1].map(|mode| (line, mode)));
        }
    }
    found.retain(|(line, mode)| *line < heard.len() && (1..=60).contains(mode));
    found.sort_unstable();
    found.dedup();
    found
}

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
        let places = seated(room, known, &starts, Seat::Free);
        found.extend(places.into_iter().map(|place| known.coil(room, place, moves)));
    }
    if may(Mount::Mass) {
        let places = seated(room, known, &starts, Seat::Mass(1.0));
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

/// Mounts that a record may show.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Mount {
    Held,
    Gives,
    Mass,
    Free,
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

/// The best sketches, one of a kind, fitted and judged; the best first.
fn finished(room: &Room, mut sketches: Vec<Sketch>, most: usize) -> Vec<Place> {
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

/// Trials of a coil: N given, none, or free from several beginnings; each with the standard deviations of its knobs.
fn trials(known: &Known, seats: [Seat; 2], more: &[(Knob, f64)]) -> Vec<(Trial, Vec<f64>)> {
    let with = |windings: f64, chain: Option<f64>| {
        let mut knobs = vec![(Knob::Base, 1.0)];
        knobs.extend(chain.map(|prior| (Knob::Chain, prior)));
        knobs.extend(more);
        let (knobs, prior) = knobs.into_iter().unzip();
        (Trial { law: Law::Coil { windings, seats }, base: 1.0, knobs }, prior)
    };
    match known.windings {
        Some(windings) => vec![with(windings, None)],
        None => {
            std::iter::once(with(f64::INFINITY, None))
                .chain(CHAINS.map(|(chain, prior)| {
                    with(if chain > 0.0 { chain.powf(-0.5) } else { f64::INFINITY }, Some(prior))
                }))
                .collect()
        }
    }
}

/// A held coil's place with one or both ends giving.
fn giving(room: &Room, known: &Known, place: &Place) -> Vec<Explanation> {
    let mut found = Vec::new();
    let ends: &[usize] = if known.both { &[0, 1] } else { &[1] };
    let highest = place.modes.last().map_or(1, |mode| mode.1) as f64;
    // `near`: the square of the highest line's frequency over that of the seat's own resonance.
    let with = |kappas: [f64; 2], near: f64, knobs: &[Knob]| -> Option<Place> {
        let Law::Coil { windings, .. } = place.trial.law else { return None };
        let mass = |kappa: f64| near / (kappa * (PI * highest).powi(2));
        let seats = kappas.map(|kappa| if kappa > 0.0 { Seat::Gives(kappa, mass(kappa)) } else { Seat::Rigid });
        let mut trial = place.trial.clone();
        trial.law = Law::Coil { windings, seats };
        trial.base *= 1.0 + kappas[0] + kappas[1];
        trial.knobs.extend(knobs);
        Place::laid(room, trial, &place.modes)
    };
    let grid: Vec<f64> = (0..14).map(|n| 1e-4 * 1500.0_f64.powf((f64::from(n) + 0.5) / 14.0)).collect();
    // Frequencies do not tell one end from the other: each place is fitted once, and turned round.
    let share = GIVES - ((grid.len() * ends.len() * NEAR.len()) as f64).ln();
    let mut resolved: Option<(f64, [f64; 2])> = None;
    let mut best: Option<(f64, f64)> = None;
    let mut single = Vec::new();
    for (&kappa, near) in grid.iter().flat_map(|kappa| NEAR.map(|near| (kappa, near))) {
        let Some(place) = with([0.0, kappa], near, &[]) else { continue };
        for &end in ends {
            let own = if end == 1 { place.clone() } else { turned_round(&place) };
            let one = known.coil(room, own, share);
            if best.is_none_or(|(old, _)| one.total > old) {
                best = Some((one.total, kappa));
            }
            single.push(one);
        }
    }
    // Both ends alike: what shows least of all.
    let both = BOTH_GIVE - (grid.len() as f64).ln();
    found.extend(
        grid.iter().filter_map(|kappa| with([0.5 * kappa; 2], 0.0, &[])).map(|place| known.coil(room, place, both)),
    );
    let sharp = best.and_then(|(_, kappa)| with([0.0, kappa], 0.0, &[Knob::Kappa(1)]));
    if let Some(place) = sharp.filter(|place| place.standard(Knob::Kappa(1)) < 0.5) {
        for &end in ends {
            let own = if end == 1 { place.clone() } else { turned_round(&place) };
            let kappa = own.trial.get(Knob::Kappa(end)).exp();
            let one = known.coil(room, own, GIVES - (ends.len() as f64).ln());
            if resolved.is_none_or(|(old, _)| one.total > old) {
                resolved = Some((one.total, if end == 0 { [kappa, 0.0] } else { [0.0, kappa] }));
            }
            found.push(one);
        }
    } else {
        // What the lines do not resolve is summed over the grid.
        found.append(&mut single);
    }
    // Both, from where one alone fits best.
    let start = resolved.map_or([0.005; 2], |(_, kappas)| kappas.map(|kappa| (0.5 * kappa).max(2e-3)));
    let both = with(start, 0.0, &[Knob::Kappa(0), Knob::Kappa(1)]);
    let both = both.filter(|place| (0..2).all(|end| place.standard(Knob::Kappa(end)) < 0.7));
    found.extend(both.map(|place| known.coil(room, place, BOTH_GIVE)));
    found
}

/// A seat or load cell with a resonance of its own: near a line that is heard, or anywhere.
fn resonating(room: &Room, known: &Known, starts: &[&Place]) -> Vec<Explanation> {
    let near_lines = bases(room.heard, 8).into_iter().map(|line| room.heard[line].frequency);
    let resonances: Vec<f64> = near_lines
        .flat_map(|frequency| [0.97, 1.0, 1.03].map(|by| by * frequency))
        .chain((0..16).map(|number| 0.9 * room.top * 0.72_f64.powi(number)))
        .collect();
    let mut rough: Vec<(f64, Trial)> = Vec::new();
    for (base, windings, knobs) in firsts(room, starts) {
        for &resonance in &resonances {
            for kappa in [1.2e-4, 5e-4, 2e-3, 6e-3, 2e-2, 7e-2] {
                let mu = 1.0 / (kappa * (PI * resonance / base).powi(2));
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
    // A seat that the lines do not decide is none.
    let decided =
        |end: usize, place: &Place| place.standard(Knob::Kappa(end)) < 1.0 && place.standard(Knob::Mu(end)) < 1.5;
    let mut found = Vec::new();
    let mut give = |place: Place, prior: f64| {
        if known.both {
            found.push(known.coil(room, turned_round(&place), prior - LN_2));
            found.push(known.coil(room, place, prior - LN_2));
        } else {
            found.push(known.coil(room, place, prior));
        }
    };
    let mut one_end = best_of(room, rough, |place| decided(1, place));
    // A second seat mimics windings that no held coil's lines showed: those come first.
    if known.windings.is_none() {
        let plain: Vec<&Place> = one_end.iter().filter(|place| !place.trial.knobs.contains(&Knob::Chain)).collect();
        let wound = plain.iter().take(WOUND).flat_map(|place| wound(room, place));
        let wound: Vec<Place> = wound.filter(|place| decided(1, place)).collect();
        one_end.extend(wound);
    }
    one_end.sort_by(|a, b| b.evidence.total_cmp(&a.evidence));
    // The same seat under a coil whose f1 is a multiple of that, or a part.
    let mut others: Vec<Place> = Vec::new();
    for place in one_end.iter().take(3) {
        for by in [0.5, 2.0, 3.0] {
            let mut trial = place.trial.clone();
            trial.base *= by;
            trial.set(Knob::Mu(1), place.trial.get(Knob::Mu(1)) + 2.0 * f64::ln(by));
            if trial.knobs.contains(&Knob::Chain) {
                trial.set(Knob::Chain, place.trial.get(Knob::Chain) * by * by);
            }
            others.extend(Place::near(room, &trial, 0.004).filter(|place| decided(1, place)));
        }
    }
    one_end.extend(others);
    // The other end as well, where the lines leave room for it.
    for place in one_end.iter().filter(|place| place.modes.len() > 7 && place.misfit > 0.0).take(2) {
        let Law::Coil { windings, seats } = place.trial.law else { continue };
        let mut rough = Vec::new();
        for number in 0..12 {
            let resonance = 1.2 * room.top * 0.75_f64.powi(number);
            for kappa in [5e-4, 2e-3, 6e-3, 2e-2, 6e-2] {
                let base = place.trial.base * (1.0 + kappa);
                let mu = 1.0 / (kappa * (PI * resonance / base).powi(2));
                let law = Law::Coil { windings, seats: [Seat::Gives(kappa, mu.clamp(1e-3, 300.0)), seats[1]] };
                let mut knobs = place.trial.knobs.clone();
                knobs.extend([Knob::Kappa(0), Knob::Mu(0)]);
                rough.push((room.rough(&room.table(law, base), base, 0.003), Trial { law, base, knobs }));
            }
        }
        for place in best_of(room, rough, |place| decided(0, place) && decided(1, place)) {
            give(place, 2.0 * RESONATES);
        }
    }
    for place in one_end {
        give(place, RESONATES);
    }
    found
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

/// The same coil with its ends exchanged, which frequencies do not tell.
fn turned_round(place: &Place) -> Place {
    let mut other = place.clone();
    if let Law::Coil { seats, .. } = &mut other.trial.law {
        seats.swap(0, 1);
    }
    for knob in &mut other.trial.knobs {
        *knob = match *knob {
            Knob::Kappa(end) => Knob::Kappa(1 - end),
            Knob::Mu(end) => Knob::Mu(1 - end),
            other => other,
        };
    }
    other
}

/// f1 that other mounts may start from, with N and knobs: those of held coils, and what is one mode off.
fn firsts(room: &Room, starts: &[&Place]) -> Vec<(f64, f64, Vec<Knob>)> {
    let mut firsts = Vec::new();
    for place in starts {
        let Law::Coil { windings, .. } = place.trial.law else { continue };
        firsts.push((place.trial.base, windings, place.trial.knobs.clone()));
        let one_off = place.modes.first().map(|&(line, mode)| room.heard[line].frequency / (mode as f64 + 1.0));
        firsts.extend(one_off.map(|base| (base, windings, place.trial.knobs.clone())));
    }
    firsts
}

/// The places of the trials that lie best, one of a kind.
fn best_of(room: &Room, mut rough: Vec<(f64, Trial)>, good: impl Fn(&Place) -> bool) -> Vec<Place> {
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

/// Coils with a seat at end 2 that is no wall: a free end, or a mass from a seventh of the coil's to forty times that.
fn seated(room: &Room, known: &Known, starts: &[&Place], seat: Seat) -> Vec<Place> {
    if seat == Seat::Free {
        let mut sketches = Vec::new();
        for line in bases(room.heard, 6) {
            for mode in 1..=4 {
                for (trial, prior) in trials(known, [Seat::Rigid, seat], &[]).into_iter().take(3) {
                    sketches.extend(Sketch::grown(room, &trial, line, mode, &prior));
                }
            }
        }
        return finished(room, sketches, 6);
    }
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

/// What else has such lines.
pub(super) fn rivals(room: &Room) -> Vec<Explanation> {
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
