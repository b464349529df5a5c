//! A law laid on lines: which line is which mode, and how much better than chance that is.
//!
//! Next door: how a law's numbers are fitted (`fit`), which laws are tried (`search`), what else speaks for or against (`ends`, `decays`).

use nalgebra::DMatrix;

use super::fit::{OFF_SEARCH, evidence, fit, sum_of_logs, unheard_cost};
use super::heard::Heard;
use super::room::{HIGHEST, Room};
use super::trial::{Knob, Trial};
use crate::identify::phase_law::Law;

/// How far a line may lie off its place because no spring is exactly its model \[1\], relative: each is tried, all are as likely.
const OFF: [f64; 4] = [3e-7, 3e-6, 3e-5, 3e-4];
/// From where on that is more than noise \[1\].
const ROUGH: f64 = 1e-5;

/// A law laid.
#[derive(Debug, Clone)]
pub(super) struct Place {
    pub(super) trial: Trial,
    /// (index of what is heard, mode), the lowest mode first.
    pub(super) modes: Vec<(usize, usize)>,
    /// By how much it fits better where lines scatter by more than noise \[nats\].
    pub(super) misfit: f64,
    /// Covariance of the knobs.
    pub(super) covariance: DMatrix<f64>,
    /// Part of the variance of f1 that the lines' own noise makes \[1\]; the rest is learnt from how they scatter.
    pub(super) by_noise: f64,
    /// ln of the evidence over that of lines by chance.
    pub(super) evidence: f64,
}

impl Place {
    /// Standard uncertainty of a knob; infinite where it is none.
    pub(super) fn standard(&self, knob: Knob) -> f64 {
        let index = self.trial.knobs.iter().position(|own| *own == knob);
        index.map_or(f64::INFINITY, |index| self.covariance[(index, index)].max(0.0).sqrt())
    }

    /// Degrees of freedom of f1's uncertainty: the lines' own noise is known, and how far they scatter beyond is learnt from them
    /// (Welch and Satterthwaite).
    pub(super) fn freedom(&self) -> f64 {
        let lines = 2.0 * self.modes.len().saturating_sub(self.trial.knobs.len()).max(1) as f64;
        let learnt = (1.0 - self.by_noise).max(0.0);
        lines / (learnt * learnt).max(f64::MIN_POSITIVE)
    }

    /// Share of what is heard that its modes hold \[1\], by the amplitudes' squares.
    pub(super) fn share(&self, heard: &[Heard]) -> f64 {
        let all: f64 = heard.iter().map(|heard| heard.energy).sum();
        self.modes.iter().map(|(index, _)| heard[*index].energy).sum::<f64>() / all.max(f64::MIN_POSITIVE)
    }

    /// Whether both seats resonate under a coil without windings: one of them may stand for those.
    pub(super) fn mimics_windings(&self) -> bool {
        let Law::Coil { windings, .. } = self.trial.law else { return false };
        windings.is_infinite() && (0..2).all(|end| self.trial.knobs.contains(&Knob::Mu(end)))
    }

    /// Of a sketch.
    pub(super) fn of(room: &Room, sketch: Sketch) -> Option<Self> {
        Self::laid(room, sketch.trial, &sketch.modes)
    }

    /// Laid at once on lines near a trial's places \[1, relative\], then fitted.
    pub(super) fn near(room: &Room, trial: &Trial, within: f64) -> Option<Self> {
        let modes = near(room, trial, within);
        if modes.len() < trial.knobs.len().max(2) {
            return None;
        }
        Self::laid(room, trial.clone(), &modes)
    }

    /// Fitted to lines, laid again, and judged.
    pub(super) fn laid(room: &Room, mut trial: Trial, modes: &[(usize, usize)]) -> Option<Self> {
        let mut modes = modes.to_vec();
        for _ in 0..3 {
            let covariance = fit(room, &mut trial, &modes, OFF_SEARCH, None)?;
            let again = cut(relaid(room, &trial, &covariance));
            if again.len() < 2 {
                return None;
            }
            let again: Vec<(usize, usize)> = again.into_iter().map(|(line, mode, _)| (line, mode)).collect();
            let same = again == modes;
            modes = again;
            if same {
                break;
            }
        }
        let mut found: Option<Self> = None;
        let mut by_noise = None;
        let mut levels = Vec::new();
        let mut misfit = [f64::NEG_INFINITY; 2];
        for off in OFF {
            let mut own = trial.clone();
            let Some(covariance) = fit(room, &mut own, &modes, off, None) else { continue };
            let evidence = evidence(room, &own, &modes, off, &covariance);
            levels.push(evidence);
            let base = own.knobs.iter().position(|knob| *knob == Knob::Base).map_or(0.0, |at| covariance[(at, at)]);
            let by_noise = (*by_noise.get_or_insert(base) / base).min(1.0);
            let side = &mut misfit[usize::from(off > ROUGH)];
            *side = side.max(evidence);
            if found.as_ref().is_none_or(|best| evidence > best.evidence) {
                found = Some(Self { trial: own, modes: modes.clone(), misfit: 0.0, covariance, by_noise, evidence });
            }
        }
        let mut found = found?;
        found.misfit = misfit[1] - misfit[0];
        found.evidence = sum_of_logs(&levels) - (OFF.len() as f64).ln();
        Some(found)
    }

