//! One force fed back at one damping, on all springs that are allowed: its limits, and the loop as it is set.
//!
//! Next door: all of them together (`super`).

use std::f64::consts::TAU;

use coilsense::control::{ForceLoop, Margins, Passivity};
use coilsense::{Channel, Error};

use super::allowed::Varied;
use super::calm::{self, Peak};
use super::loops::UnitLoops;
use crate::spec::DampingCase;

/// One force fed back at one damping: the least of what holds on the springs on which it was judged.
#[derive(Debug, Clone, PartialEq)]
pub struct Assessment {
    /// The proportional gain up to which the loop is stable (command unit per N); infinite without a limit.
    pub limit: f64,
    /// The crossover that the loop would have at that gain with a spring without mass \[Hz\].
    pub stable_crossover: f64,
    /// The same for a sensitivity of at most 2; zero where it is larger at every gain.
    pub robust_crossover: f64,
    /// From which crossover on the sensitivity is at most 2 \[Hz\]; zero where it is in the slowest loop, too.
    pub robust_from: f64,
    /// Where the loop oscillates at its limit \[Hz\]; zero without one.
    pub oscillates_at: f64,
    /// Which of the springs has the least to spare.
    pub weakest: usize,
    /// From force to command, where it has \[s\].
    pub delay: f64,
    /// The loop as it is set, each margin the least.
    pub margins: Margins,
    /// Largest answers of F_i and F_o as it is set; `None` where it is unstable on a spring.
    pub peaks: Option<[Peak; 2]>,
    /// The rendered impedance as it is set, bands of all springs together; `None` for F_L.
    pub passivity: Option<Passivity>,
}

impl Assessment {
    /// Its limits, from a loop with the proportional gain `shape`.
    pub(super) fn of(
        unit: &UnitLoops<'_>,
        damping: &DampingCase,
        channel: Channel,
        shape: f64,
        springs: &[Varied],
    ) -> Result<Self, Error> {
        let cases = unit.under(springs, channel);
        let each = cases.iter().map(|under| margins(unit, &unit.on(*under, damping, channel, shape)?));
        let each = each.collect::<Result<Vec<_>, Error>>()?;
        let weakest = weakest(each.iter().map(|margins| margins.gain_limit));
        let nominal = unit.force_loop(damping, channel, shape)?;
        let crossover = |factor: f64| UnitLoops::crossover(&nominal, factor);
        let all = each.iter().copied().reduce(least).unwrap_or(each[weakest]);
        let (from, robust) =
            if all.robust_from < all.robust_gain { (all.robust_from, all.robust_gain) } else { (0.0, 0.0) };
        Ok(Self {
            limit: shape * all.gain_limit,
            stable_crossover: crossover(all.gain_limit)?,
            robust_crossover: crossover(robust)?,
            robust_from: crossover(from)?,
            oscillates_at: all.critical_frequency / TAU,
            weakest: cases[weakest].place,
            delay: cases[weakest].delay,
            margins: all,
            peaks: None,
            passivity: None,
        })
    }

    /// The loop as it is set: its proportional gain.
    pub(super) fn set(
        &mut self,
        unit: &UnitLoops<'_>,
        damping: &DampingCase,
        channel: Channel,
        gain: f64,
        springs: &[Varied],
    ) -> Result<(), Error> {
        let cases = unit.under(springs, channel);
        let loops = cases.iter().map(|under| unit.on(*under, damping, channel, gain));
        let loops = loops.collect::<Result<Vec<_>, Error>>()?;
        let each = loops.iter().map(|force_loop| margins(unit, force_loop)).collect::<Result<Vec<_>, Error>>()?;
        // An observer does not grow with the gain: another spring may now have the least to spare.
        let weakest = &cases[weakest(each.iter().map(|margins| margins.gain_limit))];
        (self.weakest, self.delay) = (weakest.place, weakest.delay);
        self.margins = each.into_iter().reduce(least).unwrap_or(self.margins);
        self.peaks = None;
        if self.margins.stable {
            let mut seen = None;
            for (under, force_loop) in cases.iter().zip(&loops).rev() {
                let closed = unit.closed(force_loop.clone())?;
                let watched = match seen.take() {
                    Some((place, watched)) if place == under.place => watched,
                    _ => calm::watched(&closed)?,
                };
                let peaks = calm::peaks(&closed, &watched)?;
                seen = Some((under.place, watched));
                self.peaks = Some(self.peaks.map_or(peaks, |others| calm::larger(others, peaks)));
            }
        }
        self.passivity = None;
        for force_loop in &loops {
            let Some(passivity) = unit.passivity(force_loop)? else { break };
            self.passivity = Some(self.passivity.take().map_or(passivity.clone(), |others| both(&others, &passivity)));
        }
        Ok(())
    }
}

fn margins(unit: &UnitLoops<'_>, force_loop: &ForceLoop) -> Result<Margins, Error> {
    match unit.sampled(force_loop)? {
        Some(sampled) => sampled.margins(),
        None => force_loop.margins(),
    }
}

/// Two limits this near each other are one: rounding does not choose the spring that is run.
const SAME: f64 = 1e-9;

/// Where the least stands; the first of equals.
pub(super) fn weakest(mut limits: impl Iterator<Item = f64> + Clone) -> usize {
    let least = limits.clone().fold(f64::INFINITY, f64::min);
    limits.position(|limit| limit <= least * (1.0 + SAME)).unwrap_or(0)
}

/// What is left of two.
fn least(a: Margins, b: Margins) -> Margins {
    let tighter = if b.gain_limit < a.gain_limit { b } else { a };
    let later = if b.phase < a.phase { b } else { a };
    Margins {
        stable: a.stable && b.stable,
        gain_limit: tighter.gain_limit,
        critical_frequency: tighter.critical_frequency,
        crossover: later.crossover,
        phase: later.phase,
        delay: a.delay.min(b.delay),
        modulus: a.modulus.min(b.modulus),
        robust_gain: a.robust_gain.min(b.robust_gain),
        robust_from: a.robust_from.max(b.robust_from),
    }
}

/// Where either is not passive.
fn both(a: &Passivity, b: &Passivity) -> Passivity {
    let mut bands: Vec<[f64; 2]> = a.active.iter().chain(&b.active).copied().collect();
    bands.sort_by(|one, other| one[0].total_cmp(&other[0]));
    let mut active: Vec<[f64; 2]> = Vec::new();
    for band in bands {
        match active.last_mut().filter(|last| band[0] <= last[1]) {
            Some(last) => last[1] = last[1].max(band[1]),
            None => active.push(band),
        }
    }
    Passivity { active, least: a.least.min(b.least), up_to: a.up_to }
}
