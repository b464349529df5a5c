//! One run over time, for people to see: what is measured, what is true, what each candidate makes of it.
//!
//! Next door: the runs (`runs`), what is read off all of them (`judge`).

use rand_distr::Distribution;

use super::candidate::{Candidate, Truth};
use super::judge::Trial;
use super::runs::Run;

/// What one candidate makes of the run.
#[derive(Debug, Clone, PartialEq)]
pub struct Made {
    /// Its name.
    pub name: String,
    /// What its force is to be.
    pub truth: Truth,
    /// That force \[N\].
    pub truly: Vec<f64>,
    /// What comes out \[N\].
    pub out: Vec<f64>,
}

/// The nominal run that rings hardest, about where it does, with the first series of noise.
#[derive(Debug, Clone, PartialEq)]
pub struct Shown {
    /// Which run.
    pub label: String,
    /// \[s\], from the run's beginning.
    pub time: Vec<f64>,
    /// F_i as the controller gets it \[N\].
    pub measured: Vec<f64>,
    /// Every candidate's, in the order of the answer's.
    pub made: Vec<Made>,
}

/// Surge periods that are shown, and how many of them come before the ringing's peak.
const PERIODS: [f64; 2] = [25.0, 3.0];

impl Trial {
    /// The run that rings hardest, as `candidates` take it; a surge period lasts `period` samples.
    pub fn shown(&self, candidates: &[&Candidate], period: f64) -> Option<Shown> {
        let run = self.nominal.iter().max_by(|a, b| a.ringing().total_cmp(&b.ringing()))?;
        let peak = run.loudest();
        let from = peak.saturating_sub((PERIODS[1] * period) as usize);
        let to = from.saturating_add((PERIODS[0] * period) as usize).min(run.measured.len());
        let noisy = self.noisy(run, to);
        let made = candidates.iter().map(|candidate| {
            let mut running = candidate.start.start(&run.at_rest);
            let out: Vec<f64> = noisy.iter().map(running.as_mut()).collect();
            Made {
                name: candidate.name.clone(),
                truth: candidate.truth,
                truly: run.truth(candidate.truth)[from..to].to_vec(),
                out: out[from..].to_vec(),
            }
        });
        Some(Shown {
            label: run.label.clone(),
            time: (from..to).map(|index| index as f64 / self.rate).collect(),
            measured: noisy[from..].iter().map(|measured| measured.force).collect(),
            made: made.collect(),
        })
    }

    /// The first `count` samples of a run with the first series of noise.
    fn noisy(&self, run: &Run, count: usize) -> Vec<coilsense_rt::Measured<f64>> {
        let mut random = self.random(0);
        let mut noisy = run.measured[..count].to_vec();
        for measured in noisy.iter_mut().filter(|_| self.adds_noise) {
            measured.force += self.noise.sample(&mut random);
        }
        noisy
    }
}
