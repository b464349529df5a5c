//! What a run over time leaves: forces, command, whether it ran away, and how its ringing grows.
//!
//! Next door: what makes it (`over_time`).

use std::f64::consts::TAU;

use num_complex::Complex64;

/// A run: what was measured and commanded at each sample.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Run {
    /// t \[s\].
    pub time: Vec<f64>,
    /// The force that is fed back, less its mean \[N\].
    pub fed_back: Vec<f64>,
    /// F_i less its mean \[N\].
    pub input: Vec<f64>,
    /// F_o less its mean \[N\].
    pub output: Vec<f64>,
    /// The command (m/s of a velocity source, N of a force source).
    pub command: Vec<f64>,
    /// When a force passed 1e8 N, which ended the run \[s\].
    pub ran_away_at: Option<f64>,
    /// When windings touched, which ended the run \[s\]; looked for only where F_L is read off the windings.
    pub touched_at: Option<f64>,
}

/// Beyond this a loop has run away \[N\], \[m\] or \[m/s\].
const AWAY: f64 = 1e8;
/// Periods that half a window of [`Run::growth`] must hold.
const PERIODS: f64 = 4.0;

/// Below this share of the largest force nothing rings: rounding is left.
const DEAD: f64 = 1e-11;

/// Both ends, the controller's force and what it does.
pub(super) struct Sample {
    pub fed_back: f64,
    pub input: f64,
    pub output: f64,
    pub command: f64,
    pub stroke: f64,
}

/// A run that is being written.
pub(super) struct Record {
    pub run: Run,
    first: f64,
    step: f64,
    samples: usize,
    over: bool,
}

impl Record {
    /// Of so many samples from a first time on, at steps of h \[s\].
    pub fn new(first: f64, step: f64, samples: usize) -> Self {
        let series = || Vec::with_capacity(samples);
        let run = Run {
            time: series(),
            fed_back: series(),
            input: series(),
            output: series(),
            command: series(),
            ..Run::default()
        };
        Self { run, first, step, samples, over: false }
    }

    /// Whether there is a sample to come.
    pub fn goes_on(&self) -> bool {
        !self.over && self.run.time.len() < self.samples
    }

    /// Writes a sample, or that the loop has run away.
    pub fn add(&mut self, sample: Sample) {
        let time = self.time();
        let Sample { fed_back, input, output, command, stroke } = sample;
        let within = |value: f64| value.abs() <= AWAY;
        if ![fed_back, input, output, command, stroke].into_iter().all(within) {
            self.run.ran_away_at = Some(time);
            self.over = true;
            return;
        }
        self.run.time.push(time);
        self.run.fed_back.push(fed_back);
        self.run.input.push(input);
        self.run.output.push(output);
        self.run.command.push(command);
    }

    fn time(&self) -> f64 {
        self.first + self.run.time.len() as f64 * self.step
    }

    /// Windings touch: what comes after is of another model.
    pub fn touched(&mut self) {
        self.run.touched_at = Some(self.time());
        self.over = true;
    }
}

impl Run {
    /// How the ringing at one frequency grows: its size in what is fed back in the last quarter of the run over that in the third \[1\].
    ///
    /// Size: |Σ F_fed(t) w(t) e^(−jωt)| with Hann's window, so that what rings elsewhere, drifts or creeps does not count; nor does what rings outside of
    /// the loop, as F_o does freely where deflection is fed back, at a place below half the rate to which it is folded. Above 1 it grows.
    /// Zero where it has died away to 1e-11 of the largest force, infinite for a run that ended early because it ran away; `None` where a quarter of the run holds fewer than eight periods, too few to
    /// tell, where windings touched, or where nothing rings.
    ///
    /// - `angular_frequency`: ω \[rad/s\], above zero
    ///
    /// Source:   `[Harris1978]`, the Hann window.
    pub fn growth(&self, angular_frequency: f64) -> Option<f64> {
        if self.ran_away_at.is_some() {
            return Some(f64::INFINITY);
        }
        let quarter = self.time.len() / 4;
        let span = self.time.get(quarter).map_or(0.0, |time| time - self.time[0]);
        if self.touched_at.is_some() || span * angular_frequency < 2.0 * PERIODS * TAU {
            return None;
        }
        let [third, last] = [2, 3].map(|part| self.size(angular_frequency, part * quarter, quarter));
        let peak = self.fed_back.iter().fold(0.0_f64, |most, force| most.max(force.abs()));
        if peak > 0.0 && third.max(last) <= DEAD * peak { Some(0.0) } else { (third > 0.0).then(|| last / third) }
    }

    fn size(&self, angular_frequency: f64, from: usize, count: usize) -> f64 {
        let force = &self.fed_back[from..from + count];
        let mean = force.iter().sum::<f64>() / count as f64;
        let each = force.iter().zip(&self.time[from..]).enumerate().map(|(index, (force, time))| {
            let window = 1.0 - (TAU * (index as f64 + 0.5) / count as f64).cos();
            Complex64::from_polar(window * (force - mean), -angular_frequency * time)
        });
        2.0 * each.sum::<Complex64>().norm() / count as f64
    }
}
