//! What the two ends' pulls say: in a coil they go in turn and together by turns, and their sizes follow from the seats.
//!
//! Next door: how the pulls were measured (`heard`), where the lines lie (`place`).

use std::f64::consts::{PI, TAU};

use super::fit::sum_of_logs;
use super::heard::{Ends, Heard};
use super::normal::density;
use super::place::Place;
use crate::identify::median::{median, weighted_median};
use crate::identify::phase_law::{Law, Seat, mode_of};

/// How far sizes at both ends may be off what the law says \[1\], relative: each is tried.
const OFF: [f64; 3] = [3e-3, 3e-2, 0.15];
/// How far phases may be off \[rad\].
const PHASE_OFF: f64 = 0.05;
/// Spread of ln |F_o/F_i| of lines that are none of a coil's.
const STRANGE: f64 = 1.2;
/// Share of a coil's lines whose ends are disturbed by something.
const DISTURBED: f64 = 0.03;
/// How far the sensors' gains may differ \[1\], relative, as a standard deviation.
const GAINS: f64 = 0.1;
/// ln of how likely a turned sign, a late channel, a force felt behind the seat are.
const TURNED: f64 = -3.5;
pub(super) const LATE: f64 = -9.0;
const BEHIND: f64 = -1.0;

/// What the ends say of a law.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Told {
    /// ln of the evidence over that of ends that pull as they like.
    pub(super) evidence: f64,
    /// Whether one force has the other's sign.
    pub(super) turned: bool,
}

const SILENT: Told = Told { evidence: 0.0, turned: false };

/// One line's pulls beside what the law wants.
struct Pair {
    ends: Ends,
    angular: f64,
    /// Whether the ends are wanted in opposite phase.
    opposite: bool,
    /// ln |F_o/F_i| wanted.
    ratio: f64,
}

/// Of a coil: every way in which its forces may be felt.
///
/// `turned`: whether one force is known to have the other's sign, or not to.
pub(super) fn of_coil(place: &Place, heard: &[Heard], turned: Option<bool>) -> Told {
    let Law::Coil { windings, seats } = place.trial.law else { return SILENT };
    let gives = seats.map(|seat| matches!(seat, Seat::Gives(..)));
    let mut best: Option<Told> = None;
    for behind in [[false, false], [true, false], [false, true], [true, true]] {
        if (behind[0] && !gives[0]) || (behind[1] && !gives[1]) {
            continue;
        }
        let prior = BEHIND * behind.iter().filter(|one| **one).count() as f64;
        let pairs: Vec<Pair> = place
            .modes
            .iter()
            .filter_map(|&(line, mode)| {
                let found = mode_of(windings, seats, mode)?;
                let pull = |end: usize| match seats[end] {
                    Seat::Gives(kappa, _) if behind[end] => found.phases[end].sin() / (kappa * found.tangent),
                    _ => found.phases[end].cos(),
                };
                let ratio = pull(1) / pull(0);
                let opposite = (mode % 2 == 1) == (ratio > 0.0);
                pair(&heard[line], opposite, ratio.abs().max(1e-9).ln())
            })
            .collect();
        let mut told = judge(&pairs, turned);
        told.evidence += prior;
        if best.is_none_or(|old| told.evidence > old.evidence) {
            best = Some(told);
        }
    }
    best.unwrap_or(SILENT)
}

/// Of what is no coil: ends in turn and together as a symmetric beam's or string's, alike in all lines as one motion's, or as they like.
pub(super) fn of_rival(place: &Place, heard: &[Heard]) -> f64 {
    let pairs = |opposite: fn(usize) -> bool| -> Vec<Pair> {
        place.modes.iter().filter_map(|&(line, mode)| pair(&heard[line], opposite(mode), 0.0)).collect()
    };
    let alike = pairs(|_| false);
    // One motion's gain to either end is anything.
    let mut ratios: Vec<f64> = alike.iter().map(|pair| pair.ends.ratio).collect();
    let middle = median(&mut ratios);
    let alike: Vec<Pair> = alike.into_iter().map(|pair| Pair { ratio: middle, ..pair }).collect();
    let turn = |told: Told| told.evidence - if told.turned { TURNED } else { 0.0 };
    let by_turns = match place.trial.law {
        Law::String(_) | Law::Beam(_) => turn(judge(&pairs(|mode| mode % 2 == 1), None)) - 0.7,
        _ => f64::NEG_INFINITY,
    };
    by_turns.max(turn(judge(&alike, None)) - 2.5).max(0.0)
}