    /// The same coil with its ends exchanged, which frequencies do not tell.
    pub(super) fn turned_round(&self) -> Self {
        let mut other = self.clone();
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
}

/// A law laid roughly.
#[derive(Debug, Clone)]
pub(super) struct Sketch {
    pub(super) trial: Trial,
    modes: Vec<(usize, usize)>,
    /// Its evidence, roughly.
    pub(super) score: f64,
}

impl Sketch {
    /// Grown from one line taken for one mode: neighbours first, parameters fitted as they are learnt. `prior`: standard deviation of each knob.
    pub(super) fn grown(room: &Room, trial: &Trial, line: usize, mode: usize, prior: &[f64]) -> Option<Self> {
        let mut trial = trial.clone();
        trial.base = room.heard[line].frequency / trial.law.multiple(mode)?;
        let start: Vec<f64> = trial.knobs.iter().map(|knob| trial.get(*knob)).collect();
        let mut modes = vec![(line, mode)];
        let mut covariance = fit(room, &mut trial, &modes, OFF_SEARCH, Some((&start, prior)))?;
        let (mut low, mut high) = (mode, mode);
        let (mut missed_low, mut missed_high) = (0, 0);
        loop {
            let up = missed_high <= 6 && high < HIGHEST;
            let down = low > 1 && missed_low <= 20;
            // The nearer one first.
            let next = match (up, down) {
                (false, false) => break,
                (true, false) => high + 1,
                (false, true) => low - 1,
                (true, true) if high - mode <= mode - low => high + 1,
                _ => low - 1,
            };
            let upwards = next > high;
            (if upwards { &mut high } else { &mut low }).clone_from(&next);
            let missed = if upwards { &mut missed_high } else { &mut missed_low };
            let Some((place, slopes)) = trial.slopes(next) else {
                *missed = usize::MAX / 2;
                continue;
            };
            if place.exp() > 1.02 * room.top {
                *missed = usize::MAX / 2;
                continue;
            }
            let unsure = trial.variance(&slopes, &covariance).sqrt();
            match room.nearest(place, unsure.min(0.05), OFF_SEARCH, &modes, 0.5) {
                None => *missed += 1,
                Some(line) => {
                    *missed = 0;
                    modes.push((line, next));
                    if modes.len() < 8 || modes.len().is_multiple_of(4) {
                        covariance = fit(room, &mut trial, &modes, OFF_SEARCH, Some((&start, prior)))?;
                    }
                }
            }
        }
        modes.sort_by_key(|entry| entry.1);
        if modes.len() < 2 {
            return None;
        }
        let score = evidence(room, &trial, &modes, OFF_SEARCH, &covariance);
        Some(Self { trial, modes, score })
    }
}

/// Lines within a relative distance of a trial's places.
fn near(room: &Room, trial: &Trial, within: f64) -> Vec<(usize, usize)> {
    let mut modes: Vec<(usize, usize)> = Vec::new();
    for mode in 1..=HIGHEST {
        let Some(place) = trial.line(mode) else { break };
        if place.exp() > 1.02 * room.top {
            break;
        }
        if let Some(line) = room.nearest(place, 0.25 * within, 0.0, &modes, 0.0) {
            modes.push((line, mode));
        }
    }
    modes
}

/// Without the highest modes where these explain less than all those cost that are not heard below them.
fn cut(mut modes: Vec<(usize, usize, f64)>) -> Vec<(usize, usize, f64)> {
    let mut sum = 0.0;
    let mut best = (f64::NEG_INFINITY, 0);
    for (index, &(_, mode, gain)) in modes.iter().enumerate() {
        sum += gain;
        let total = sum + unheard_cost(index + 1, mode - index - 1);
        if total > best.0 {
            best = (total, index + 1);
        }
    }
    modes.truncate(best.1);
    modes
}

/// Lines that a fitted trial explains better than chance: (line, mode, by how much).
fn relaid(room: &Room, trial: &Trial, covariance: &DMatrix<f64>) -> Vec<(usize, usize, f64)> {
    let mut modes: Vec<(usize, usize, f64)> = Vec::new();
    for mode in 1..=HIGHEST {
        let Some((place, slopes)) = trial.slopes(mode) else { break };
        if place.exp() > 1.02 * room.top {
            break;
        }
        let unsure = trial.variance(&slopes, covariance).sqrt().min(0.01);
        let from = room.heard.partition_point(|heard| heard.log < place - 0.02);
        let reachable = room.heard[from..].iter().take_while(|heard| heard.log < place + 0.02);
        let variance = unsure * unsure + OFF_SEARCH * OFF_SEARCH;
        let gain = |index: usize, heard: &Heard| {
            let gain = room.gain(heard, heard.log - place, (variance + heard.spread * heard.spread).sqrt());
            let free = !modes.iter().any(|entry| entry.0 == from + index);
            (free && gain > 0.0).then_some((from + index, gain))
        };
        let best =
            reachable.enumerate().filter_map(|(index, heard)| gain(index, heard)).max_by(|a, b| a.1.total_cmp(&b.1));
        if let Some((line, gain)) = best {
            modes.push((line, mode, gain));
        }
    }
    modes
}
