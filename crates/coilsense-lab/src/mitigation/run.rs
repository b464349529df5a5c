//! A study run: every candidate designed and judged on all runs.
//!
//! Next door: the study (`study`), the candidates (`candidates`), how they are judged (`judge`), what comes of it (`ranking`).

use std::sync::atomic::{AtomicUsize, Ordering};

use coilsense::Error;
use coilsense::mitigation::SampledSpring;
use rand_distr::Normal;
use rayon::prelude::*;

use super::candidate::{Candidate, Truth};
use super::candidates::{Brief, Candidates};
use super::judge::{Judgement, Trial, order};
use super::ranking::Ranking;
use super::request::{NOISE, Refused};
use super::runs;
use super::shaping::Shaping;
use super::study::{POSITIVE, Study, unfit};

impl Study {
    /// Designs and judges every candidate.
    ///
    /// # Errors
    /// [`Refused`], with the option that it is about; a candidate that cannot be is no error but left out.
    pub fn run(self) -> Result<Ranking, Refused> {
        self.run_watched(&|_, _| ())
    }

    /// The same; `told` hears how many candidates are judged, and of how many.
    ///
    /// # Errors
    /// As [`Self::run`].
    pub fn run_watched(self, told: &(dyn Fn(usize, usize) + Sync)) -> Result<Ranking, Refused> {
        self.check()?;
        let sampled = SampledSpring::new(&self.spring, &self.dampings[self.nominal_damping].1, self.rate)?;
        let nominal = runs::nominal(&self)?;
        let largest = |of: fn(&runs::Run) -> f64| nominal.iter().map(of).fold(0.0, f64::max);
        // An impact at v rings by Z v; without any ringing a hundredth of the noise stands for it.
        let impact = largest(runs::Run::ringing).max(0.01 * self.noise) / self.spring.wave_impedance();
        let brief = Brief {
            spring: &sampled,
            tolerances: self.tolerances,
            noise: self.noise,
            impact,
            interval: self.longest().min(60.0),
            bandwidth: self.bandwidth,
            // A force that stays where it is in these conditions is wanted up to the bandwidth all the same.
            motion: largest(runs::Run::motion).max(0.01 * self.spring.nominal_force()),
        };
        let mut candidates = Candidates::of(&brief);
        if self.recorded.as_ref().is_some_and(|recorded| recorded.output.is_none()) {
            candidates.all.retain(|candidate| candidate.truth == Truth::Static);
        }
        let shaping = Shaping::of(&self, &sampled)?;
        let trial = self.trial(&sampled, nominal, impact)?;
        let (done, of) = (AtomicUsize::new(0), candidates.all.len());
        told(0, of);
        let mut judged: Vec<(Candidate, Judgement)> = candidates
            .all
            .into_par_iter()
            .map(|candidate| {
                let judgement = trial.judge(&candidate);
                told(done.fetch_add(1, Ordering::Relaxed) + 1, of);
                (candidate, judgement)
            })
            .collect();
        judged.sort_by(order);
        let runs = trial.over_the_box.len();
        let mut answer = Ranking { study: self, judged, left_out: candidates.left_out, runs, shown: None, shaping };
        let all: Vec<&Candidate> = answer.judged.iter().map(|(candidate, _)| candidate).collect();
        answer.shown = trial.shown(&all, sampled.surge_period());
        Ok(answer)
    }

    fn trial(&self, sampled: &SampledSpring, nominal: Vec<runs::Run>, impact: f64) -> Result<Trial, Error> {
        let noise =
            Normal::new(0.0, self.noise).map_err(|_| unfit(&NOISE, "noise of the force", self.noise, "N", POSITIVE))?;
        Ok(Trial {
            nominal,
            over_the_box: runs::over_the_box(self)?,
            impact: runs::impact(self, impact)?,
            swing: runs::swing(self, self.bandwidth)?,
            bandwidth: self.bandwidth,
            rate: self.rate,
            noise,
            adds_noise: self.recorded.is_none(),
            seeds: self.seeds,
            seed: self.seed,
            longest_delay: (2.0 * sampled.surge_period()) as usize,
        })
    }
}
