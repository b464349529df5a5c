//! What explains the lines that ring: a coil on any mount, or something else, weighed on one scale.
//!
//! ```text
//! lines ─► heard ─► laws (`phase_law`) laid on them (search, place) ─► + ends + decays + how likely each is ─► weighed
//! ```
//!
//! The scale is the natural logarithm of the evidence (Laplace's integral over a law's parameters) over that of as many lines that have
//! nothing to do with one another. Next door: what is said of it (`verdict`).

mod decays;
mod ends;
mod heard;
mod place;
mod search;

use super::mode_series::ModeSeries;
use super::phase_law::{Law, Seat, Support};
use super::settings::Settings;
use crate::mount::FarEnd;
use ends::Told;
pub(super) use heard::Heard;
use place::{Knob, Place, Room, sum_of_logs};
use search::Mount;

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
/// Compliance of a seat over the coil's that is as likely by its amount as by its logarithm \[1\].
const USUAL: f64 = 0.01;
/// Evidence beyond chance that a second coil among the other lines needs \[nats\].
const SECOND: f64 = 12.0;

/// What may be the cause of lines.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Cause {
    /// A coil; what its mount is stands in the place.
    Coil,
    Harmonics,
    Mains,
    String,
    Beam(Support),
}

/// One explanation.
#[derive(Debug, Clone)]
struct Explanation {
    cause: Cause,
    place: Place,
    told: Told,
    /// ln of evidence and prior \[nats\].
    total: f64,
    /// ln of how likely its mount is beforehand \[nats\].
    prior: f64,
}

impl Explanation {
    fn rival(room: &Room, cause: Cause, place: Place) -> Self {
        let total = place.evidence + ends::of_rival(&place, room.heard) + decays::of(&place, room.heard) - 1.6;
        Self { cause, place, told: Told { evidence: 0.0, turned: false }, total, prior: 0.0 }
    }

    /// f1 \[Hz\] of the coil between held ends, and its relative standard uncertainty \[1\].
    fn first(&self) -> (f64, f64) {
        (self.place.trial.base, self.place.standard(Knob::Base))
    }

    /// Compliance of both seats over \[1\] what makes a mount that gives as likely by its amount as by the amount's logarithm; none where
    /// nothing gives.
    fn gives(&self) -> Option<f64> {
        let Law::Coil { seats, .. } = self.place.trial.law else { return None };
        let each = seats.iter().filter_map(|seat| match seat {
            Seat::Gives(kappa, _) => Some(kappa),
            _ => None,
        });
        each.copied().reduce(|one, other| one + other).map(|kappa| kappa / USUAL)
    }

    /// In words.
    fn name(&self) -> String {
        match self.cause {
            Cause::Coil => series_of(&self.place).name().to_owned(),
            Cause::Harmonics => "multiples of one motion".to_owned(),
            Cause::Mains => "multiples of the mains' frequency".to_owned(),
            Cause::String => "a string or belt".to_owned(),
            Cause::Beam(support) => support.name().to_owned(),
        }
    }
}

/// What is known of a record beside its lines.
pub(super) struct Known {
    windings: Option<f64>,
    /// Whether both forces were recorded.
    both: bool,
    /// Whether end 2 was seen to move.
    end_moves: bool,
    /// Whether one force is known to have the other's sign, or not to.
    turned: Option<bool>,
    mounts: Vec<Mount>,
}

impl Known {
    /// `end_moves`: whether end 2 rings along; none where its position was not recorded.
    pub(super) fn of(settings: &Settings, both: bool, end_moves: Option<bool>, turned: Option<bool>) -> Self {
        let mounts = match (settings.far_end, end_moves) {
            (Some(FarEnd::Position), _) => vec![Mount::Held],
            (Some(FarEnd::Force), _) => vec![Mount::Free],
            (Some(FarEnd::Mass(_)), _) => vec![Mount::Mass],
            (None, Some(false)) => vec![Mount::Held, Mount::Gives],
            (None, Some(true)) => vec![Mount::Held, Mount::Gives, Mount::Mass, Mount::Free],
            (None, None) => vec![Mount::Held, Mount::Gives, Mount::Mass],
        };
        Self { windings: settings.windings, both, end_moves: end_moves == Some(true), turned, mounts }
    }

    fn coil(&self, room: &Room, place: Place, prior: f64) -> Explanation {
        let told = ends::of_coil(&place, room.heard, self.turned);
        let total = place.evidence + told.evidence + decays::of(&place, room.heard) + prior;
        Explanation { cause: Cause::Coil, place, told, total, prior }
    }
}

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

