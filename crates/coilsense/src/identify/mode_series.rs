//! How a spring is mounted, and where its modes fold to above half the sampling rate.
//!
//! Next door: which mount explains the lines (`explain`), what follows from the series (the parent).

use crate::measures::alias_of;
use crate::modes::end_mass_root;

use super::phase_law::giving_multiple;
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
    /// Seats that give, and that may have a mass: a load cell, a compliant mount.
    Gives {
        /// κ = k/K at end 1 and at end 2: stiffness of the coil over that of the seat; zero where it is rigid.
        compliance: [f64; 2],
        /// M/m: mass of the seat over that of the coil.
        mass: [f64; 2],
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
            Self::Gives { compliance, mass } => return giving_multiple(*compliance, *mass, mode, windings),
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
            Self::Gives { mass: [0.0, 0.0], .. } => "a mount that gives",
            Self::Gives { .. } => "a mount or load cell that resonates",
        }
    }
}

/// A line, as far as folding goes.
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

/// Highest mode that is looked for.
const HIGHEST: usize = 60;
/// Up to how many times the sampling rate folded modes are looked for.
const FOLDED: f64 = 2.0;
/// How far a line may lie off its step, relative.
const OFF: f64 = 0.004;

/// Lines that a mode above half the sampling rate folds to.
pub(super) fn folded(
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

/// Whether a mode can ring in that part: between held ends odd modes pull the ends in turn, even ones together.
fn fits_part(part: Option<Part>, series: ModeSeries, mode: usize) -> bool {
    match (series, part) {
        (ModeSeries::HeldHeld, Some(Part::Difference)) => mode % 2 == 1,
        (ModeSeries::HeldHeld, Some(Part::Sum)) => mode.is_multiple_of(2),
        (ModeSeries::HeldHeld, None) => true,
        _ => true,
    }
}
