//! The coil that the lines speak for: what all explanations together say of its f1, and what it leaves of the ringing.
//!
//! Next door: the explanations (`search`), how the coil is held against what is none (the parent).

use super::explanation::{Explanation, USUAL};
use super::fit::sum_of_logs;
use super::giving::GIVES;
use super::heard::Heard;
use super::known::{Known, Mount};
use super::room::Room;
use super::{normal, rivals, search};
use crate::identify::mode_series::ModeSeries;

/// A coil between held ends is preferred to other mounts that explain no more than this better \[nats\].
const SIMPLER: f64 = 5.0;
/// Misfit of a seat's law beyond noise from which on it is not believed \[nats\].
const ROUGH: f64 = 3.0;
/// Amplitude over the largest from which on a line counts as loud \[1\].
const LOUD: f64 = 0.1;
/// ζ \[1\] above which a line is too broad for that, unless the strongest line is as broad.
const BROAD: f64 = 0.03;
/// How far f1 lies elsewhere if the lines are taken for other modes \[1\], in its logarithm.
const FAR: f64 = 0.15;
/// Share of a coil's evidence that is believed where it is held against another coil's.
const CAUTION: f64 = 0.6;
/// How far f1 may lie elsewhere before it counts as another \[1\], relative.
const ELSEWHERE: f64 = 0.01;
/// How far f1 may be off because no spring is exactly its model \[1\], relative.
const MODEL: f64 = 5e-5;
/// How far f1 may be off where none of what rings is explained \[1\], relative; else less, by the root of that share.
const DISTURBED: f64 = 5e-3;
/// Modes of a continuous coil that are thought of.
const MODES: usize = 100;
/// Evidence beyond chance that a second coil among the other lines needs \[nats\].
const SECOND: f64 = 12.0;

/// The coil that the lines speak for.
#[derive(Debug, Clone)]
pub(in crate::identify) struct Coil {
    pub(in crate::identify) mode_series: ModeSeries,
    /// N; infinite for the continuous coil.
    pub(in crate::identify) windings: f64,
    /// f1 \[Hz\] between held ends, relative standard uncertainty by noise \[1\].
    pub(in crate::identify) first: f64,
    pub(in crate::identify) spread: f64,
    /// How many of these the 95 % take: lines' own uncertainties are known, how far they scatter beyond is learnt from them.
    pub(in crate::identify) factor: f64,
    /// (line of the record, mode, frequency \[Hz\] expected), the lowest mode first.
    pub(in crate::identify) modes: Vec<(usize, usize, f64)>,
    /// ln of the evidence over the next best cause that is no coil \[nats\].
    pub(in crate::identify) lead: f64,
    /// ln of the evidence of the lines' places alone \[nats\].
    pub(in crate::identify) by_places: f64,
    /// Share of the ringing's power that it explains \[1\], a second coil included.
    pub(in crate::identify) share: f64,
    /// Share of the loud lines that it explains \[1\].
    pub(in crate::identify) loud: f64,
    /// Where f1 lies \[Hz\], 95 %, whatever the mount.
    pub(in crate::identify) range: (f64, f64),
    /// Probability that f1 is off by more than 1 %.
    pub(in crate::identify) moved: f64,
    /// Whether one force has the other's sign.
    pub(in crate::identify) turned: bool,
    /// By how much F_o is later than F_i \[s\].
    pub(in crate::identify) delay: f64,
    /// f1 \[Hz\] of a second coil among the other lines.
    pub(in crate::identify) second: Option<f64>,
    /// Lines of the record that are its modes.
    pub(in crate::identify) second_lines: Vec<usize>,
    /// N that the lines want where another was given.
    pub(in crate::identify) other_windings: Option<f64>,
}

impl Coil {
    /// Doubts f1 where a coil between held ends with other windings than were said explains as much, with another \[Hz\].
    pub(super) fn or_held(&mut self, other: Option<f64>) {
        let Some(other) = other else { return };
        if (other / self.first - 1.0).abs() > ELSEWHERE {
            self.moved = self.moved.max(0.5);
            self.range = (self.range.0.min(other), self.range.1.max(other));
        }
    }

