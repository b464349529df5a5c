//! What is read off a candidate's runs: error, lag, noise gain, settling, worst case.
//!
//! Next door: the runs (`runs`), the candidates (`candidates`).

use rand_distr::{Distribution, Normal};

use super::candidate::{Candidate, Truth};
use super::runs::Run;

/// How a candidate did. Errors are rms over all samples, conditions and seeds \[N\].
#[derive(Debug, Clone, PartialEq)]
pub struct Judgement {
    /// On the nominal spring, as it comes.
    pub nominal: f64,
    /// The same once the truth is shifted by the delay at which it fits best.
    pub aligned: f64,
    /// That delay \[s\].
    pub delay: f64,
    /// Lag at the bandwidth asked for \[rad\]; below zero it leads.
    pub lag: f64,
    /// Noise that comes out over noise that goes in, rms \[1\].
    pub noise_gain: f64,
    /// How long after an impact the error stays above a tenth of what the impact makes \[s\].
    pub settling: f64,
    /// The largest error of a run over the box.
    pub worst: f64,
    /// In which run.
    pub worst_run: String,
}

/// What candidates are judged on.
pub(super) struct Trial {
    pub nominal: Vec<Run>,
    pub over_the_box: Vec<Run>,
    pub impact: Run,
    pub swing: Run,
    /// Hz.
    pub bandwidth: f64,
    pub rate: f64,
    /// N rms.
    pub noise: Normal<f64>,
    /// A log has its own.
    pub adds_noise: bool,
    pub seeds: u64,
    /// The first of the seeds.
    pub seed: u64,
    /// Longest delay tried \[samples\].
    pub longest_delay: usize,
}

impl Trial {
    pub fn judge(&self, candidate: &Candidate) -> Judgement {
        let errors = self.squares(&self.nominal, candidate);
        let nominal = mean(&errors).sqrt();
        let each = self.over_the_box.iter().map(|run| (self.mean_square(run, candidate, 0).sqrt(), run));
        let (worst, worst_run) =
            each.fold(
                (0.0, ""),
                |(worst, label), (error, run)| {
                    if error > worst { (error, run.label.as_str()) } else { (worst, label) }
                },
            );
        let (aligned, delay) = self.aligned(candidate, nominal);
        Judgement {
            nominal,
            aligned,
            delay: delay as f64 / self.rate,
            lag: self.lag(candidate),
            noise_gain: self.noise_gain(candidate),
            settling: self.settling(candidate),
            worst,
            worst_run: worst_run.to_owned(),
        }
    }

    fn squares(&self, runs: &[Run], candidate: &Candidate) -> Vec<f64> {
        runs.iter().map(|run| self.mean_square(run, candidate, 0)).collect()
    }

    /// The numbers that make series `seed` of the noise.
    pub fn random(&self, seed: u64) -> rand_pcg::Pcg64 {
        rand_pcg::Pcg64::new(u128::from(self.seed.wrapping_add(seed)), 0x6d69_7469)
    }

    /// Mean square of what comes out less the truth `late` samples before, over all seeds.
    fn mean_square(&self, run: &Run, candidate: &Candidate, late: usize) -> f64 {
        let truth = run.truth(candidate.truth);
        let mut sum = 0.0;
        for seed in 0..self.seeds {
            // Every candidate gets the same noise.
            let mut random = self.random(seed);
            let mut running = candidate.start.start(&run.at_rest);
            for (index, measured) in run.measured.iter().enumerate() {
                let mut noisy = *measured;
                if self.adds_noise {
                    noisy.force += self.noise.sample(&mut random);
                }
                let out = running(&noisy);
                // What was before the beginning is as it was at rest.
                let then = index.checked_sub(late).map_or(run.at_rest.force, |place| truth[place]);
                sum += (out - then) * (out - then);
            }
        }
        sum / (self.seeds * run.measured.len() as u64) as f64
    }

