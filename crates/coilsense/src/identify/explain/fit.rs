//! A law's numbers fitted to lines, and the evidence of what came of it.
//!
//! Next door: the numbers (`trial`), the lines (`room`), which line is which mode (`place`).

use std::f64::consts::TAU;

use nalgebra::{DMatrix, DVector};

use super::heard::Heard;
use super::room::{FREEDOM, Room};
use super::trial::{Knob, Trial};
use crate::identify::phase_law::Law;

/// How far a line may lie off its place while that is sought \[1\], relative.
pub(super) const OFF_SEARCH: f64 = 1e-4;
/// By how much more the square of what lines scatter by beyond that may be for the faintest \[1\].
const FAINTEST: f64 = 30.0;
/// Steps of a fit, at most.
const STEPS: usize = 12;

/// Where knobs are expected, and the standard deviation of each.
pub(super) type Expected<'a> = (&'a [f64], &'a [f64]);

/// What a fit is held against.
struct Target<'a> {
    room: &'a Room<'a>,
    /// (index of what is heard, mode).
    modes: &'a [(usize, usize)],
    /// How far lines scatter beyond noise \[1\], relative.
    off: f64,
    /// Energy of the loudest of these lines.
    loudest: f64,
    expected: Option<Expected<'a>>,
}

/// The normal equations at a trial.
struct Equations {
    cost: f64,
    normal: DMatrix<f64>,
    right: DVector<f64>,
}

impl Target<'_> {
    /// Variance of a line about its place.
    fn variance(&self, heard: &Heard) -> f64 {
        // What lines do to one another moves the faint ones more.
        let faint = if self.off > OFF_SEARCH { (self.loudest / heard.energy).min(FAINTEST) } else { 1.0 };
        heard.spread * heard.spread + self.off * self.off * faint
    }

    /// Misfits are weighed after Student.
    fn equations(&self, trial: &Trial) -> Option<Equations> {
        let count = trial.knobs.len();
        let (mut normal, mut right, mut cost) = (DMatrix::zeros(count, count), DVector::zeros(count), 0.0);
        for &(line, mode) in self.modes {
            let heard = &self.room.heard[line];
            let (place, slopes) = trial.slopes(mode)?;
            let (left, variance) = (heard.log - place, self.variance(heard));
            let z2 = left * left / variance;
            cost += 0.5 * (FREEDOM + 1.0) * (1.0 + z2 / FREEDOM).ln();
            let weight = (FREEDOM + 1.0) / (FREEDOM + z2) / variance;
            for row in 0..count {
                right[row] += weight * slopes[row] * left;
                for column in 0..count {
                    normal[(row, column)] += weight * slopes[row] * slopes[column];
                }
            }
        }
        if let Some((centre, prior)) = self.expected {
            for (index, knob) in trial.knobs.iter().enumerate().filter(|(_, knob)| **knob != Knob::Base) {
                let left = centre[index] - trial.get(*knob);
                cost += 0.5 * (left / prior[index]).powi(2);
                right[index] += left / prior[index].powi(2);
                normal[(index, index)] += prior[index].powi(-2);
            }
        }
        Some(Equations { cost, normal, right })
    }
}

impl Equations {
    /// The trial one step on.
    fn next(&self, trial: &Trial, damping: f64) -> Option<Trial> {
        let mut damped = self.normal.clone();
        for index in 0..trial.knobs.len() {
            damped[(index, index)] = damped[(index, index)] * (1.0 + damping) + 1e-12;
        }
        let step = damped.cholesky()?.solve(&self.right);
        let mut next = trial.clone();
        for (knob, change) in trial.knobs.iter().zip(step.iter()) {
            let most = if matches!(knob, Knob::Kappa(_) | Knob::Mu(_) | Knob::Bending) { 1.0 } else { f64::INFINITY };
            next.set(*knob, trial.get(*knob) + change.clamp(-most, most));
        }
        Some(next)
    }

    fn covariance(mut self, knobs: &[Knob]) -> Option<DMatrix<f64>> {
        // A knob that the lines do not decide is as unsure as its bounds.
        for (index, knob) in knobs.iter().enumerate() {
            let (low, high) = knob.bounds();
            self.normal[(index, index)] += ((high - low) / 4.0).powi(-2);
        }
        self.normal.cholesky().map(|factor| factor.inverse())
    }
}

/// Fits the knobs to lines by Levenberg and Marquardt; the covariance. `off`: how far lines scatter beyond noise \[1\], relative.
pub(super) fn fit(
    room: &Room,
    trial: &mut Trial,
    modes: &[(usize, usize)],
    off: f64,
    expected: Option<Expected>,
) -> Option<DMatrix<f64>> {
    let loudest = modes.iter().map(|(line, _)| room.heard[*line].energy).fold(f64::MIN_POSITIVE, f64::max);
    let target = Target { room, modes, off, loudest, expected };
    let mut equations = target.equations(trial)?;
    let mut damping = 1e-6;
    for _ in 0..STEPS {
        let next = equations.next(trial, damping)?;
        match target.equations(&next) {
            Some(lower) if lower.cost <= equations.cost => {
                let still = equations.cost - lower.cost < 1e-7;
                equations = lower;
                *trial = next;
                damping *= 0.1;
                if still {
                    break;
                }
            }
            _ => {
                damping = (10.0 * damping).max(1e-4);
                if damping > 1e8 {
                    break;
                }
            }
        }
    }
    equations.covariance(&trial.knobs)
}

/// ln of the evidence of a fitted trial: each mode's line over chance, modes that are not heard, and what its knobs could have been (Laplace).
pub(super) fn evidence(
    room: &Room,
    trial: &Trial,
    modes: &[(usize, usize)],
    off: f64,
    covariance: &DMatrix<f64>,
) -> f64 {
    let of = |&(line, mode): &(usize, usize)| {
        let heard = &room.heard[line];
        let place = trial.line(mode).unwrap_or(f64::NAN);
        room.gain(heard, heard.log - place, (heard.spread * heard.spread + off * off).sqrt())
    };
    let lines: f64 = modes.iter().map(of).sum();
    let highest = modes.iter().map(|entry| entry.1).max().unwrap_or(0);
    let unheard = highest.saturating_sub(modes.len());
    let knobs = trial.knobs.iter().enumerate().map(|(index, knob)| match (knob, trial.law) {
        (Knob::Base, Law::Mains(_)) => -(4e-3_f64.ln()),
        // 1/N² that the lines do not tell from zero takes no more than all of its prior.
        (Knob::Chain, _) => {
            let standard = covariance[(index, index)].max(1e-300).sqrt();
            knob.prior(trial.get(*knob)).min(-(TAU.sqrt() * standard).ln())
        }
        _ => knob.prior(trial.get(*knob)),
    });
    let volume = 0.5 * (trial.knobs.len() as f64 * TAU.ln() + covariance.determinant().max(1e-300).ln());
    lines + unheard_cost(modes.len(), unheard) + knobs.sum::<f64>() + volume
}

/// ln ∫ p^a (1 − p)^b dp: a modes heard and b not, whatever the share that is heard.
pub(super) fn unheard_cost(heard: usize, unheard: usize) -> f64 {
    let factorial = |n: usize| (1..=n).map(|k| (k as f64).ln()).sum::<f64>();
    factorial(heard) + factorial(unheard) - factorial(heard + unheard + 1)
}

/// ln Σ exp.
pub(super) fn sum_of_logs(values: &[f64]) -> f64 {
    let most = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    if most == f64::NEG_INFINITY { most } else { most + values.iter().map(|v| (v - most).exp()).sum::<f64>().ln() }
}