fn pair(heard: &Heard, opposite: bool, ratio: f64) -> Option<Pair> {
    Some(Pair { ends: heard.ends?, angular: TAU * heard.frequency, opposite, ratio })
}

/// By how much F_o is later than F_i \[s\], and how much more that explains, where the ends of a held coil pull as they should only then.
pub(super) fn delay(place: &Place, heard: &[Heard], turned: Option<bool>) -> Option<f64> {
    let one = |&(line, mode): &(usize, usize)| pair(&heard[line], mode % 2 == 1, 0.0);
    let pairs: Vec<Pair> = place.modes.iter().filter_map(one).collect();
    if pairs.len() < 3 {
        return None;
    }
    let offset = offset(&pairs);
    let in_time = judge(&pairs, turned).evidence;
    let at = |delay: f64| pairs.iter().map(|pair| gain(pair, OFF[2], offset, delay, turned == Some(true))).sum::<f64>();
    // Up to a period of the lowest line, as finely as the highest line's phase asks for.
    let lowest = pairs.iter().map(|pair| pair.angular).fold(f64::INFINITY, f64::min);
    let highest = pairs.iter().map(|pair| pair.angular).fold(0.0, f64::max);
    let (reach, step) = (TAU / lowest, 0.2 / highest);
    let count = ((reach / step) as i64).min(1000);
    let grid = (-count..=count).map(|number| step * number as f64);
    let best = grid.max_by(|a, b| at(*a).total_cmp(&at(*b)))?;
    let fine = (-20..=20).map(|number| best + 0.05 * step * f64::from(number));
    let best = fine.max_by(|a, b| at(*a).total_cmp(&at(*b)))?;
    (at(best) + LATE > in_time).then_some(best)
}

/// ln of the sensors' relative gain: of faint lines the sizes are unsure, and a mount must not be believed for their chance alone.
fn offset(pairs: &[Pair]) -> f64 {
    let of = |pair: &Pair| (pair.ends.ratio - pair.ratio, pair.ends.spread.hypot(OFF[0]).recip());
    weighted_median(&mut pairs.iter().map(of).collect::<Vec<_>>())
}

/// The likelier sign, and the evidence with it.
fn judge(pairs: &[Pair], turned: Option<bool>) -> Told {
    if pairs.is_empty() {
        return SILENT;
    }
    let offset = offset(pairs);
    let gains = if pairs[0].ends.sized { -0.5 * (offset / GAINS).powi(2).min(12.0) } else { 0.0 };
    let at = |turned: bool| {
        let levels = OFF.map(|off| pairs.iter().map(|pair| gain(pair, off, offset, 0.0, turned)).sum::<f64>());
        sum_of_logs(&levels) - (OFF.len() as f64).ln() + gains
    };
    if let Some(turned) = turned {
        return Told { evidence: at(turned), turned };
    }
    let (right, turned) = (at(false), at(true) + TURNED);
    Told { evidence: right.max(turned), turned: turned > right }
}

/// ln of one line's density under the law over that of a stranger.
fn gain(pair: &Pair, off: f64, offset: f64, delay: f64, turned: bool) -> f64 {
    let phase_spread = pair.ends.spread.hypot(PHASE_OFF);
    let wanted = if pair.opposite != turned { PI } else { 0.0 } - pair.angular * delay;
    let wrapped = |angle: f64| (angle + PI).rem_euclid(TAU) - PI;
    let about = |angle: f64| density(wrapped(pair.ends.phase - angle), phase_spread).max(1e-12);
    let size = |off: f64| {
        if pair.ends.sized { density(pair.ends.ratio - pair.ratio - offset, pair.ends.spread.hypot(off)) } else { 1.0 }
    };
    let strange_size =
        if pair.ends.sized { density(pair.ends.ratio, pair.ends.spread.hypot(STRANGE)).max(1e-6) } else { 1.0 };
    let strange_phase = 0.35 * (about(0.0) + about(PI)) + 0.3 / TAU;
    let strange = strange_phase * strange_size;
    let own = about(wanted).min(1.0 / phase_spread) * size(off);
    ((1.0 - DISTURBED) * own + DISTURBED * strange).ln() - strange.ln()
}