    /// The least nominal error over delays, and the delay \[samples\]; found on one seed, measured on all.
    fn aligned(&self, candidate: &Candidate, nominal: f64) -> (f64, usize) {
        let outputs: Vec<Vec<f64>> = self.nominal.iter().map(|run| outputs(run, candidate)).collect();
        let error = |late: usize| -> f64 {
            let pairs = self.nominal.iter().zip(&outputs);
            pairs.map(|(run, out)| shifted(run.truth(candidate.truth), out, late, run.at_rest.force)).sum()
        };
        let best = (0..=self.longest_delay).min_by(|a, b| error(*a).total_cmp(&error(*b))).unwrap_or(0);
        if best == 0 {
            return (nominal, 0);
        }
        let squares: Vec<f64> = self.nominal.iter().map(|run| self.mean_square(run, candidate, best)).collect();
        (mean(&squares).sqrt(), best)
    }

    /// Phase of what comes out behind the truth at the bandwidth, over the last two of four periods.
    fn lag(&self, candidate: &Candidate) -> f64 {
        let out = outputs(&self.swing, candidate);
        let truth = self.swing.truth(candidate.truth);
        let from = truth.len() / 2;
        let (a, b) = (self.phase(&truth[from..]), self.phase(&out[from..]));
        let turns = (a - b) / std::f64::consts::TAU;
        std::f64::consts::TAU * (turns - turns.round())
    }

    fn phase(&self, series: &[f64]) -> f64 {
        let mean = series.iter().sum::<f64>() / series.len() as f64;
        let omega = std::f64::consts::TAU * self.bandwidth / self.rate;
        let sums = series.iter().enumerate().fold((0.0, 0.0), |(re, im), (index, value)| {
            let (sine, cosine) = (omega * index as f64).sin_cos();
            (re + (value - mean) * cosine, im - (value - mean) * sine)
        });
        f64::atan2(sums.1, sums.0)
    }

    /// On a spring at rest, once the filter has forgotten its beginning.
    fn noise_gain(&self, candidate: &Candidate) -> f64 {
        let run = &self.impact;
        let mut running = candidate.start.start(&run.at_rest);
        let mut random = rand_pcg::Pcg64::new(u128::from(self.seed), 0x6e6f_6973);
        let (mut sum, mut count) = (0.0, 0.0);
        for index in 0..20_000 {
            let mut noisy = run.at_rest;
            noisy.force += self.noise.sample(&mut random);
            let out = running(&noisy) - run.at_rest.force;
            if index >= 4000 {
                sum += out * out;
                count += 1.0;
            }
        }
        f64::sqrt(sum / count) / self.noise.std_dev()
    }

    fn settling(&self, candidate: &Candidate) -> f64 {
        let out = outputs(&self.impact, candidate);
        let bound = 0.1 * self.impact.ringing();
        let truth = self.impact.truth(candidate.truth);
        let last = out.iter().zip(truth).rposition(|(out, truth)| (out - truth).abs() > bound);
        last.map_or(0.0, |last| (last + 1) as f64 / self.rate)
    }
}

/// What a candidate makes of a run without noise.
fn outputs(run: &Run, candidate: &Candidate) -> Vec<f64> {
    let mut running = candidate.start.start(&run.at_rest);
    run.measured.iter().map(running.as_mut()).collect()
}

/// Sum of squares of `out` less `truth` delayed.
fn shifted(truth: &[f64], out: &[f64], late: usize, before: f64) -> f64 {
    let then = |index: usize| index.checked_sub(late).map_or(before, |place| truth[place]);
    out.iter().enumerate().map(|(index, out)| (out - then(index)).powi(2)).sum()
}

fn mean(values: &[f64]) -> f64 {
    values.iter().sum::<f64>() / values.len().max(1) as f64
}

/// Ranks: least worst error first, those of one truth together, filters before estimators.
pub(super) fn order(a: &(Candidate, Judgement), b: &(Candidate, Judgement)) -> std::cmp::Ordering {
    let group = |truth: Truth| truth == Truth::Output;
    group(a.0.truth).cmp(&group(b.0.truth)).then(a.1.worst.total_cmp(&b.1.worst))
}