/// The coil that the lines speak for.
#[derive(Debug, Clone)]
pub(super) struct Coil {
    pub(super) mode_series: ModeSeries,
    /// N; infinite for the continuous coil.
    pub(super) windings: f64,
    /// f1 \[Hz\] between held ends, relative standard uncertainty by noise \[1\].
    pub(super) first: f64,
    pub(super) spread: f64,
    /// How many of these the 95 % take: lines' own uncertainties are known, how far they scatter beyond is learnt from them.
    pub(super) factor: f64,
    /// (line of the record, mode, frequency \[Hz\] expected), the lowest mode first.
    pub(super) modes: Vec<(usize, usize, f64)>,
    /// ln of the evidence over the next best cause that is no coil \[nats\].
    pub(super) lead: f64,
    /// ln of the evidence of the lines' places alone \[nats\].
    pub(super) by_places: f64,
    /// Share of the ringing's power that it explains \[1\], a second coil included.
    pub(super) share: f64,
    /// Share of the loud lines that it explains \[1\].
    pub(super) loud: f64,
    /// Where f1 lies \[Hz\], 95 %, whatever the mount.
    pub(super) range: (f64, f64),
    /// Probability that f1 is off by more than 1 %.
    pub(super) moved: f64,
    /// Whether one force has the other's sign.
    pub(super) turned: bool,
    /// By how much F_o is later than F_i \[s\].
    pub(super) delay: f64,
    /// f1 \[Hz\] of a second coil among the other lines.
    pub(super) second: Option<f64>,
    /// N that the lines want where another was given.
    pub(super) other_windings: Option<f64>,
}

impl Coil {
    /// f1's range with what the rest of the ringing may do to it.
    fn disturbed(&mut self) {
        let off = DISTURBED * (1.0 - self.share).max(0.0).sqrt() * self.first;
        let (low, high) = self.range;
        self.range = (self.first - (self.first - low).hypot(off), self.first + (high - self.first).hypot(off));
    }
}

/// All of it.
#[derive(Debug, Clone, Default)]
pub(super) struct Weighed {
    pub(super) coil: Option<Coil>,
    /// Everything that explains more than chance, one of a name, the likeliest first.
    pub(super) ranked: Vec<Weight>,
    /// The best cause that is no coil, in words.
    pub(super) rival: String,
}

/// Weighs what may be the cause of the lines; `top`: highest frequency at which lines are heard \[Hz\].
pub(super) fn weigh(heard: &[Heard], known: &Known, top: f64) -> Weighed {
    let mut room = Room { heard, top };
    let mut rivals = if heard.len() > 1 { search::rivals(&room) } else { Vec::new() };
    let mut coils = if heard.is_empty() { Vec::new() } else { search::coils(&room, known) };
    let mut late = search::delay(&room, known);
    let in_time: Vec<Heard> = late.map_or_else(Vec::new, |delay| heard.iter().map(|one| one.earlier(delay)).collect());
    if late.is_some() {
        // A channel that is late has to explain more than one that is not.
        let shifted = Room { heard: &in_time, top };
        let of_shifted = search::coils(&shifted, known);
        if of_shifted[0].total + ends::LATE > coils[0].total {
            (rivals, coils, room) = (search::rivals(&shifted), of_shifted, shifted);
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
    };
    let mut other_windings = None;
    if known.windings.is_some() && heard.len() > 1 {
        // What was said of N is held against what the lines want.
        let free = Known { windings: None, mounts: known.mounts.clone(), ..*known };
        let without = search::coils(&room, &free);
        let (said, wanted) =
            (coils.first().map_or(0.0, |coil| coil.total), without.first().map_or(0.0, |coil| coil.total));
        if wanted > said.max(0.0) + 7.0 {
            other_windings = without.first().map(|coil| windings_of(&coil.place));
            coils = without;
        }
    }
    weighed.ranked = names(&room, coils.iter().chain(&rivals));
    if let Some(mut coil) = coil_of(&room, &coils) {
        coil.lead = coils[0].total - best_rival;
        coil.other_windings = other_windings;
        coil.delay = late.unwrap_or(0.0);
        second(heard, known, top, &mut coil);
        coil.disturbed();
        weighed.coil = Some(coil);
    }
    weighed
}

fn windings_of(place: &Place) -> f64 {
    match place.trial.law {
        Law::Coil { windings, .. } => windings,
        _ => f64::INFINITY,
    }
}

/// The simplest coil that comes near the best, with what all others say of its f1.
fn coil_of(room: &Room, coils: &[Explanation]) -> Option<Coil> {
    let best = coils.first()?;
    let plain = |one: &&Explanation| series_of(&one.place) == ModeSeries::HeldHeld;
    let simplest = coils.iter().find(plain).filter(|held| {
        held.total > best.total - SIMPLER
            && (held.place.trial.base / best.place.trial.base).ln().abs() < 0.2
            && held.place.modes.len() + 2 >= best.place.modes.len()
    });
    let chosen = simplest.unwrap_or(best);
    let (first, spread) = chosen.first();
    let freedom = 2.0 * chosen.place.modes.len().saturating_sub(chosen.place.trial.knobs.len()).max(1) as f64;
    let factor = crate::uncertainty::coverage_factor(0.95, freedom).unwrap_or(1.96);
    let all = sum_of_logs(&coils.iter().map(|one| one.total).collect::<Vec<_>>());
    let off = |one: &Explanation| (one.first().0 / first - 1.0).abs() > ELSEWHERE;
    let far = |one: &Explanation| (one.first().0 / first).ln().abs() > FAR;
    // No mount is exactly its model: what its evidence says of a mount nearby is believed by a part only.
    let logs = |which: &dyn Fn(&Explanation) -> bool, share: f64| {
        let each = coils.iter().filter(|one| which(one)).map(|one| one.prior + share * (one.total - one.prior));
        sum_of_logs(&each.collect::<Vec<_>>())
    };
    let odds = |nats: f64| nats.exp() / (1.0 + nats.exp());
    let nearby = odds(logs(&|one| off(one) && !far(one), CAUTION) - logs(&|one| !off(one), CAUTION));
    let moved = nearby + odds(logs(&far, 1.0) - logs(&|one| !far(one), 1.0));
    // A seat whose law misses its lines by more than noise is not the seat that is there.
    let gives = matches!(series_of(&chosen.place), ModeSeries::Gives { .. });
    let doubtful = gives && (chosen.place.misfit > ROUGH || chosen.place.mimics_windings());
    let moved = if doubtful { moved.max(0.5) } else { moved };
    let expanded = (factor * spread).hypot(MODEL);
    // All that the seat does to f1 is in the interval then.
    let expanded = if doubtful { expanded.hypot(USUAL * chosen.gives().unwrap_or(1.0).max(1.0)) } else { expanded };
    Some(Coil {
        mode_series: series_of(&chosen.place),
        windings: windings_of(&chosen.place),
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
            let own = if one.gives().is_some() { one.prior.max(search::GIVES) } else { one.prior };
            one.gives().unwrap_or(1.0) * (one.total - own - all).exp()
        }),
        moved,
        turned: chosen.told.turned,
        delay: 0.0,
        second: None,
        other_windings: None,
    })
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
    let below = |at: f64| parts.iter().map(|part| part.2 * normal_below((at - part.0) / part.1)).sum::<f64>() / total;
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

