//! Where a search for a coil begins: which lines may be which modes, windings, and the f1 that other mounts start from.
//!
//! Next door: what is sought from there (`search`, `giving`, `resonating`, `moving_end`).

use super::heard::Heard;
use super::known::Known;
use super::place::Place;
use super::room::Room;
use super::trial::{Knob, Trial};
use crate::identify::phase_law::{Law, Seat};

/// Lines that are taken for a mode, the strongest.
pub(super) const BASES: usize = 8;
/// Highest mode that a line is taken for to begin with.
const MODES: usize = 8;
/// 1/N² to begin with, and its standard deviation.
const CHAINS: [(f64, f64); 4] = [(0.0, 6e-4), (1.1e-3, 1e-3), (6.9e-3, 5e-3), (2e-2, 1e-2)];
/// N from which windings are sought where the lines say nothing of them.
pub(super) const USUAL_WINDINGS: f64 = 100.0;

/// The strongest lines.
pub(super) fn bases(heard: &[Heard], count: usize) -> Vec<usize> {
    let mut all: Vec<usize> = (0..heard.len()).collect();
    all.sort_by(|&a, &b| heard[b].energy.total_cmp(&heard[a].energy));
    all.truncate(count);
    all
}

/// Lines that may be some mode of a coil: strong and low ones any of the first, strong ones also a high one by the distance to their neighbours.
pub(super) fn beginnings(heard: &[Heard]) -> Vec<(usize, usize)> {
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

/// Trials of a coil: N given, none, or free from several beginnings; each with the standard deviations of its knobs.
pub(super) fn trials(known: &Known, seats: [Seat; 2], more: &[(Knob, f64)]) -> Vec<(Trial, Vec<f64>)> {
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

/// f1 that other mounts may start from, with N and knobs: those of held coils, and what is one mode off.
pub(super) fn firsts(room: &Room, starts: &[&Place]) -> Vec<(f64, f64, Vec<Knob>)> {
    let mut firsts = Vec::new();
    for place in starts {
        let Law::Coil { windings, .. } = place.trial.law else { continue };
        firsts.push((place.trial.base, windings, place.trial.knobs.clone()));
        let one_off = place.modes.first().map(|&(line, mode)| room.heard[line].frequency / (mode as f64 + 1.0));
        firsts.extend(one_off.map(|base| (base, windings, place.trial.knobs.clone())));
    }
    firsts
}
