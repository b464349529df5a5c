//! What lines mean: which mode of which mount each is, or an alias of one.
//!
//! Next door: the lines (`refine`), what follows from the series (the parent).

use crate::measures::alias_of;
use crate::modes::end_mass_root;

use super::ringing::Part;

/// How a spring is mounted, as far as its lines say.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum ModeSeries {
    /// Both ends held: f_j = j f1, less what a chain of N windings lies below that.
    HeldHeld,
    /// End 2 free, or under a force that stays: f_j = (2j − 1) f1/2.
    HeldFree,
    /// A mass at end 2: f_j = β_j f1/π with β tan β = m/M.
    EndMass {
        /// m/M: mass of the coil over that of the end.
        mass_ratio: f64,
    },
}

impl ModeSeries {
    /// f_j over f1 of the held spring.
    ///
    /// - `mode`: j, at least 1; `windings`: N, infinite for the continuous coil
    pub fn multiple(&self, mode: usize, windings: f64) -> f64 {
        let j = mode as f64;
        let turns = match self {
            Self::HeldHeld => j,
            Self::HeldFree => j - 0.5,
            Self::EndMass { mass_ratio } => end_mass_root(*mass_ratio, mode) / std::f64::consts::PI,
        };
        if !windings.is_finite() {
            return turns;
        }
        let quarter = std::f64::consts::FRAC_PI_2 / windings;
        (turns.min(windings) * quarter).sin() / quarter.sin()
    }

    /// Its name in words.
    pub fn name(&self) -> &'static str {
        match self {
            Self::HeldHeld => "both ends held",
            Self::HeldFree => "end 2 free",
            Self::EndMass { .. } => "a mass at end 2",
        }
    }
}

/// What a matcher needs of a line.
#[derive(Debug, Clone, Copy)]
pub(super) struct Observation {
    /// Undamped frequency \[Hz\], and its standard uncertainty.
    pub(super) frequency: f64,
    pub(super) standard: f64,
    /// How far it stands out.
    pub(super) weight: f64,
    /// In which part it rings; none where in both.
    pub(super) part: Option<Part>,
}

/// A series laid against lines.
#[derive(Debug, Clone)]
pub(super) struct Match {
    pub(super) mode_series: ModeSeries,
    /// f1 \[Hz\] of the spring with both ends held.
    pub(super) first: f64,
    /// N of the chain that fits best; infinite for the continuous coil.
    pub(super) windings: f64,
    /// (line, mode, frequency \[Hz\] that the series has there), the lowest mode first.
    pub(super) modes: Vec<(usize, usize, f64)>,
    /// The same of lines that are folded: frequency before folding.
    pub(super) aliases: Vec<(usize, usize, f64)>,
    pub(super) score: f64,
}

/// Highest mode that is looked for.
const HIGHEST: usize = 60;
/// Fewest windings that a chain is thought to have.
const FEWEST: f64 = 5.0;
/// What a mode costs that should be there and is not, in units of the logarithm of a line's strength.
const UNSEEN: f64 = 3.0;
/// Up to how many times the sampling rate folded modes are looked for.
const FOLDED: f64 = 2.0;
/// How far a line may lie off its step, relative.
const OFF: f64 = 0.004;

/// The series that explains the lines best; none where there is no line.
pub(super) fn best(lines: &[Observation], series: ModeSeries, windings: Option<f64>, rate: f64) -> Option<Match> {
    let mut strongest: Vec<usize> = (0..lines.len()).collect();
    strongest.sort_by(|&a, &b| lines[b].weight.total_cmp(&lines[a].weight));
    let mut found: Option<Match> = None;
    for &base in strongest.iter().take(6) {
        for mode in 1..=3 {
            if !fits_part(lines[base].part, series, mode) {
                continue;
            }
            let trial = assign(lines, series, windings, rate, base, mode);
            // Of two that explain as much, the one whose first mode is higher needs fewer modes that were not seen.
            let better = |old: &Match| {
                trial.score > 1.001 * old.score || (trial.score > 0.999 * old.score && trial.first > old.first)
            };
            if found.as_ref().is_none_or(better) {
                found = Some(trial);
            }
        }
    }
    found
}