    /// The mode whose place \[Hz\] is within a relative distance of a frequency \[Hz\].
    pub(in crate::identify) fn nearest(&self, frequency: f64, within: f64) -> Option<(usize, f64)> {
        let most = if self.windings.is_finite() { self.windings as usize } else { MODES };
        let places = (1..=most).map(|mode| (mode, self.first * self.mode_series.multiple(mode, self.windings)));
        places
            .min_by(|a, b| (a.1 - frequency).abs().total_cmp(&(b.1 - frequency).abs()))
            .filter(|(_, place)| (place - frequency).abs() <= within * frequency)
    }

    /// f1's range with what the rest of the ringing may do to it.
    pub(super) fn disturbed(&mut self) {
        let off = DISTURBED * (1.0 - self.share).max(0.0).sqrt() * self.first;
        let (low, high) = self.range;
        self.range = (self.first - (self.first - low).hypot(off), self.first + (high - self.first).hypot(off));
    }
}

/// The simplest coil that comes near the best, with what all others say of its f1.
pub(super) fn coil_of(room: &Room, coils: &[Explanation]) -> Option<Coil> {
    let best = coils.first()?;
    let plain = |one: &&Explanation| one.mode_series() == ModeSeries::HeldHeld;
    let simplest = coils.iter().find(plain).filter(|held| {
        held.total > best.total - SIMPLER
            && (held.place.trial.base / best.place.trial.base).ln().abs() < 0.2
            && held.place.modes.len() + 2 >= best.place.modes.len()
    });
    let chosen = simplest.unwrap_or(best);
    let (first, spread) = chosen.first();
    let factor = crate::uncertainty::coverage_factor(0.95, chosen.place.freedom()).unwrap_or(1.96);
    let all = sum_of_logs(&coils.iter().map(|one| one.total).collect::<Vec<_>>());
    // A seat whose law misses its lines by more than noise is not the seat that is there.
    let gives = matches!(chosen.mode_series(), ModeSeries::Gives { .. });
    let doubtful = gives && (chosen.place.misfit > ROUGH || chosen.place.mimics_windings());
    let moved = moved(coils, first);
    let moved = if doubtful { moved.max(0.5) } else { moved };
    let expanded = (factor * spread).hypot(MODEL);
    // All that the seat does to f1 is in the interval then.
    let expanded = if doubtful { expanded.hypot(USUAL * chosen.gives().unwrap_or(1.0).max(1.0)) } else { expanded };
    Some(Coil {
        mode_series: chosen.mode_series(),
        windings: chosen.windings(),
        first,
        spread,
        factor,
        modes: chosen
            .place
            .modes
            .iter()
            .filter_map(|&(line, mode)| {
                let expected = first * chosen.place.trial.law.multiple(mode)?;
                Some((room.heard[line].line, mode, expected))
            })
            .collect(),
        lead: 0.0,
        by_places: chosen.place.evidence,
        share: chosen.place.share(room.heard),
        loud: loud(room.heard, |index| chosen.place.modes.iter().any(|(line, _)| *line == index)),
        // For the range, mounts that give are taken for as likely as those that do not, and by any amount alike.
        range: range(coils, first, expanded, |one| {
            let own = if one.gives().is_some() { one.prior.max(GIVES) } else { one.prior };
            one.gives().unwrap_or(1.0) * (one.total - own - all).exp()
        }),
        moved,
        turned: chosen.told.turned,
        delay: 0.0,
        second: None,
        second_lines: Vec::new(),
        other_windings: None,
    })
}