/// Φ(z) of the normal distribution.
fn normal_below(z: f64) -> f64 {
    0.5 * libm::erfc(-z * std::f64::consts::FRAC_1_SQRT_2)
}

/// A second coil among the lines that the first leaves.
fn second(heard: &[Heard], known: &Known, top: f64, coil: &mut Coil) {
    let rest: Vec<Heard> =
        heard.iter().filter(|one| !coil.modes.iter().any(|(line, _, _)| *line == one.line)).cloned().collect();
    if rest.len() < 3 {
        return;
    }
    let room = Room { heard: &rest, top };
    let plain = Known { mounts: vec![Mount::Held], windings: None, ..*known };
    let others = search::coils(&room, &plain);
    let rival = search::rivals(&room).first().map_or(0.0, |rival| rival.total.max(0.0));
    if let Some(other) = others.first().filter(|other| other.total > SECOND + rival) {
        coil.second = Some(other.place.trial.base);
        let own: f64 = other.place.modes.iter().map(|(line, _)| rest[*line].energy).sum();
        let of_second = |index: usize| other.place.modes.iter().any(|(line, _)| rest[*line].line == heard[index].line);
        let of_first = |index: usize| coil.modes.iter().any(|(line, _, _)| *line == heard[index].line);
        coil.loud = loud(heard, |index| of_first(index) || of_second(index));
        coil.share += own / heard.iter().map(|one| one.energy).sum::<f64>();
    }
}

/// The mount of a coil, for people.
fn series_of(place: &Place) -> ModeSeries {
    match place.trial.law {
        Law::Coil { seats: [Seat::Rigid, Seat::Rigid], .. } => ModeSeries::HeldHeld,
        Law::Coil { seats: [_, Seat::Free], .. } => ModeSeries::HeldFree,
        Law::Coil { seats: [_, Seat::Mass(mu)], .. } => ModeSeries::EndMass { mass_ratio: 1.0 / mu },
        Law::Coil { seats, .. } => {
            let compliance = seats.map(|seat| if let Seat::Gives(kappa, _) = seat { kappa } else { 0.0 });
            let mass = seats.map(|seat| if let Seat::Gives(_, mu) = seat { mu } else { 0.0 });
            ModeSeries::Gives { compliance, mass }
        }
        _ => ModeSeries::HeldHeld,
    }
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