/// m/M for which two lines are modes 1 and 2 of a coil with an end mass: β_2/β_1 falls as m/M grows, from infinity to 3.
pub(super) fn mass_ratio_of(first: f64, second: f64) -> Option<f64> {
    let wanted = second / first;
    let ratio = |mass_ratio: f64| end_mass_root(mass_ratio, 2) / end_mass_root(mass_ratio, 1);
    let (mut low, mut high) = (1e-6_f64.ln(), 1e6_f64.ln());
    if !(wanted < ratio(low.exp()) && wanted > ratio(high.exp())) {
        return None;
    }
    for _ in 0..100 {
        let middle = 0.5 * (low + high);
        if ratio(middle.exp()) > wanted { low = middle } else { high = middle }
    }
    Some(low.exp())
}

/// Goes up the modes from the guess that line `base` is mode `mode`, and learns N on the way.
fn assign(
    lines: &[Observation],
    series: ModeSeries,
    windings: Option<f64>,
    rate: f64,
    base: usize,
    mode: usize,
) -> Match {
    let mut chain = windings.unwrap_or(f64::INFINITY);
    let mut known = windings.is_some();
    let mut first = lines[base].frequency / series.multiple(mode, chain);
    let mut modes: Vec<(usize, usize, f64)> = Vec::new();
    let mut missed = 0;
    for j in 1..=HIGHEST {
        let step = first * series.multiple(j, chain);
        if step > 0.5 * rate || missed > 6 {
            break;
        }
        let low = if known { step } else { first * series.multiple(mode, chain) * least_step(series, j, mode) };
        let within = |seen: &Observation| {
            let room = (OFF + unsure(lines, &modes, j)) * step + 3.0 * seen.standard.min(0.02 * step);
            seen.frequency > low.min(step) - room && seen.frequency < step + room
        };
        let free = |index: &usize| !modes.iter().any(|(line, _, _)| line == index);
        let candidates = (0..lines.len())
            .filter(|index| within(&lines[*index]) && fits_part(lines[*index].part, series, j))
            .filter(free);
        let pick = if j == mode {
            Some(base)
        } else {
            candidates.max_by(|&a, &b| lines[a].weight.total_cmp(&lines[b].weight))
        };
        match pick {
            None => missed += 1,
            Some(line) => {
                missed = 0;
                modes.push((line, j, step));
                if windings.is_none() && modes.len() > 1 {
                    chain = chain_of(lines, series, &modes);
                    known = true;
                    first = lines[base].frequency / series.multiple(mode, chain);
                }
            }
        }
    }
    for entry in &mut modes {
        entry.2 = first * series.multiple(entry.1, chain);
    }
    let aliases = if modes.len() > 1 || windings.is_some() {
        let taken: Vec<usize> = modes.iter().map(|entry| entry.0).collect();
        folded(lines, series, first, chain, rate, &taken)
    } else {
        Vec::new()
    };
    let score = score(lines, series, &modes);
    Match { mode_series: series, first, windings: chain, modes, aliases, score }
}

/// Mode j over mode `base` in the shortest chain: as low as it may lie before N is known.
fn least_step(series: ModeSeries, j: usize, base: usize) -> f64 {
    series.multiple(j, FEWEST.max(j as f64)) / series.multiple(base, FEWEST.max(base as f64))
}

/// What the lines that a series explains weigh, less what the modes below its highest cost that should be there and are not.
fn score(lines: &[Observation], series: ModeSeries, modes: &[(usize, usize, f64)]) -> f64 {
    let highest = modes.last().map_or(0, |entry| entry.1);
    let unseen = (1..highest)
        .filter(|mode| fits_any(lines, series, *mode) && !modes.iter().any(|entry| entry.1 == *mode))
        .count();
    modes.iter().map(|(line, _, _)| (1.0 + lines[*line].weight).ln()).sum::<f64>() - UNSEEN * unseen as f64
}