/// Probability that f1 is elsewhere by more than 1 %.
fn moved(coils: &[Explanation], first: f64) -> f64 {
    let off = |one: &Explanation| (one.first().0 / first - 1.0).abs() > ELSEWHERE;
    let far = |one: &Explanation| (one.first().0 / first).ln().abs() > FAR;
    // No mount is exactly its model: what its evidence says of a mount nearby is believed by a part only.
    let logs = |which: &dyn Fn(&Explanation) -> bool, share: f64| {
        let each = coils.iter().filter(|one| which(one)).map(|one| one.prior + share * (one.total - one.prior));
        sum_of_logs(&each.collect::<Vec<_>>())
    };
    let odds = |nats: f64| nats.exp() / (1.0 + nats.exp());
    let nearby = odds(logs(&|one| off(one) && !far(one), CAUTION) - logs(&|one| !off(one), CAUTION));
    nearby + odds(logs(&far, 1.0) - logs(&|one| !far(one), 1.0))
}

/// Share of the lines whose amplitude is at least a tenth of the largest that are explained \[1\].
fn loud(heard: &[Heard], explained: impl Fn(usize) -> bool) -> f64 {
    let Some(strongest) = heard.iter().max_by(|a, b| a.energy.total_cmp(&b.energy)) else { return 1.0 };
    // What dies out at once says little of its amplitude.
    let broad = BROAD.max(3.0 * strongest.ratio());
    let sure = |index: &usize| heard[*index].ratio() < broad;
    let largest = (0..heard.len()).filter(sure).map(|index| heard[index].loudness).fold(0.0, f64::max);
    let is_loud = |index: &usize| heard[*index].loudness >= LOUD * LOUD * largest;
    let loud: Vec<usize> = (0..heard.len()).filter(sure).filter(is_loud).collect();
    loud.iter().filter(|index| explained(**index)).count() as f64 / loud.len().max(1) as f64
}

/// Where f1 lies with 95 %: quantiles of all explanations, each normal about its own.
fn range(coils: &[Explanation], first: f64, expanded: f64, weight: impl Fn(&Explanation) -> f64) -> (f64, f64) {
    let mut parts: Vec<(f64, f64, f64)> = Vec::new();
    for one in coils {
        let (own, of) = one.first();
        // Another series altogether is told otherwise.
        if (own / first).ln().abs() < 0.25 {
            parts.push((own.ln(), of.hypot(1e-12), weight(one)));
        }
    }
    let total: f64 = parts.iter().map(|part| part.2).sum();
    let below = |at: f64| parts.iter().map(|part| part.2 * normal::below((at - part.0) / part.1)).sum::<f64>() / total;
    let quantile = |share: f64| {
        let (mut low, mut high) = (first.ln() - 0.4, first.ln() + 0.4);
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            if below(middle) < share { low = middle } else { high = middle }
        }
        (0.5 * (low + high)).exp()
    };
    let (low, high) = (quantile(0.025), quantile(0.975));
    (low.min(first * (1.0 - expanded)), high.max(first * (1.0 + expanded)))
}

/// A second coil among the lines that the first leaves.
pub(super) fn second(heard: &[Heard], known: &Known, top: f64, coil: &mut Coil) {
    let rest: Vec<Heard> =
        heard.iter().filter(|one| !coil.modes.iter().any(|(line, _, _)| *line == one.line)).cloned().collect();
    if rest.len() < 3 {
        return;
    }
    let room = Room { heard: &rest, top };
    let plain = Known { mounts: vec![Mount::Held], windings: None, ..*known };
    let others = search::coils(&room, &plain);
    let rival = rivals::of(&room).first().map_or(0.0, |rival| rival.total.max(0.0));
    if let Some(other) = others.first().filter(|other| other.total > SECOND + rival) {
        coil.second = Some(other.place.trial.base);
        coil.second_lines = other.place.modes.iter().map(|(line, _)| rest[*line].line).collect();
        let own: f64 = other.place.modes.iter().map(|(line, _)| rest[*line].energy).sum();
        let of_second = |index: usize| other.place.modes.iter().any(|(line, _)| rest[*line].line == heard[index].line);
        let of_first = |index: usize| coil.modes.iter().any(|(line, _, _)| *line == heard[index].line);
        coil.loud = loud(heard, |index| of_first(index) || of_second(index));
        coil.share += own / heard.iter().map(|one| one.energy).sum::<f64>();
    }
}