/// How far a step may be off \[1\] because N follows from lines that are not sure: f_j/f1 = j (1 − (j² − 1) π²/24N²) to first order.
fn unsure(lines: &[Observation], modes: &[(usize, usize, f64)], mode: usize) -> f64 {
    let lever = |j: usize| (j * j - 1) as f64;
    let of = |entry: &(usize, usize, f64)| 3.0 * lines[entry.0].standard / lines[entry.0].frequency / lever(entry.1);
    let best = modes.iter().filter(|entry| entry.1 > 1).map(of).fold(f64::INFINITY, f64::min);
    // N itself is bounded, so this is.
    if best.is_finite() { (best * lever(mode)).min(0.03) } else { 0.0 }
}

/// N of the chain that the modes so far fit best: least squares of the relative misfit over 1/N².
fn chain_of(lines: &[Observation], series: ModeSeries, modes: &[(usize, usize, f64)]) -> f64 {
    let highest = modes.iter().map(|entry| entry.1).max().unwrap_or(1) as f64;
    let misfit = |inverse: f64| {
        let windings = if inverse > 0.0 { 1.0 / inverse.sqrt() } else { f64::INFINITY };
        let ratio = |entry: &(usize, usize, f64)| (lines[entry.0].frequency / series.multiple(entry.1, windings)).ln();
        let weight =
            |entry: &(usize, usize, f64)| 1.0 / ((lines[entry.0].standard / lines[entry.0].frequency).powi(2) + 1e-6);
        let total: f64 = modes.iter().map(weight).sum();
        let mean = modes.iter().map(|entry| weight(entry) * ratio(entry)).sum::<f64>() / total;
        modes.iter().map(|entry| weight(entry) * (ratio(entry) - mean).powi(2)).sum::<f64>()
    };
    // Golden section: one minimum.
    let (mut low, mut high) = (0.0, 1.0 / FEWEST.max(highest).powi(2));
    let golden = 0.5 * (5.0_f64.sqrt() - 1.0);
    for _ in 0..60 {
        let (left, right) = (high - golden * (high - low), low + golden * (high - low));
        if misfit(left) <= misfit(right) { high = right } else { low = left }
    }
    let inverse = 0.5 * (low + high);
    if inverse < 1e-9 { f64::INFINITY } else { 1.0 / inverse.sqrt() }
}

/// Lines that a mode above half the sampling rate folds to.
fn folded(
    lines: &[Observation],
    series: ModeSeries,
    first: f64,
    chain: f64,
    rate: f64,
    taken: &[usize],
) -> Vec<(usize, usize, f64)> {
    let highest = if chain.is_finite() { (chain as usize).min(HIGHEST) } else { HIGHEST };
    let mut found: Vec<(usize, usize, f64)> = Vec::new();
    for j in 1..=highest {
        let step = first * series.multiple(j, chain);
        if step <= 0.5 * rate {
            continue;
        }
        // Far above, so many modes fold that any line is near one.
        if step > FOLDED * rate {
            break;
        }
        let shown = alias_of(step, rate);
        let near = |index: &usize| {
            let seen = &lines[*index];
            let room = 0.5 * OFF * step + 3.0 * seen.standard.min(0.02 * step);
            (seen.frequency - shown).abs() < room && fits_part(seen.part, series, j)
        };
        let open = |index: &usize| !taken.contains(index) && !found.iter().any(|entry| entry.0 == *index);
        let pick =
            (0..lines.len()).filter(near).filter(open).max_by(|&a, &b| lines[a].weight.total_cmp(&lines[b].weight));
        if let Some(line) = pick {
            found.push((line, j, step));
        }
    }
    found
}

/// Whether any line is of the part that a mode rings in: modes that nothing struck are not missed.
fn fits_any(lines: &[Observation], series: ModeSeries, mode: usize) -> bool {
    lines.iter().any(|seen| seen.weight > 1.0 && fits_part(seen.part, series, mode))
}

/// Whether a mode can ring in that part: between held ends odd modes pull the ends in turn, even ones together.
fn fits_part(part: Option<Part>, series: ModeSeries, mode: usize) -> bool {
    match (series, part) {
        (ModeSeries::HeldHeld, Some(Part::Difference)) => mode % 2 == 1,
        (ModeSeries::HeldHeld, Some(Part::Sum)) => mode.is_multiple_of(2),
        (ModeSeries::HeldHeld, None) => false,
        _ => true,
    }
}
